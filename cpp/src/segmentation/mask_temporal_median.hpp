// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "segmentation/mask_view.hpp"

namespace survtrack::kernels {

/// Median over time of masks of one size, in place: a pixel becomes what it was in more than half of the last
/// `frames` masks, of the first ones in more than half of those there are. A tie, which only an even number of first
/// masks can have, is background.
///
/// Counts are kept as planes of bits, 64 pixels a word, and change by the mask that comes and the one that leaves:
/// the work grows with the number of bits of a count only. Keeps one bit a pixel of each of the last masks.
class MaskTemporalMedian {
 public:
  explicit MaskTemporalMedian(int frames);

  /// All masks since `reset` are of one size.
  void apply(const MaskView& mask);
  void reset() { seen_ = 0; }

  bool empty() const { return seen_ == 0; }
  std::size_t width() const { return width_; }
  std::size_t height() const { return height_; }

 private:
  using Word = std::uint64_t;
  void start(const MaskView& mask);

  std::size_t frames_;
  std::size_t planes_;
  std::size_t width_ = 0;
  std::size_t height_ = 0;
  std::size_t row_words_ = 0;
  std::size_t seen_ = 0;           ///< masks since the start, at most `frames`
  std::size_t oldest_ = 0;         ///< whose place the next mask takes
  std::vector<Word> masks_;        ///< the last masks, a ring
  std::vector<Word> counts_;       ///< planes, the lowest bits first
  std::vector<Word> fresh_;        ///< the mask that comes, later the result; a word more than the mask
};

}  // namespace survtrack::kernels
