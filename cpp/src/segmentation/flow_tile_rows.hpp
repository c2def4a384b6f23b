// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>

#include "core/simd.hpp"
#include "segmentation/flow_plane.hpp"

/// The memory of a flow pass: the rows of a tile of columns that are alive at once.
namespace survtrack::kernels {

/// Columns beside a tile that are computed with it: its last sweep depends on one more for each sweep before.
constexpr std::ptrdiff_t halo(int sweeps) { return whole_blocks(sweeps - 1); }

/// The next length of rows at which none of the rows that are written and read together lie so alike in their
/// pages that a load would wait for a store.
inline std::ptrdiff_t unlike_lengths(std::ptrdiff_t floats) {
  constexpr std::ptrdiff_t page = 4096 / 64;
  const auto alike = [](std::ptrdiff_t lines) {
    for (std::ptrdiff_t k = 1; k <= 8; ++k) {
      const std::ptrdiff_t apart = k * lines % page;
      if (apart < 4 || apart > page - 4) return true;
    }
    return false;
  };
  std::ptrdiff_t lines = floats / 16;
  while (alike(lines)) ++lines;
  return 16 * lines;
}

/// The rows of a tile that are alive at once, when `together` rows of a sweep are made together; `front`: the
/// first row that is now being derived. Column x of the image is at `...[x]` of a row.
template <int together>
class TileRows {
 public:
  TileRows(float* memory, int sweeps, std::ptrdiff_t tile_columns, std::ptrdiff_t left)
      : origin_(memory + halo(sweeps) + flow_block - left), length_(length(sweeps, tile_columns)),
        field_rows_(2 * sweeps + together), derived_rows_(sweeps + together) {}

  static std::ptrdiff_t length(int sweeps, std::ptrdiff_t tile_columns) {
    return unlike_lengths(tile_columns + 2 * (halo(sweeps) + flow_block));
  }
  static std::ptrdiff_t count(int sweeps) {
    return 2 * image_rows + 2 * (2 * sweeps + together) + 3 * (sweeps + together);
  }

  SURVTRACK_SIMD_INLINE void advance(std::ptrdiff_t front) {
    front_ = front;
    front_field_ = front % field_rows_;
    front_derived_ = front % derived_rows_;
  }
  SURVTRACK_SIMD_INLINE float* image(int which, std::ptrdiff_t y) const {
    return row(which * image_rows + y % image_rows);
  }
  SURVTRACK_SIMD_INLINE float* derivative(int which, std::ptrdiff_t y) const {
    return row(2 * image_rows + which * derived_rows_ + wrapped(front_derived_ + y - front_, derived_rows_));
  }
  /// A sweep's row y takes the place of row y - 1 of the sweep before, which nobody needs any more.
  SURVTRACK_SIMD_INLINE float* field(int which, int sweep, std::ptrdiff_t y) const {
    return row(2 * image_rows + 3 * derived_rows_ + which * field_rows_ +
               wrapped(front_field_ + y - front_ - sweep, field_rows_));
  }

 private:
  static constexpr int image_rows = together + 2;
  /// A remainder, of numbers that are not far away: a division takes as long as many pixels.
  SURVTRACK_SIMD_INLINE static std::ptrdiff_t wrapped(std::ptrdiff_t index, std::ptrdiff_t count) {
    return index < 0 ? index + count : index >= count ? index - count : index;
  }
  SURVTRACK_SIMD_INLINE float* row(std::ptrdiff_t index) const { return origin_ + index * length_; }

  float* origin_;
  std::ptrdiff_t length_;
  std::ptrdiff_t field_rows_;
  std::ptrdiff_t derived_rows_;
  std::ptrdiff_t front_ = 0;
  std::ptrdiff_t front_field_ = 0;
  std::ptrdiff_t front_derived_ = 0;
};

}  // namespace survtrack::kernels
