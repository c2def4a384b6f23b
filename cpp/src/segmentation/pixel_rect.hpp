// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <algorithm>
#include <cmath>
#include <opencv2/core/types.hpp>

#include "survtrack/core/geometry.hpp"

namespace survtrack {

/// The pixels of an image that a box covers, wholly or in part; empty when it covers none.
inline cv::Rect pixel_rect(const Box& box, const cv::Size& image) {
  // Written so that a NaN or an infinite edge never reaches the conversion to int.
  const auto inside = [](double edge, int end) {
    return edge > 0.0 ? static_cast<int>(std::min(edge, static_cast<double>(end))) : 0;
  };
  const int left = inside(std::floor(box.x), image.width);
  const int top = inside(std::floor(box.y), image.height);
  const int right = inside(std::ceil(box.right()), image.width);
  const int bottom = inside(std::ceil(box.bottom()), image.height);
  if (!(box.width > 0.0 && box.height > 0.0) || right <= left || bottom <= top) return {};
  return {left, top, right - left, bottom - top};
}

}  // namespace survtrack
