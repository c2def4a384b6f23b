// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <opencv2/core.hpp>
#include <vector>

#include "core/simd.hpp"
#include "segmentation/selective_kernels.hpp"

namespace survtrack {

/// What `selective` knows of each pixel, in arrays that its kernels work on row by row.
class SelectiveMemory {
 public:
  const cv::Size& size() const { return size_; }
  int channels() const { return channels_; }  ///< 0: nothing is known yet

  void allocate(const cv::Size& size, int channels) {
    size_ = size;
    channels_ = channels;
    const auto area = static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height);
    const auto planes = static_cast<std::size_t>(channels);
    // A block more, of which nothing is used: see SelectiveRow.
    levels_.resize(area * (planes + 1) + kernels::selective_block);
    candidates_.resize(area * planes + kernels::selective_block);
    ages_ms_.resize(area + kernels::selective_block);
    colors_.resize(planes * color_stride());
  }
  void forget() { channels_ = 0; }

  /// Row y of the frame, its pixels from `begin` up to `end` taken apart by colours, and what is known of it. The colours
  /// hold until the next call.
  template <int channels>
  kernels::SelectiveRow<channels> row(const cv::Mat& frame, cv::Mat& mask, int y, int begin, int end) {
    constexpr int block = kernels::selective_block;
    const int width = size_.width;
    const auto* const pixels = frame.ptr<std::uint8_t>(y);
    kernels::SelectiveRow<channels> row;
    // Whole blocks, moved to the left where the frame ends.
    const int length = std::min((end - begin + block - 1) / block * block, width);
    const auto first = static_cast<std::size_t>(std::min(begin, width - length));
    const auto count = static_cast<std::size_t>(length);
    if constexpr (channels == 3) {
      for (int c = 0; c < channels; ++c) row.frame[c] = colors_.data() + static_cast<std::size_t>(c) * color_stride();
      std::uint8_t* const blue = colors_.data() + first;
      kernels::split_colors(pixels + 3 * first, blue, blue + color_stride(), blue + 2 * color_stride(), count);
    } else if (end + block <= width) {
      row.frame[0] = pixels;
    } else {
      std::copy_n(pixels + first, count, colors_.data() + first);
      row.frame[0] = colors_.data();
    }
    std::int16_t* const levels = levels_.data() + offset(y, channels + 1);
    std::uint8_t* const candidate = candidates_.data() + offset(y, channels);
    for (int c = 0; c < channels; ++c) {
      row.background[c] = levels + c * width;
      row.candidate[c] = candidate + c * width;
    }
    row.deviation = levels + channels * width;
    row.age_ms = ages_ms_.data() + offset(y, 1);
    row.mask = mask.ptr<std::uint8_t>(y);
    row.count = static_cast<std::size_t>(width);
    return row;
  }

  /// Asks for the memory of the first of these pixels before their turn comes: each row's arrays lie far from the last
  /// row's, and the processor foresees only what follows within a row.
  void fetch(const cv::Mat& frame, const cv::Mat& mask, int y, int begin, int end) const {
    constexpr std::ptrdiff_t line = 64, most = 2 * line;
    const std::ptrdiff_t count = std::min<std::ptrdiff_t>(end - begin, most);
    const auto ask = [](const void* from, std::ptrdiff_t bytes) {
      const auto* const first = static_cast<const char*>(from);
      for (std::ptrdiff_t at = 0; at < bytes + line; at += line) simd::prefetch(first + std::min(at, bytes - 1));
    };
    ask(frame.ptr<std::uint8_t>(y) + std::ptrdiff_t{channels_} * begin, channels_ * count);
    ask(mask.ptr<std::uint8_t>(y) + begin, count);
    const std::int16_t* const levels = levels_.data() + offset(y, channels_ + 1) + begin;
    for (int c = 0; c <= channels_; ++c) ask(levels + std::ptrdiff_t{c} * size_.width, 2 * count);
  }

  /// The background in grey levels or BGR.
  void background(cv::Mat& picture) const {
    picture.create(size_, CV_8UC(channels_));
    for (int y = 0; y < size_.height; ++y) {
      const std::int16_t* const levels = levels_.data() + offset(y, channels_ + 1);
      auto* const pixels = picture.ptr<std::uint8_t>(y);
      for (int x = 0; x < size_.width; ++x) {
        for (int c = 0; c < channels_; ++c) {
          pixels[x * channels_ + c] = static_cast<std::uint8_t>(kernels::rounded_level(levels[c * size_.width + x]));
        }
      }
    }
  }

 private:
  /// Where row y begins in a vector that holds `arrays` numbers a pixel.
  std::size_t offset(int y, int arrays) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(arrays) * static_cast<std::size_t>(size_.width);
  }
  std::size_t color_stride() const { return static_cast<std::size_t>(size_.width) + kernels::selective_block; }

  cv::Size size_;
  int channels_ = 0;
  std::vector<std::int16_t> levels_;      ///< for each row: background by channel, deviation
  std::vector<std::uint8_t> candidates_;  ///< for each row: by channel
  std::vector<std::uint16_t> ages_ms_;
  std::vector<std::uint8_t> colors_;      ///< one row of the frame: blue, green, red
};

}  // namespace survtrack
