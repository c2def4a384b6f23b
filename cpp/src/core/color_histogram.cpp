// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "survtrack/core/color_histogram.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

#include "core/check_mask.hpp"
#include "core/text_of.hpp"
#include "survtrack/core/checks.hpp"
#include "survtrack/core/errors.hpp"

namespace survtrack {

void check_histogram(const ColorHistogram& histogram, const std::string& name) {
  double sum = 0.0;
  for (const float part : histogram.parts) {
    if (!(part >= 0.0F)) throw InputError(name + ": has a part that is negative or not finite; expected 0 to 1");
    sum += static_cast<double>(part);
  }
  constexpr double tolerance = 1e-3;
  if (sum == 0.0 || std::abs(sum - 1.0) <= tolerance) return;
  throw InputError(name + ": its parts sum to " + text_of(sum) + "; expected 1, or 0 for no pixels");
}

double histogram_intersection(const ColorHistogram& a, const ColorHistogram& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < ColorHistogram::size; ++i) sum += static_cast<double>(std::min(a.parts[i], b.parts[i]));
  return std::min(sum, 1.0);
}

void refresh(ColorHistogram& reference, const ColorHistogram& seen, double rate) {
  const auto part = static_cast<float>(rate);
  for (std::size_t i = 0; i < ColorHistogram::size; ++i) reference.parts[i] += part * (seen.parts[i] - reference.parts[i]);
}

void ColorCounter::add(const std::uint8_t* pixels, int count, int channels) {
  for (int i = 0; i < count; ++i, pixels += channels) {
    ++counts_[channels == 1 ? ColorHistogram::bin(pixels[0], pixels[0], pixels[0])
                            : ColorHistogram::bin(pixels[0], pixels[1], pixels[2])];
  }
  total_ += count;
}

ColorHistogram ColorCounter::histogram() const {
  ColorHistogram histogram;
  if (total_ == 0) return histogram;
  for (std::size_t i = 0; i < ColorHistogram::size; ++i) {
    histogram.parts[i] = static_cast<float>(static_cast<double>(counts_[i]) / static_cast<double>(total_));
  }
  return histogram;
}

ColorHistogram color_histogram(const cv::Mat& image, const cv::Mat& mask) {
  check_image(image);
  if (!mask.empty()) {
    check_mask(mask);
    if (mask.size() != image.size()) {
      throw InputError("mask: is " + std::to_string(mask.rows) + "x" + std::to_string(mask.cols) + ", the image " +
                       std::to_string(image.rows) + "x" + std::to_string(image.cols) + "; expected the same size");
    }
  }
  ColorCounter counter;
  const int channels = image.channels();
  for (int y = 0; y < image.rows; ++y) {
    const auto* const pixels = image.ptr<std::uint8_t>(y);
    if (mask.empty()) {
      counter.add(pixels, image.cols, channels);
      continue;
    }
    const auto* const inside = mask.ptr<std::uint8_t>(y);
    for (int x = 0; x < image.cols; ++x) {
      if (inside[x] != 0) counter.add(pixels + std::ptrdiff_t{x} * channels, 1, channels);
    }
  }
  return counter.histogram();
}

}  // namespace survtrack
