// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <algorithm>
#include <opencv2/core/types.hpp>
#include <vector>

#include "segmentation/pixel_rect.hpp"
#include "survtrack/core/geometry.hpp"

namespace survtrack {

/// Places whose background stays as it is, row by row.
class KeptPlaces {
 public:
  /// Pixels of one row up to `end` that are all learned or all kept.
  struct Stretch {
    int end;
    bool kept;
  };

  /// The places of a frame.
  void set(const std::vector<Box>& places, const cv::Size& size) {
    width_ = size.width;
    rects_.clear();
    for (const Box& place : places) {
      const cv::Rect rect = pixel_rect(place, size);
      if (!rect.empty()) rects_.push_back(rect);
    }
  }

  /// Goes to a row.
  void enter_row(int y) {
    columns_.clear();
    for (const cv::Rect& rect : rects_) {
      if (y >= rect.y && y < rect.y + rect.height) columns_.emplace_back(rect.x, rect.x + rect.width);
    }
  }

  /// The stretch of that row that begins at x.
  Stretch stretch_at(int x) const {
    Stretch stretch{width_, false};
    for (const cv::Range& kept : columns_) {
      if (x >= kept.end) continue;
      if (x < kept.start) {
        if (!stretch.kept) stretch.end = std::min(stretch.end, kept.start);
      } else {
        stretch = {stretch.kept ? std::max(stretch.end, kept.end) : kept.end, true};
      }
    }
    return stretch;
  }

 private:
  int width_ = 0;
  std::vector<cv::Rect> rects_;
  std::vector<cv::Range> columns_;  ///< of one row
};

}  // namespace survtrack
