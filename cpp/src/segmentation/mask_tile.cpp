// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "segmentation/mask_tile.hpp"

#include <algorithm>
#include <utility>

#include "core/mask_bits.hpp"
#include "segmentation/mask_rows.hpp"
#include "segmentation/mask_window.hpp"

namespace survtrack::kernels {

using mask_bits::word_bits;

namespace {

enum class Combination { assign, keep, add };

/// to = from, to & from or to | from, where a bit of `to` meets the one `shift` bits before it.
template <Combination combination>
struct CombineKernel {
  SURVTRACK_SIMD_INLINE void operator()(std::uint64_t* to, const std::uint64_t* from, std::size_t shift,
                                        std::size_t count) const {
    const Shifted<false> shifted(from, shift);
    SURVTRACK_SIMD_LOOP
    for (std::size_t i = 0; i < count; ++i) {
      const std::uint64_t word = shifted[i];
      to[i] = combination == Combination::assign ? word : combination == Combination::keep ? to[i] & word : to[i] | word;
    }
  }
};

void reserve(std::vector<std::uint64_t>& words, std::size_t count) {
  if (words.size() < count) words.resize(count);
}

}  // namespace

void MaskTile::start(std::size_t width, std::size_t height, std::size_t largest_edge) {
  const std::size_t reach = largest_edge / 2;
  width_ = width;
  height_ = height;
  row_words_ = mask_bits::words_for(width + reach);
  // Results are read up to `reach` rows and columns back, one word more as the shift is not by whole words.
  top_words_ = reach * row_words_ + reach / word_bits + 2;
  // Windows run forwards: what they read beyond the string, and so leave undefined, is less than this.
  constexpr std::size_t most_passes = 16;
  const std::size_t bottom_words = largest_edge * row_words_ + largest_edge / word_bits + most_passes;
  total_words_ = top_words_ + height * row_words_ + bottom_words;
  for (std::vector<Word>* words : {&bits_, &sums_, &spare_[0], &spare_[1]}) reserve(*words, total_words_);
}

void MaskTile::filter(const MaskElement& element, bool erode) {
  if (element.edge < 2) return;
  fill_outside(erode);
  bool first = true;
  for (const MaskElement::Rectangle& rectangle : element.rectangles) {
    // A window starts at its first pixel; reflected, that is the last.
    const std::size_t left = erode ? rectangle.left : rectangle.width - 1 - rectangle.left;
    const std::size_t up = erode ? rectangle.up : rectangle.height - 1 - rectangle.up;
    combine(windows(rectangle, erode), up * row_words_ * word_bits + left, erode, first);
    first = false;
  }
  std::swap(bits_, sums_);
}

void MaskTile::fill_outside(bool ones) {
  const Word neutral = ones ? ~Word{0} : 0;
  std::fill_n(bits_.begin(), top_words_, neutral);
  const std::size_t end = top_words_ + height_ * row_words_;
  std::fill(bits_.begin() + static_cast<std::ptrdiff_t>(end),
            bits_.begin() + static_cast<std::ptrdiff_t>(total_words_), neutral);
  const std::size_t whole = width_ / word_bits;
  if (whole == row_words_) return;
  const Word inside = mask_bits::low_bits(width_ % word_bits);
  for (std::size_t y = 0; y < height_; ++y) {
    Word* const words = row(y);
    words[whole] = (words[whole] & inside) | (neutral & ~inside);
    for (std::size_t i = whole + 1; i < row_words_; ++i) words[i] = neutral;
  }
}

/// Over the rectangle that starts at each pixel. Spans triple until they are the side.
const MaskTile::Word* MaskTile::windows(const MaskElement::Rectangle& rectangle, bool erode) {
  const Word* from = bits_.data();
  std::size_t next = 0;
  const auto widen = [&](std::size_t side, std::size_t step) {
    for (std::size_t span = 1; span < side;) {
      const std::size_t far = std::min(2 * span, side - span);
      Word* const to = spare_[next].data();
      const std::size_t count = total_words_ - (far * step / word_bits + 1);
      run_window(erode, true, {to, from, count, std::min(span, far) * step, far * step});
      from = to;
      next = 1 - next;
      span += far;
    }
  };
  widen(rectangle.width, 1);
  widen(rectangle.height, row_words_ * word_bits);
  return from;
}

void MaskTile::combine(const Word* from, std::size_t shift, bool erode, bool first) {
  Word* const to = sums_.data() + top_words_;
  const Word* const begin = from + top_words_;
  const std::size_t count = height_ * row_words_;
  if (first) {
    simd::run<CombineKernel<Combination::assign>>(to, begin, shift, count);
  } else if (erode) {
    simd::run<CombineKernel<Combination::keep>>(to, begin, shift, count);
  } else {
    simd::run<CombineKernel<Combination::add>>(to, begin, shift, count);
  }
}

}  // namespace survtrack::kernels
