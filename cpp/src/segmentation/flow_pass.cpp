// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "segmentation/flow_pass.hpp"

#include <algorithm>

#include "core/simd.hpp"
#include "segmentation/flow_derivatives.hpp"
#include "segmentation/flow_sweep.hpp"
#include "segmentation/flow_tile_rows.hpp"

namespace survtrack::kernels {
namespace {

/// All sweeps of a pass over one tile, as a wave: when rows of one sweep are due, the rows around them of the
/// sweep before have just been made and lie in the cache. Each sweep works a row behind the one before.
template <std::size_t lanes, int together>
class Wave {
 public:
  SURVTRACK_SIMD_INLINE Wave(const FlowPass& pass, const TileRows<together>& rows, std::ptrdiff_t left,
                             std::ptrdiff_t right)
      : pass_(pass), rows_(rows), left_(left), right_(right),
        wide_left_(std::max<std::ptrdiff_t>(left - halo(pass.sweeps), 0)),
        wide_right_(std::min(right + halo(pass.sweeps), whole_blocks(pass.width))) {}

  SURVTRACK_SIMD_INLINE void run() {
    if (pass_.derive) load(0);
    const std::ptrdiff_t behind = pass_.sweeps - 1;
    for (std::ptrdiff_t front = 0; front - behind < pass_.height; front += together) {
      rows_.advance(front);
      if (pass_.derive) {
        for (std::ptrdiff_t y = front; y < front + together; ++y) load(y + 1);
        for (std::ptrdiff_t y = front; y < front + together; ++y) derive(y);
      }
      for (int sweep = 1; sweep <= pass_.sweeps; ++sweep) make_rows(sweep, front - (sweep - 1));
      for (std::ptrdiff_t y = front - behind; y < front - behind + together; ++y) deliver(y);
    }
  }

 private:
  SURVTRACK_SIMD_INLINE bool inside(std::ptrdiff_t y) const { return y >= 0 && y < pass_.height; }
  /// The row itself, or the image's row next to it.
  SURVTRACK_SIMD_INLINE std::ptrdiff_t nearest(std::ptrdiff_t y) const {
    return std::clamp<std::ptrdiff_t>(y, 0, pass_.height - 1);
  }

  SURVTRACK_SIMD_INLINE void load(std::ptrdiff_t y) const {
    if (!inside(y)) return;
    const std::ptrdiff_t left = std::max<std::ptrdiff_t>(wide_left_ - 1, 0);
    load_images(pass_, y, left, wide_right_ + 1, rows_.image(0, y), rows_.image(1, y));
  }

  SURVTRACK_SIMD_INLINE float* normalised(int which, std::ptrdiff_t y) const {
    FlowPlane* const kept = pass_.normalised[which];
    return kept != nullptr ? kept->row(y) : rows_.derivative(which, y);
  }

  SURVTRACK_SIMD_INLINE void derive(std::ptrdiff_t y) const {
    if (!inside(y)) return;
    const std::ptrdiff_t above = nearest(y - 1);
    const std::ptrdiff_t below = nearest(y + 1);
    const ThreeRows sum{rows_.image(0, above), rows_.image(0, y), rows_.image(0, below)};
    const ThreeRows difference{rows_.image(1, above), rows_.image(1, y), rows_.image(1, below)};
    float* const to[3] = {normalised(0, y), normalised(1, y), normalised(2, y)};
    if (pass_.derivatives == Derivatives::sobel) {
      derive_row<SobelDerivatives>(pass_, y, sum, difference, to, wide_left_, wide_right_);
    } else {
      derive_row<CubeDerivatives>(pass_, y, sum, difference, to, wide_left_, wide_right_);
    }
  }

  /// Rows y to y + together - 1 as far as they are in the image: all at once, or else one by one.
  SURVTRACK_SIMD_INLINE void make_rows(int sweep, std::ptrdiff_t y) const {
    if (y >= 0 && y + together <= pass_.height) {
      make<together>(sweep, y);
      return;
    }
    for (std::ptrdiff_t one = y; one < y + together; ++one) {
      if (inside(one)) make<1>(sweep, one);
    }
  }

  SURVTRACK_SIMD_INLINE const float* before(int which, int sweep, std::ptrdiff_t y) const {
    if (sweep > 1) return rows_.field(which, sweep - 1, nearest(y));
    return which == 0 ? pass_.from->u.row(nearest(y)) : pass_.from->v.row(nearest(y));
  }

  template <int count>
  SURVTRACK_SIMD_INLINE void make(int sweep, std::ptrdiff_t y) const {
    const bool last = sweep == pass_.sweeps;
    const std::ptrdiff_t left = last ? left_ : wide_left_;
    const std::ptrdiff_t right = last ? right_ : wide_right_;
    const bool from_zeros = sweep == 1 && pass_.from == nullptr;
    SweepRows<count> r;
    r.count = right - left;
    for (int i = 0; i < count; ++i) {
      r.a[i] = normalised(0, y + i) + left;
      r.b[i] = normalised(1, y + i) + left;
      r.c[i] = normalised(2, y + i) + left;
      r.new_u[i] = rows_.field(0, sweep, y + i) + left;
      r.new_v[i] = rows_.field(1, sweep, y + i) + left;
      if (from_zeros) sweep_zeros(r.a[i], r.b[i], r.c[i], r.new_u[i], r.new_v[i], r.count);
    }
    if (!from_zeros) {
      for (int i = 0; i < count + 2; ++i) {
        r.u[i] = before(0, sweep, y + i - 1) + left;
        r.v[i] = before(1, sweep, y + i - 1) + left;
      }
      kernels::sweep<lanes, count>(r);
    }
    for (int i = 0; i < count; ++i) finish(sweep, y + i, from_zeros);
  }

