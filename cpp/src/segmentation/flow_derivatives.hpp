// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/simd.hpp"
#include "segmentation/flow_pass.hpp"

/// The first steps of a flow pass, row by row: sum and difference of two images, and their derivatives.
namespace survtrack::kernels {

/// Sum and difference of the images in columns `left` to `right` - 1 of a row, repeated over the image's edges
/// as far as column `end` - 1.
template <class Level>
SURVTRACK_SIMD_INLINE void add_and_subtract(const Level* previous, const Level* current, float* sum, float* difference,
                                            std::ptrdiff_t left, std::ptrdiff_t end, std::ptrdiff_t width) {
  const std::ptrdiff_t right = std::min(end, width);
  SURVTRACK_SIMD_LOOP
  for (std::ptrdiff_t x = left; x < right; ++x) {
    const auto before = static_cast<float>(previous[x]);
    const auto now = static_cast<float>(current[x]);
    sum[x] = before + now;
    difference[x] = now - before;
  }
  for (float* const row : {sum, difference}) {
    if (left == 0) row[-1] = row[0];
    if (end > width) std::fill(row + width, row + end, row[width - 1]);
  }
}

SURVTRACK_SIMD_INLINE void load_images(const FlowPass& pass, std::ptrdiff_t y, std::ptrdiff_t left, std::ptrdiff_t end,
                                       float* sum, float* difference) {
  const std::ptrdiff_t before = y * pass.previous.stride;
  const std::ptrdiff_t now = y * pass.current.stride;
  if (pass.previous.bytes != nullptr) {
    add_and_subtract(pass.previous.bytes + before, pass.current.bytes + now, sum, difference, left, end, pass.width);
  } else {
    add_and_subtract(pass.previous.floats + before, pass.current.floats + now, sum, difference, left, end, pass.width);
  }
}

/// Three rows, of which the middle one is the one to be derived.
struct ThreeRows {
  const float* above;
  const float* here;
  const float* below;
};

/// Means of four differences in the cube of 2 x 2 pixels x 2 images of which the pixel is the top left
/// (Horn and Schunck 1981, section 7).
struct CubeDerivatives {
  SURVTRACK_SIMD_INLINE static void at(const ThreeRows& s, const ThreeRows& d, std::ptrdiff_t x, float& ix, float& iy,
                                       float& it) {
    ix = ((s.here[x + 1] - s.here[x]) + (s.below[x + 1] - s.below[x])) * 0.25f;
    iy = ((s.below[x] - s.here[x]) + (s.below[x + 1] - s.here[x + 1])) * 0.25f;
    it = ((d.here[x] + d.here[x + 1]) + (d.below[x] + d.below[x + 1])) * 0.25f;
  }
};

/// Sobel's kernels on the mean of both images, a difference at the pixel alone.
struct SobelDerivatives {
  SURVTRACK_SIMD_INLINE static void at(const ThreeRows& s, const ThreeRows& d, std::ptrdiff_t x, float& ix, float& iy,
                                       float& it) {
    ix = ((s.above[x + 1] - s.above[x - 1]) + (s.below[x + 1] - s.below[x - 1]) +
          (s.here[x + 1] - s.here[x - 1]) * 2.0f) * 0.0625f;
    iy = ((s.below[x - 1] - s.above[x - 1]) + (s.below[x + 1] - s.above[x + 1]) +
          (s.below[x] - s.above[x]) * 2.0f) * 0.0625f;
    it = d.here[x];
  }
};

/// The brightness constraint of a row, Ix u + Iy v + It = 0, divided by the root of a^2 + Ix^2 + Iy^2, which
/// leaves the sweeps no division. About a flow by which the later image was warped, It is that of the whole
/// flow: It - Ix u - Iy v.
template <class Kind, bool warped>
SURVTRACK_SIMD_INLINE void derive_row(const ThreeRows& s, const ThreeRows& d, float smoothness2, const float* about_u,
                                      const float* about_v, float* a, float* b, float* c, std::ptrdiff_t left,
                                      std::ptrdiff_t right) {
  SURVTRACK_SIMD_LOOP
  for (std::ptrdiff_t x = left; x < right; ++x) {
    float ix = 0.0f;
    float iy = 0.0f;
    float it = 0.0f;
    Kind::at(s, d, x, ix, iy, it);
    if constexpr (warped) it -= ix * about_u[x] + iy * about_v[x];
    const float scale = 1.0f / std::sqrt(smoothness2 + ix * ix + iy * iy);
    a[x] = ix * scale;
    b[x] = iy * scale;
    c[x] = it * scale;
  }
}

template <class Kind>
SURVTRACK_SIMD_INLINE void derive_row(const FlowPass& pass, std::ptrdiff_t y, const ThreeRows& s, const ThreeRows& d,
                                      float* const (&to)[3], std::ptrdiff_t left, std::ptrdiff_t right) {
  if (pass.about != nullptr) {
    derive_row<Kind, true>(s, d, pass.smoothness2, pass.about->u.row(y), pass.about->v.row(y), to[0], to[1], to[2],
                           left, right);
  } else {
    derive_row<Kind, false>(s, d, pass.smoothness2, nullptr, nullptr, to[0], to[1], to[2], left, right);
  }
}

}  // namespace survtrack::kernels
