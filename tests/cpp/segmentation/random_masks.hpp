// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

namespace survtrack {

/// Foreground of about `percent` in blocks of 1 to `largest_block` pixels, so that large elements find something.
inline cv::Mat random_mask(cv::RNG& random, const cv::Size& size, int percent, int largest_block = 8) {
  const int block = random.uniform(1, largest_block + 1);
  cv::Mat coarse(size.height / block + 1, size.width / block + 1, CV_8UC1), mask;
  random.fill(coarse, cv::RNG::UNIFORM, 0, 100);
  cv::resize(coarse < percent, mask, {}, block, block, cv::INTER_NEAREST);
  return mask(cv::Rect({0, 0}, size)).clone();
}

}  // namespace survtrack
