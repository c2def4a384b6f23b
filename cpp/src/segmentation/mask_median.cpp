// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "segmentation/mask_median.hpp"

#include <algorithm>

#include "core/simd.hpp"

namespace survtrack::kernels {
namespace {

struct BinariseKernel {
  SURVTRACK_SIMD_INLINE void operator()(const std::uint8_t* pixels, std::uint8_t* ones, std::size_t count) const {
    SURVTRACK_SIMD_LOOP
    for (std::size_t i = 0; i < count; ++i) ones[i] = pixels[i] != 0 ? 1 : 0;
  }
};

/// counts += fresh - old.
struct CountKernel {
  SURVTRACK_SIMD_INLINE void operator()(std::uint8_t* counts, const std::uint8_t* fresh, const std::uint8_t* old,
                                        std::size_t count) const {
    SURVTRACK_SIMD_LOOP
    for (std::size_t i = 0; i < count; ++i) counts[i] = static_cast<std::uint8_t>(counts[i] + fresh[i] - old[i]);
  }
};

/// Writes 255 where the `side` counts from a column on are more than half the square. A square of up to
/// 225 pixels is counted in bytes.
template <int side>
struct SmallVoteKernel {
  SURVTRACK_SIMD_INLINE void operator()(const std::uint8_t* counts, std::uint8_t* pixels, std::size_t count) const {
    SURVTRACK_SIMD_LOOP
    for (std::size_t i = 0; i < count; ++i) {
      std::uint8_t sum = counts[i];
      for (int column = 1; column < side; ++column) sum = static_cast<std::uint8_t>(sum + counts[i + column]);
      pixels[i] = sum > side * side / 2 ? 255 : 0;
    }
  }
};

struct VoteKernel {
  SURVTRACK_SIMD_INLINE void operator()(const std::uint8_t* counts, std::size_t side, std::uint16_t* sums,
                                        std::uint8_t* pixels, std::size_t count) const {
    SURVTRACK_SIMD_LOOP
    for (std::size_t i = 0; i < count; ++i) sums[i] = counts[i];
    for (std::size_t column = 1; column < side; column += 2) {
      const std::uint8_t* const next = counts + column;
      SURVTRACK_SIMD_LOOP
      for (std::size_t i = 0; i < count; ++i) sums[i] = static_cast<std::uint16_t>(sums[i] + next[i] + next[i + 1]);
    }
    const auto half = static_cast<std::uint16_t>(side * side / 2);
    SURVTRACK_SIMD_LOOP
    for (std::size_t i = 0; i < count; ++i) pixels[i] = sums[i] > half ? 255 : 0;
  }
};

}  // namespace

void MaskMedian::apply(const MaskView& mask) {
  const std::size_t radius = side_ / 2;
  padded_width_ = mask.width + 2 * radius;
  rows_.assign((side_ + 1) * padded_width_, 0);
  counts_.assign(padded_width_, 0);
  sums_.resize(mask.width);
  // Rows are read half a side before the result is written over them.
  for (std::size_t y = 0; y < mask.height + 2 * radius; ++y) {
    std::uint8_t* const fresh = rows_.data() + (y % (side_ + 1)) * padded_width_;
    const std::uint8_t* const old = rows_.data() + ((y + 1) % (side_ + 1)) * padded_width_;
    load(mask, y < radius ? 0 : std::min(y - radius, mask.height - 1), fresh);
    simd::run<CountKernel>(counts_.data(), fresh, old, padded_width_);
    if (y + 1 >= side_) vote(mask.row(y + 1 - side_), mask.width);
  }
}

void MaskMedian::vote(std::uint8_t* pixels, std::size_t width) {
  const std::uint8_t* const counts = counts_.data();
  switch (side_) {
    case 3: return simd::run<SmallVoteKernel<3>>(counts, pixels, width);
    case 5: return simd::run<SmallVoteKernel<5>>(counts, pixels, width);
    case 7: return simd::run<SmallVoteKernel<7>>(counts, pixels, width);
    default: return simd::run<VoteKernel>(counts, side_, sums_.data(), pixels, width);
  }
}

void MaskMedian::load(const MaskView& mask, std::size_t y, std::uint8_t* row) const {
  const std::size_t radius = side_ / 2;
  simd::run<BinariseKernel>(mask.row(y), row + radius, mask.width);
  std::fill_n(row, radius, row[radius]);
  std::fill_n(row + radius + mask.width, radius, row[radius + mask.width - 1]);
}

}  // namespace survtrack::kernels
