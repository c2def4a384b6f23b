// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <opencv2/core/mat.hpp>

#include "survtrack/core/checks.hpp"
#include "survtrack/core/errors.hpp"

namespace survtrack {

/// Refuses what is not an 8-bit image of one channel with at least one pixel, in an `InputError`.
inline void check_mask(const cv::Mat& mask) {
  check_image(mask, "mask");
  if (mask.channels() != 1) throw InputError("mask: has 3 channels; expected HxW uint8");
}

}  // namespace survtrack
