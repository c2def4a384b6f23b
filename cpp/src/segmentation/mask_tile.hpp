// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "segmentation/mask_element.hpp"

namespace survtrack::kernels {

/// A part of a mask, one bit a pixel, that is eroded and dilated by elements of any shape. The whole part is one
/// string of bits, with room between its rows and around them for what lies beyond it, which is neutral. Buffers
/// are kept from one part to the next.
class MaskTile {
 public:
  using Word = std::uint64_t;

  /// Room for a part of this size and elements up to this edge. Its pixels are still to be written: `row_words(width)`
  /// words a row, bits beyond `width` are ignored.
  void start(std::size_t width, std::size_t height, std::size_t largest_edge);
  Word* row(std::size_t y) { return bits_.data() + top_words_ + y * row_words_; }
  const Word* row(std::size_t y) const { return bits_.data() + top_words_ + y * row_words_; }

  /// A pixel stays where the element around it lies in the foreground.
  void erode(const MaskElement& element) { filter(element, true); }
  /// A pixel is set where the reflected element around it meets the foreground.
  void dilate(const MaskElement& element) { filter(element, false); }

 private:
  void filter(const MaskElement& element, bool erode);
  void fill_outside(bool ones);
  const Word* windows(const MaskElement::Rectangle& rectangle, bool erode);
  void combine(const Word* from, std::size_t shift, bool erode, bool first);

  std::size_t width_ = 0;
  std::size_t height_ = 0;
  std::size_t row_words_ = 0;
  std::size_t top_words_ = 0;
  std::size_t total_words_ = 0;
  std::vector<Word> bits_;
  std::vector<Word> sums_;  ///< over the element's rectangles
  std::vector<Word> spare_[2];
};

}  // namespace survtrack::kernels
