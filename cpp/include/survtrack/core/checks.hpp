// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <opencv2/core/mat.hpp>
#include <optional>

namespace survtrack {

/// Refuses what is not an 8-bit image of 1 or 3 channels (HxW grey or HxWx3 BGR) with at least one
/// pixel, in an `InputError` that says what came. Strided views are fine.
void check_image(const cv::Mat& image, const char* name = "frame");

/// Also refuses an image whose size or channel count is not that of the frames before.
void check_same_format(const cv::Mat& image, const cv::Size& size, int channels, const char* name = "frame");

/// Refuses a time that is not finite, or not later than the one before, if there was one.
void check_time(double time_s, std::optional<double> previous_time_s);

}  // namespace survtrack