  SURVTRACK_SIMD_INLINE void finish(int sweep, std::ptrdiff_t y, bool from_zeros) const {
    const std::ptrdiff_t right = std::min(right_, pass_.width);
    for (int which = 0; which < 2; ++which) {
      float* const row = rows_.field(which, sweep, y);
      if (wide_left_ == 0) row[-1] = row[0];
      if (wide_right_ >= pass_.width) row[pass_.width] = row[pass_.width - 1];
      if (pass_.largest_change == nullptr) continue;
      float& largest = pass_.largest_change[sweep - 1];
      const float* const old = from_zeros ? nullptr : before(which, sweep, y) + left_;
      largest = largest_change(old, row + left_, right - left_, largest);
    }
  }

  SURVTRACK_SIMD_INLINE void deliver(std::ptrdiff_t y) const {
    if (!inside(y)) return;
    const std::ptrdiff_t right = std::min(right_, pass_.width);
    const std::ptrdiff_t first = pass_.to.margins && left_ == 0 ? -1 : left_;
    const std::ptrdiff_t end = pass_.to.margins && right == pass_.width ? right + 1 : right;
    for (int which = 0; which < 2; ++which) {
      float* const to = which == 0 ? pass_.to.u + y * pass_.to.u_stride : pass_.to.v + y * pass_.to.v_stride;
      std::copy(rows_.field(which, pass_.sweeps, y) + first, rows_.field(which, pass_.sweeps, y) + end, to + first);
    }
  }

  const FlowPass& pass_;
  TileRows<together> rows_;
  std::ptrdiff_t left_;  ///< the tile's columns, the last ones in a whole block
  std::ptrdiff_t right_;
  std::ptrdiff_t wide_left_;  ///< with those beside it that are computed too
  std::ptrdiff_t wide_right_;
};

template <std::size_t lanes, int together>
SURVTRACK_SIMD_INLINE void run_tiles(const FlowPass& pass, std::ptrdiff_t tile_columns, float* memory) {
  for (std::ptrdiff_t left = 0; left < pass.width; left += tile_columns) {
    const TileRows<together> rows(memory, pass.sweeps, tile_columns, left);
    Wave<lanes, together>(pass, rows, left, std::min(left + tile_columns, whole_blocks(pass.width))).run();
  }
}

/// Floats in a register.
constexpr std::size_t lanes_of(simd::Level level) {
  return level == simd::Level::avx512 ? 16 : level == simd::Level::avx2 ? 8 : 4;
}

// Two rows together load less, where there are registers for them.
constexpr int most_together = 2;

template <simd::Level level>
struct PassKernel {
  SURVTRACK_SIMD_INLINE void operator()(const FlowPass& pass, std::ptrdiff_t tile_columns, float* memory) const {
    constexpr int together = level == simd::Level::avx512 ? most_together : 1;
    run_tiles<lanes_of(level), together>(pass, tile_columns, memory);
  }
};

/// One row at a time: the second of two would overwrite what the change of the first is measured by.
template <simd::Level level>
struct MeasuringPassKernel {
  SURVTRACK_SIMD_INLINE void operator()(const FlowPass& pass, std::ptrdiff_t tile_columns, float* memory) const {
    run_tiles<lanes_of(level), 1>(pass, tile_columns, memory);
  }
};

struct MaskKernel {
  SURVTRACK_SIMD_INLINE void operator()(const float* u, const float* v, float threshold, std::uint8_t* mask,
                                        std::size_t count) const {
    const float threshold2 = threshold * threshold;
    SURVTRACK_SIMD_LOOP
    for (std::size_t i = 0; i < count; ++i) mask[i] = u[i] * u[i] + v[i] * v[i] > threshold2 ? 255 : 0;
  }
};

}  // namespace

void run_flow_pass(const FlowPass& pass, AlignedFloats& memory) {
  std::ptrdiff_t columns = whole_blocks(pass.tile_columns);
  if (columns <= 0) {
    const std::ptrdiff_t tiles = (pass.width + most_tile_columns - 1) / most_tile_columns;
    columns = whole_blocks((pass.width + tiles - 1) / tiles);
  }
  using Rows = TileRows<most_together>;
  const std::ptrdiff_t needed = Rows::count(pass.sweeps) * Rows::length(pass.sweeps, columns);
  float* const floats = memory.at_least(static_cast<std::size_t>(needed));
  if (pass.largest_change == nullptr) {
    simd::run_for_level<PassKernel>(pass, columns, floats);
  } else {
    std::fill_n(pass.largest_change, pass.sweeps, 0.0f);
    simd::run_for_level<MeasuringPassKernel>(pass, columns, floats);
  }
}

void mask_of_flow(const float* u, const float* v, float threshold, std::uint8_t* mask, std::size_t count) {
  simd::run<MaskKernel>(u, v, threshold, mask, count);
}

}  // namespace survtrack::kernels
