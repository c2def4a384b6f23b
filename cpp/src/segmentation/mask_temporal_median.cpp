// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "segmentation/mask_temporal_median.hpp"

#include <algorithm>
#include <bit>

#include "core/simd.hpp"
#include "segmentation/mask_rows.hpp"

namespace survtrack::kernels {
namespace {

using Word = std::uint64_t;
constexpr std::size_t block_words = 128;

/// A part of all planes, up to `block_words` words; `stride` words lie between planes.
struct Block {
  Word* counts;
  std::size_t stride;
  std::size_t planes;
  Word* fresh;
  Word* oldest;
  std::size_t least;  ///< count that makes a pixel foreground
  std::size_t count;
};

/// counts += fresh - oldest, oldest = fresh, fresh = (counts >= least).
struct CountKernel {
  SURVTRACK_SIMD_INLINE void operator()(const Block& block) const {
    Word up[block_words], down[block_words], enough[block_words];
    const std::size_t count = block.count;
    Word* const fresh = block.fresh;
    Word* const oldest = block.oldest;
    SURVTRACK_SIMD_LOOP
    for (std::size_t i = 0; i < count; ++i) {
      up[i] = fresh[i] & ~oldest[i];
      down[i] = oldest[i] & ~fresh[i];
      oldest[i] = fresh[i];
      enough[i] = ~Word{0};  // equal so far
    }
    for (std::size_t plane = 0; plane < block.planes; ++plane) {
      Word* const bits = block.counts + plane * block.stride;
      const Word least = (block.least >> plane & 1) != 0 ? ~Word{0} : 0;
      SURVTRACK_SIMD_LOOP
      for (std::size_t i = 0; i < count; ++i) {
        const Word old = bits[i];
        const Word now = old ^ (up[i] | down[i]);
        bits[i] = now;
        up[i] &= old;     // carries
        down[i] &= ~old;  // borrows
        // A higher bit decides over all lower ones.
        enough[i] = (now & ~least) | (enough[i] & ~(now ^ least));
      }
    }
    SURVTRACK_SIMD_LOOP
    for (std::size_t i = 0; i < count; ++i) fresh[i] = enough[i];
  }
};

}  // namespace

MaskTemporalMedian::MaskTemporalMedian(int frames)
    : frames_(static_cast<std::size_t>(frames)), planes_(static_cast<std::size_t>(std::bit_width(frames_))) {}

void MaskTemporalMedian::start(const MaskView& mask) {
  width_ = mask.width;
  height_ = mask.height;
  row_words_ = mask_bits::words_for(width_);
  const std::size_t words = row_words_ * height_;
  oldest_ = 0;
  masks_.assign(frames_ * words, 0);
  counts_.assign(planes_ * words, 0);
  fresh_.assign(words + 1, 0);
}

void MaskTemporalMedian::apply(const MaskView& mask) {
  if (empty()) start(mask);
  seen_ = std::min(seen_ + 1, frames_);
  const std::size_t words = row_words_ * height_;
  for (std::size_t y = 0; y < height_; ++y) mask_bits::pack_row(mask.row(y), width_, fresh_.data() + y * row_words_);
  for (std::size_t i = 0; i < words; i += block_words) {
    simd::run<CountKernel>(Block{counts_.data() + i, words, planes_, fresh_.data() + i,
                                 masks_.data() + oldest_ * words + i, seen_ / 2 + 1, std::min(block_words, words - i)});
  }
  oldest_ = (oldest_ + 1) % frames_;
  for (std::size_t y = 0; y < height_; ++y) {
    mask_bits::unpack_row(fresh_.data() + y * row_words_, 0, mask.row(y), width_);
  }
}

}  // namespace survtrack::kernels
