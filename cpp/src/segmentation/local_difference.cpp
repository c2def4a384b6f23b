// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "segmentation/local_difference.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/simd.hpp"

namespace survtrack {
namespace {

/// One row of the frame, and the reference's rows about it.
struct GradientRow {
  const std::uint8_t* frame;
  const std::uint8_t* above;
  const std::uint8_t* here;
  const std::uint8_t* below;
  std::int32_t* products;
  std::int32_t* squares;
  std::size_t width;
};

SURVTRACK_SIMD_INLINE void gradient_at(const GradientRow& row, std::size_t x, std::size_t left, std::size_t right) {
  const int across = row.here[right] - row.here[left];
  const int down = row.below[x] - row.above[x];
  const int square = across * across + down * down;
  const int difference = row.frame[x] - row.here[x];
  // 16 |gradient| with |gradient| = sqrt(square) / 2.
  const int gradient = static_cast<int>(8.0F * std::sqrt(static_cast<float>(square)) + 0.5F);
  row.products[x] = (difference < 0 ? -difference : difference) * gradient;
  row.squares[x] = square;
}

struct GradientKernel {
  SURVTRACK_SIMD_INLINE void operator()(const GradientRow& row) const {
    const GradientRow own = row;
    const std::size_t last = own.width - 1;
    gradient_at(own, 0, 0, std::min<std::size_t>(1, last));
    SURVTRACK_SIMD_LOOP
    for (std::size_t x = 1; x < last; ++x) gradient_at(own, x, x - 1, x + 1);
    if (last > 0) gradient_at(own, last, last - 1, last);
  }
};

struct AddKernel {
  SURVTRACK_SIMD_INLINE void operator()(std::int32_t* sums, const std::int32_t* row, std::int32_t sign,
                                        std::size_t width) const {
    SURVTRACK_SIMD_LOOP
    for (std::size_t x = 0; x < width; ++x) sums[x] += sign * row[x];
  }
};

struct DivideKernel {
  SURVTRACK_SIMD_INLINE void operator()(const std::int32_t* products, const std::int32_t* squares, float constant,
                                        float* values, std::size_t width) const {
    SURVTRACK_SIMD_LOOP
    for (std::size_t x = 0; x < width; ++x) {
      // (products / 16) / (squares / 4 + constant)
      values[x] = static_cast<float>(products[x]) / (4.0F * static_cast<float>(squares[x]) + 16.0F * constant);
    }
  }
};

/// sums[x] = columns[x - reach] + ... + columns[x + reach], as far as there are such.
void sum_across(const std::int32_t* columns, int reach, int width, std::int32_t* sums) {
  std::int32_t sum = 0;
  for (int x = 0; x < std::min(reach, width); ++x) sum += columns[x];
  for (int x = 0; x < width; ++x) {
    if (x + reach < width) sum += columns[x + reach];
    if (x - reach > 0) sum -= columns[x - reach - 1];
    sums[x] = sum;
  }
}

}  // namespace

void LocalDifference::find(const cv::Mat& frame, const cv::Mat& reference, int neighbourhood_px, double constant,
                           cv::Mat& values) {
  const auto width = static_cast<std::size_t>(frame.cols);
  const int height = frame.rows;
  const int reach = neighbourhood_px / 2;
  products_.resize(frame.total());
  squares_.resize(frame.total());
  columns_.assign(2 * width, 0);
  sums_.resize(2 * width);
  values.create(frame.size(), CV_32FC1);
  const auto row_of = [&](std::vector<std::int32_t>& all, int y) { return all.data() + static_cast<std::size_t>(y) * width; };
  for (int y = 0; y < height; ++y) {
    simd::run<GradientKernel>(GradientRow{frame.ptr<std::uint8_t>(y), reference.ptr<std::uint8_t>(std::max(y - 1, 0)),
                                          reference.ptr<std::uint8_t>(y),
                                          reference.ptr<std::uint8_t>(std::min(y + 1, height - 1)),
                                          row_of(products_, y), row_of(squares_, y), width});
  }
  const auto add_row = [&](int y, std::int32_t sign) {
    if (y < 0 || y >= height) return;
    simd::run<AddKernel>(columns_.data(), row_of(products_, y), sign, width);
    simd::run<AddKernel>(columns_.data() + width, row_of(squares_, y), sign, width);
  };
  for (int y = 0; y < reach; ++y) add_row(y, 1);
  for (int y = 0; y < height; ++y) {
    add_row(y + reach, 1);
    add_row(y - reach - 1, -1);
    sum_across(columns_.data(), reach, frame.cols, sums_.data());
    sum_across(columns_.data() + width, reach, frame.cols, sums_.data() + width);
    simd::run<DivideKernel>(sums_.data(), sums_.data() + width, static_cast<float>(constant), values.ptr<float>(y), width);
  }
}

}  // namespace survtrack
