// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "segmentation/mask_view.hpp"

namespace survtrack::kernels {

/// Median of a mask over a square of odd side up to 31, in place: each pixel becomes what most pixels
/// of its square are, 0 or 255. Beyond the border the nearest pixel counts. Running counts down the
/// columns, so that a row costs one pass and `side` additions along it.
class MaskMedian {
 public:
  explicit MaskMedian(int side) : side_(static_cast<std::size_t>(side)) {}

  void apply(const MaskView& mask);

 private:
  void vote(std::uint8_t* pixels, std::size_t width);
  void load(const MaskView& mask, std::size_t y, std::uint8_t* row) const;

  std::size_t side_;
  std::size_t padded_width_ = 0;
  std::vector<std::uint8_t> rows_;     ///< the last `side` + 1 rows as 0 and 1, padded
  std::vector<std::uint8_t> counts_;   ///< foreground pixels a column over the last `side`
  std::vector<std::uint16_t> sums_;    ///< over the squares
};

}  // namespace survtrack::kernels
