// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <Eigen/Core>

#include "core/simd.hpp"
#include "filtering/kalman_lanes.hpp"

namespace survtrack::lane {

using Index = Eigen::Index;
inline constexpr Index W = KalmanLanes::width;

/// One number of each filter of a pass.
struct Lane {
  double v[W];
};

SURVTRACK_SIMD_INLINE void fill(Lane& out, double value) {
  SURVTRACK_SIMD_LOOP for (Index l = 0; l < W; ++l) out.v[l] = value;
}
SURVTRACK_SIMD_INLINE void load(Lane& out, const double* in) {
  SURVTRACK_SIMD_LOOP for (Index l = 0; l < W; ++l) out.v[l] = in[l];
}
SURVTRACK_SIMD_INLINE void store(double* out, const Lane& in) {
  SURVTRACK_SIMD_LOOP for (Index l = 0; l < W; ++l) out[l] = in.v[l];
}
SURVTRACK_SIMD_INLINE void add(Lane& out, double factor, const Lane& in) {
  SURVTRACK_SIMD_LOOP for (Index l = 0; l < W; ++l) out.v[l] += factor * in.v[l];
}
SURVTRACK_SIMD_INLINE void add(Lane& out, const Lane& a, const Lane& b) {
  SURVTRACK_SIMD_LOOP for (Index l = 0; l < W; ++l) out.v[l] += a.v[l] * b.v[l];
}
SURVTRACK_SIMD_INLINE void subtract(Lane& out, const Lane& a, const Lane& b) {
  SURVTRACK_SIMD_LOOP for (Index l = 0; l < W; ++l) out.v[l] -= a.v[l] * b.v[l];
}
SURVTRACK_SIMD_INLINE void divide(Lane& out, const Lane& by) {
  SURVTRACK_SIMD_LOOP for (Index l = 0; l < W; ++l) out.v[l] /= by.v[l];
}

/// Sum of all numbers of each filter, to find those that are not finite.
SURVTRACK_SIMD_INLINE void find_overflow(const Lane& sum, Index first, Index size, LaneFaults& faults) {
  Lane zero;
  SURVTRACK_SIMD_LOOP for (Index l = 0; l < W; ++l) zero.v[l] = sum.v[l] - sum.v[l];
  for (Index l = 0; l < W && first + l < size; ++l) {
    if (zero.v[l] != 0.0 && faults.overflow < 0) faults.overflow = first + l;
  }
}

}  // namespace survtrack::lane
