// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <utility>

#include "core/simd.hpp"

/// One Jacobi sweep over a row (Horn and Schunck 1981, section 12). With the column sums t = above + below and
/// w = t / 2 + here, the neighbourhood mean is (w left + w right + t) / 6: four additions a pixel.
namespace survtrack::kernels {

/// `rows` rows to be computed together, which lie one below the other. The new rows may overwrite the first ones
/// of the field before: those above the row itself.
template <int rows>
struct SweepRows {
  const float* u[rows + 2];  ///< the field before, with the rows above and below
  const float* v[rows + 2];
  const float* a[rows];  ///< the normalised derivatives
  const float* b[rows];
  const float* c[rows];
  float* new_u[rows];
  float* new_v[rows];
  std::ptrdiff_t count;  ///< of pixels, whole blocks
};

#if defined(__GNUC__) || defined(__clang__)

/// `lanes` floats, as the compiler's vector type. Never passed by value: that would need one instruction set.
template <std::size_t lanes>
struct Floats {
  typedef float type __attribute__((vector_size(lanes * sizeof(float))));
};

template <class Vector>
SURVTRACK_SIMD_INLINE void load(Vector& vector, const float* from) {
  std::memcpy(&vector, from, sizeof(Vector));
}
template <class Vector>
SURVTRACK_SIMD_INLINE void store(const Vector& vector, float* to) {
  std::memcpy(to, &vector, sizeof(Vector));
}

/// Column sums of `lanes` columns of one row.
template <std::size_t lanes>
struct Columns {
  using Vector = typename Floats<lanes>::type;
  Vector t;
  Vector w;

  SURVTRACK_SIMD_INLINE void sum(const Vector& above, const Vector& here, const Vector& below) {
    t = above + below;
    w = t * 0.5f + here;
  }
};

/// Those of one or two rows, which share the loads of what lies between. Members, no arrays: gcc keeps an array
/// of vectors in memory.
template <std::size_t lanes, int rows>
struct RowColumns {
  using Vector = typename Floats<lanes>::type;
  Columns<lanes> first;
  Columns<lanes> second;

