// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <string>

namespace survtrack {

/// What part of an object's pixels has which colour: 8 x 8 x 8 bins over blue, green and red, 32 levels wide each, blue
/// the slowest. The parts sum to 1, or are all 0 where there were no pixels. Grey pixels have three equal channels.
struct ColorHistogram {
  static constexpr int bins = 8;  ///< a channel
  static constexpr std::size_t size = 512;

  std::array<float, size> parts{};

  static constexpr std::size_t bin(std::uint8_t blue, std::uint8_t green, std::uint8_t red) {
    return static_cast<std::size_t>((blue >> 5) * 64 + (green >> 5) * 8 + (red >> 5));
  }

  friend bool operator==(const ColorHistogram& a, const ColorHistogram& b) { return a.parts == b.parts; }
};

/// Throws `InputError` that begins with `name`, for a part that is negative or not finite, and for a sum that is not 1 or 0
/// to within 0.001.
void check_histogram(const ColorHistogram& histogram, const std::string& name);

/// The sum of the smaller parts of each bin (Swain and Ballard 1991): 1 for equal colours, 0 for none in common.
double histogram_intersection(const ColorHistogram& a, const ColorHistogram& b);

/// Moves `reference` towards `seen` by `rate`, 0 to 1.
void refresh(ColorHistogram& reference, const ColorHistogram& seen, double rate);

/// Counts pixels into bins, and makes a histogram of the counts.
class ColorCounter {
 public:
  /// `count` neighbouring pixels of 1 or 3 channels.
  void add(const std::uint8_t* pixels, int count, int channels);
  ColorHistogram histogram() const;

 private:
  std::array<std::int32_t, ColorHistogram::size> counts_{};
  std::int64_t total_ = 0;
};

/// Of the pixels where `mask` (CV_8UC1) is not 0; an empty mask: of all. Throws `InputError` for what is no image, or
/// a mask of another size.
ColorHistogram color_histogram(const cv::Mat& image, const cv::Mat& mask = {});

}  // namespace survtrack
