// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <opencv2/core/types.hpp>
#include <vector>

namespace survtrack {

/// The pixels of a frame that are read: rectangles and at most one strip that is refreshed, each pixel once.
class ReadPlan {
 public:
  /// Neighbouring pixels of a row.
  struct Span {
    int begin;
    int end;       ///< one beyond
    bool refresh;  ///< of the strip, outside of the rectangles
  };
  /// Rows with the same spans: those from `first_span` up to `last_span`, one beyond.
  struct Band {
    int top;
    int bottom;  ///< one beyond
    std::size_t first_span;
    std::size_t last_span;
  };

  /// Starts a plan of a frame of this size that reads nothing.
  void clear(const cv::Size& size);
  /// Starts a plan that reads everything.
  void read_whole(const cv::Size& size);
  /// Adds a rectangle; what lies outside of the frame is left out.
  void add(const cv::Rect& rect);
  /// The rows from `top` up to `bottom` were last read so long ago.
  void refresh(int top, int bottom, double elapsed_s);
  /// Ends the plan.
  void finish();

  const cv::Size& size() const { return size_; }
  bool whole() const { return whole_; }
  /// From top to bottom; rows in no band are not read.
  const std::vector<Band>& bands() const { return bands_; }
  /// Those of all bands, from left to right in each.
  const std::vector<Span>& spans() const { return spans_; }
  std::int64_t pixels() const { return pixels_; }
  /// What it takes to read them, in pixels: each piece of a row costs `piece_cost_px` more than its pixels.
  std::int64_t cost_px() const { return pixels_ + piece_cost_px * pieces_; }
  /// What it takes to read a whole frame.
  static std::int64_t whole_cost_px(const cv::Size& size);
  /// To begin in a new place takes `selective` as long as this many pixels; measured, see docs/regions.md.
  static constexpr std::int64_t piece_cost_px = 64;
  double refresh_elapsed_s() const { return elapsed_s_; }

 private:
  void add_band(int top, int bottom);

  cv::Size size_;
  bool whole_ = false;
  std::vector<cv::Rect> rects_;
  cv::Range strip_{0, 0};
  double elapsed_s_ = 0.0;
  std::vector<int> edges_;
  std::vector<cv::Range> row_;  ///< of the rectangles in a band
  std::vector<Band> bands_;
  std::vector<Span> spans_;
  std::int64_t pixels_ = 0;
  std::int64_t pieces_ = 0;  ///< spans of all rows
};

}  // namespace survtrack