  SURVTRACK_SIMD_INLINE void load(const float* const (&field)[rows + 2], std::ptrdiff_t x) {
    Vector above, here, below;
    kernels::load(above, field[0] + x);
    kernels::load(here, field[1] + x);
    kernels::load(below, field[2] + x);
    first.sum(above, here, below);
    if constexpr (rows == 2) {
      Vector last;
      kernels::load(last, field[3] + x);
      second.sum(here, below, last);
    }
  }
  SURVTRACK_SIMD_INLINE void become(const RowColumns& other) {
    first.t = other.first.t;
    first.w = other.first.w;
    if constexpr (rows == 2) {
      second.t = other.second.t;
      second.w = other.second.w;
    }
  }
};

/// The mean around each of the columns in the middle. Shuffles instead of loads one column off: loads are
/// what a sweep waits for.
template <std::size_t lanes, std::size_t... I>
SURVTRACK_SIMD_INLINE void neighbourhood_mean(const Columns<lanes>& before, const Columns<lanes>& here,
                                              const Columns<lanes>& after, typename Floats<lanes>::type& mean,
                                              std::index_sequence<I...> /*lanes*/) {
  const auto left = __builtin_shufflevector(before.w, here.w, static_cast<int>(lanes - 1 + I)...);
  const auto right = __builtin_shufflevector(here.w, after.w, static_cast<int>(1 + I)...);
  mean = ((left + right) + here.t) * (1.0f / 6.0f);
}

/// Row `row` of those together, whose means are known: the constraint's share.
template <std::size_t lanes, int rows>
SURVTRACK_SIMD_INLINE void correct(const SweepRows<rows>& r, int row, std::ptrdiff_t x,
                                   const typename Floats<lanes>::type& mean_u,
                                   const typename Floats<lanes>::type& mean_v) {
  using Vector = typename Floats<lanes>::type;
  Vector a, b, c;
  load(a, r.a[row] + x);
  load(b, r.b[row] + x);
  load(c, r.c[row] + x);
  const Vector error = (a * mean_u + b * mean_v) + c;
  store(Vector(mean_u - a * error), r.new_u[row] + x);
  store(Vector(mean_v - b * error), r.new_v[row] + x);
}

template <std::size_t lanes, int rows>
SURVTRACK_SIMD_INLINE void sweep(const SweepRows<rows>& given) {
  static_assert(rows == 1 || rows == 2);
  using Vector = typename Floats<lanes>::type;
  constexpr auto step = static_cast<std::ptrdiff_t>(lanes);
  constexpr std::make_index_sequence<lanes> each_lane;
  const SweepRows<rows> r = given;
  RowColumns<lanes, rows> u_before, u_here, u_after, v_before, v_here, v_after;
  u_before.load(r.u, -step);
  v_before.load(r.v, -step);
  u_here.load(r.u, 0);
  v_here.load(r.v, 0);
  for (std::ptrdiff_t x = 0; x < r.count; x += step) {
    u_after.load(r.u, x + step);
    v_after.load(r.v, x + step);
    Vector mean_u, mean_v;
    neighbourhood_mean<lanes>(u_before.first, u_here.first, u_after.first, mean_u, each_lane);
    neighbourhood_mean<lanes>(v_before.first, v_here.first, v_after.first, mean_v, each_lane);
    correct<lanes>(r, 0, x, mean_u, mean_v);
    if constexpr (rows == 2) {
      neighbourhood_mean<lanes>(u_before.second, u_here.second, u_after.second, mean_u, each_lane);
      neighbourhood_mean<lanes>(v_before.second, v_here.second, v_after.second, mean_v, each_lane);
      correct<lanes>(r, 1, x, mean_u, mean_v);
    }
    u_before.become(u_here);
    u_here.become(u_after);
    v_before.become(v_here);
    v_here.become(v_after);
  }
}

#else

/// Column sums of one column; the one to the left may be overwritten by then.
struct ColumnSums {
  ColumnSums(const float* above, const float* here, const float* below, std::ptrdiff_t x)
      : t(above[x] + below[x]), w(t * 0.5f + here[x]) {}
  float t;
  float w;
};

template <std::size_t lanes, int rows>
SURVTRACK_SIMD_INLINE void sweep(const SweepRows<rows>& r) {
  for (int i = 0; i < rows; ++i) {
    const auto u = [&](std::ptrdiff_t x) { return ColumnSums(r.u[i], r.u[i + 1], r.u[i + 2], x); };
    const auto v = [&](std::ptrdiff_t x) { return ColumnSums(r.v[i], r.v[i + 1], r.v[i + 2], x); };
    ColumnSums u_left = u(-1), u_here = u(0), v_left = v(-1), v_here = v(0);
    for (std::ptrdiff_t x = 0; x < r.count; ++x) {
      const ColumnSums u_right = u(x + 1);
      const ColumnSums v_right = v(x + 1);
      const float mean_u = ((u_left.w + u_right.w) + u_here.t) * (1.0f / 6.0f);
      const float mean_v = ((v_left.w + v_right.w) + v_here.t) * (1.0f / 6.0f);
      const float error = (r.a[i][x] * mean_u + r.b[i][x] * mean_v) + r.c[i][x];
      r.new_u[i][x] = mean_u - r.a[i][x] * error;
      r.new_v[i][x] = mean_v - r.b[i][x] * error;
      u_left = u_here;
      u_here = u_right;
      v_left = v_here;
      v_here = v_right;
    }
  }
}

#endif

/// The first sweep when all was zero: the same numbers with less work.
SURVTRACK_SIMD_INLINE void sweep_zeros(const float* a, const float* b, const float* c, float* u, float* v,
                                       std::ptrdiff_t count) {
  SURVTRACK_SIMD_LOOP
  for (std::ptrdiff_t x = 0; x < count; ++x) {
    u[x] = 0.0f - a[x] * c[x];
    v[x] = 0.0f - b[x] * c[x];
  }
}

/// The largest of `largest` and |after - before|; before: nullptr for zeros. As integers, whose order is that
/// of floats that are not negative, and whose greatest needs no order of comparing.
SURVTRACK_SIMD_INLINE float largest_change(const float* before, const float* after, std::ptrdiff_t count,
                                           float largest) {
  auto bits = std::bit_cast<std::int32_t>(largest);
  SURVTRACK_SIMD_LOOP
  for (std::ptrdiff_t x = 0; x < count; ++x) {
    const float change = std::fabs(before == nullptr ? after[x] : after[x] - before[x]);
    const auto own = std::bit_cast<std::int32_t>(change);
    bits = own > bits ? own : bits;
  }
  return std::bit_cast<float>(bits);
}

}  // namespace survtrack::kernels
