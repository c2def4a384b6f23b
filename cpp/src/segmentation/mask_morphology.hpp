// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "segmentation/mask_view.hpp"

namespace survtrack::kernels {

/// Opening (erosion, then dilation) or closing (the reverse) of a mask by a square of odd side of at
/// least 3, in place; the result is 0 or 255. The border takes no part: what lies beyond it counts as
/// foreground when an opening erodes, so that objects leaving the image keep their shape, and as
/// background to a closing, so that no gap between an object and the border is filled.
///
/// Works on one bit a pixel, with the whole image as one string of bits: a step along the rows shifts
/// the string, a step down shifts it by whole words, and spans triple until they are the side.
/// Margins between the rows keep them apart. Buffers are kept from one image to the next.
class MaskMorphology {
 public:
  enum class Operation { opening, closing };
  MaskMorphology(Operation operation, int side);

  void apply(const MaskView& mask);

 private:
  using Word = std::uint64_t;

  void start(const MaskView& mask);
  void pack(const MaskView& mask);
  void unpack(const MaskView& mask) const;
  void clear_outside();
  void filter(bool erode, bool forwards);
  Word* row(std::size_t y) { return bits_.data() + (margin_rows() + y) * row_words_; }
  const Word* row(std::size_t y) const { return bits_.data() + (margin_rows() + y) * row_words_; }
  /// Rows above and below the image: a window reaches side - 1, and what is found in the outermost two
  /// rows is not valid, as it would depend on bits beyond the string.
  std::size_t margin_rows() const { return side_ + 1; }

  Operation operation_;
  std::size_t side_;
  std::size_t width_ = 0;
  std::size_t height_ = 0;
  std::size_t row_words_ = 0;
  std::vector<Word> bits_;
  std::vector<Word> spare_;
};

}  // namespace survtrack::kernels
