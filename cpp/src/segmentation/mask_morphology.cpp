// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "segmentation/mask_morphology.hpp"

#include <algorithm>
#include <utility>

#include "core/mask_bits.hpp"
#include "segmentation/mask_window.hpp"

namespace survtrack::kernels {

using mask_bits::word_bits;

MaskMorphology::MaskMorphology(Operation operation, int side)
    : operation_(operation), side_(static_cast<std::size_t>(side)) {}

void MaskMorphology::apply(const MaskView& mask) {
  const bool opening = operation_ == Operation::opening;
  start(mask);
  pack(mask);
  // The first filter leaves its result for the square centred on a pixel half a side before it; the
  // second, run backwards, brings it back.
  filter(opening, true);
  if (opening) clear_outside();
  filter(!opening, false);
  unpack(mask);
}

/// All that is not the image gets the value of what lies beyond its border.
void MaskMorphology::start(const MaskView& mask) {
  width_ = mask.width;
  height_ = mask.height;
  row_words_ = (width_ + side_ - 1 + word_bits - 1) / word_bits;
  const std::size_t words = (height_ + 2 * margin_rows()) * row_words_;
  bits_.assign(words, operation_ == Operation::opening ? ~Word{0} : 0);
  spare_.resize(words);
}

void MaskMorphology::pack(const MaskView& mask) {
  const std::size_t whole = width_ / word_bits;
  const std::size_t tail = width_ % word_bits;
  for (std::size_t y = 0; y < height_; ++y) {
    const std::uint8_t* const pixels = mask.row(y);
    Word* const words = row(y);
    for (std::size_t i = 0; i < whole; ++i) words[i] = mask_bits::pack_word(pixels + i * word_bits);
    if (tail == 0) continue;
    const Word beyond = words[whole] & ~mask_bits::low_bits(tail);
    words[whole] = mask_bits::pack_tail(pixels + whole * word_bits, tail) | beyond;
  }
}

void MaskMorphology::unpack(const MaskView& mask) const {
  const std::size_t whole = width_ / word_bits;
  const std::size_t tail = width_ % word_bits;
  for (std::size_t y = 0; y < height_; ++y) {
    std::uint8_t* const pixels = mask.row(y);
    const Word* const words = row(y);
    for (std::size_t i = 0; i < whole; ++i) mask_bits::unpack_word(words[i], pixels + i * word_bits);
    if (tail > 0) mask_bits::unpack_tail(words[whole], pixels + whole * word_bits, tail);
  }
}

/// Leaves the eroded squares whose centres are in the image, which now stand half a side before them.
void MaskMorphology::clear_outside() {
  const std::size_t radius = side_ / 2;
  const std::size_t first = (margin_rows() - radius) * row_words_ * word_bits - radius;  // as a bit of the string
  const std::size_t row_bits = row_words_ * word_bits;
  const auto clear = [this](std::size_t begin, std::size_t end) {
    for (std::size_t bit = begin; bit < end;) {
      const std::size_t next = std::min(end, (bit / word_bits + 1) * word_bits);
      bits_[bit / word_bits] &= ~(mask_bits::low_bits(next - bit) << (bit % word_bits));
      bit = next;
    }
  };
  clear(0, first);
  for (std::size_t y = 0; y < height_; ++y) clear(first + y * row_bits + width_, first + (y + 1) * row_bits);
  clear(first + height_ * row_bits, bits_.size() * word_bits);
}

void MaskMorphology::filter(bool erode, bool forwards) {
  const auto pass = [&](std::size_t near, std::size_t far) {
    const std::size_t reach = far / word_bits + 1;
    const std::size_t begin = forwards ? 0 : reach;
    run_window(erode, forwards, {spare_.data() + begin, bits_.data() + begin, bits_.size() - reach, near, far});
    std::swap(bits_, spare_);
  };
  for (const std::size_t step : {std::size_t{1}, row_words_ * word_bits}) {
    for (std::size_t span = 1; span < side_;) {
      const std::size_t far = std::min(2 * span, side_ - span);
      pass(std::min(span, far) * step, far * step);
      span += far;
    }
  }
}

}  // namespace survtrack::kernels
