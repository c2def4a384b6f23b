// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <vector>

namespace survtrack {

/// The locally normalised difference of two pictures of one level (Nashenda 2011, eq. 3). Products and sums are
/// integers, with gradients in 1/16 grey level a pixel: the same bytes on every CPU.
class LocalDifference {
 public:
  /// `values` (CV_32FC1): for each pixel x the sum over the square N about it, as far as it lies in the picture, of
  /// |s(k) - s(r)| |grad s(r)|, divided by that of |grad s(r)|^2 plus `constant`; px. The gradient is by central
  /// differences, (s(x + 1) - s(x - 1)) / 2, with the last pixel again beyond the border.
  /// `frame` and `reference`: CV_8UC1 of one size.
  void find(const cv::Mat& frame, const cv::Mat& reference, int neighbourhood_px, double constant, cv::Mat& values);

 private:
  std::vector<std::int32_t> products_;  ///< |difference| |gradient|, in 1/16, of all pixels
  std::vector<std::int32_t> squares_;   ///< |gradient|^2, in 1/4
  std::vector<std::int32_t> columns_;   ///< sums over the rows of N: products, then squares
  std::vector<std::int32_t> sums_;      ///< those over N, of one row
};

}  // namespace survtrack
