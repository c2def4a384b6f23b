// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "filtering/kalman_lanes.hpp"
#include "filtering/lane.hpp"

namespace survtrack {
namespace {

using namespace lane;

struct UpdateKernel {
  SURVTRACK_SIMD_INLINE void operator()(const KalmanLanes& a, const SparseRows& H, const Eigen::MatrixXd& R,
                                        const Eigen::VectorXd& periods, bool checked, Lane* scratch, LaneFaults* faults) const {
    const Index n = a.n, m = a.m;
    Lane* const P = scratch;            // upper triangle
    Lane* const x = P + n * (n + 1) / 2;       // n
    Lane* const HP = x + n;                    // m x n
    Lane* const G = HP + m * n;                // m x n: S^-1 H P, the gain's transpose
    Lane* const S = G + m * n;                 // m x m: below the diagonal L, on it D
    Lane* const y = S + m * m;                 // m
    Lane* const A = y + m;                     // n x n: I - K H
    Lane* const AP = A + n * n;                // n x n
    Lane* const KR = AP + n * n;               // n x m
    for (Index first = 0; first < a.size; first += W) {
      for (Index c = 0; c < n * (n + 1) / 2; ++c) load(P[c], a.P + c * a.stride + first);
      for (Index c = 0; c < n; ++c) load(x[c], a.x + c * a.stride + first);
      innovations(a, H, R, periods, first, P, x, HP, S, y);
      Lane missing, value;
      SURVTRACK_SIMD_LOOP for (Index l = 0; l < W; ++l) missing.v[l] = y[0].v[l] == y[0].v[l] ? 0.0 : 1.0;
      factors(a, checked, first, S, missing, *faults);
      for (Index c = 0; c < m * n; ++c) G[c] = HP[c];
      solve(n, m, S, G);

      Lane w[1], nis;  // y' S^-1 y, by the forward half of the solution
      fill(nis, 0.0);
      for (Index i = 0; i < m; ++i) {
        value = y[i];
        for (Index k = 0; k < i; ++k) subtract(value, S[i * m + k], KR[k]);
        KR[i] = value;  // not in use yet
        w[0] = value;
        divide(w[0], S[i * m + i]);
        add(nis, w[0], value);
      }
      store(a.nis + first, nis);

      Lane sum;
      fill(sum, 0.0);
      const auto keep = [&](double* out, const Lane& before, const Lane& after) {
        SURVTRACK_SIMD_LOOP for (Index l = 0; l < W; ++l) {
          const double kept = missing.v[l] != 0.0 ? before.v[l] : after.v[l];
          out[l] = kept;
          sum.v[l] += kept;
        }
      };
      for (Index i = 0; i < n; ++i) {
        value = x[i];
        for (Index c = 0; c < m; ++c) add(value, G[c * n + i], y[c]);
        keep(a.next_x + i * a.stride + first, x[i], value);
        for (const Index j : H.columns) fill(A[i * n + j], i == j ? 1.0 : 0.0);
        for (Index c = 0; c < m; ++c) {
          for (const SparseRows::Term& t : H.rows[static_cast<std::size_t>(c)]) add(A[i * n + t.column], -t.factor, G[c * n + i]);
          fill(KR[i * m + c], 0.0);
          for (Index d = 0; d < m; ++d) add(KR[i * m + c], R(d, c), G[d * n + i]);
        }
        const bool plain = !std::binary_search(H.columns.begin(), H.columns.end(), i);  // the identity's 1 stands alone
        for (Index j = 0; j < n; ++j) {
          Lane& out = AP[i * n + j];
          if (plain) out = P[KalmanLanes::upper(n, i, j)];
          else fill(out, 0.0);
          for (const Index k : H.columns) add(out, A[i * n + k], P[KalmanLanes::upper(n, k, j)]);
        }
      }
      for (Index i = 0; i < n; ++i) {
        for (Index j = i; j < n; ++j) {
          const bool plain = !std::binary_search(H.columns.begin(), H.columns.end(), j);
          if (plain) value = AP[i * n + j];
          else fill(value, 0.0);
          for (const Index k : H.columns) add(value, AP[i * n + k], A[j * n + k]);
          for (Index c = 0; c < m; ++c) add(value, KR[i * m + c], G[c * n + j]);
          const Index at = KalmanLanes::upper(n, i, j);
          keep(a.next_P + at * a.stride + first, P[at], value);
        }
      }
      find_overflow(sum, first, a.size, *faults);
    }
  }

 private:
  /// H P, S = H P H' + R and y = z - H x, of which S and y are also results.
  SURVTRACK_SIMD_INLINE static void innovations(const KalmanLanes& a, const SparseRows& H, const Eigen::MatrixXd& R,
                                                const Eigen::VectorXd& periods, Index first, const Lane* P, const Lane* x,
                                                Lane* HP, Lane* S, Lane* y) {
    const Index n = a.n, m = a.m;
    for (Index c = 0; c < m; ++c) {
      const auto& row = H.rows[static_cast<std::size_t>(c)];
      load(y[c], a.z + c * a.stride + first);
      for (const SparseRows::Term& t : row) add(y[c], -t.factor, x[t.column]);
      if (periods.size() != 0 && periods(c) > 0.0) {
        const double period = periods(c);
        for (Index l = 0; l < W; ++l) y[c].v[l] -= period * std::floor(y[c].v[l] / period + 0.5);
      }
      store(a.y + c * a.stride + first, y[c]);
      for (Index j = 0; j < n; ++j) {
        fill(HP[c * n + j], 0.0);
        for (const SparseRows::Term& t : row) add(HP[c * n + j], t.factor, P[KalmanLanes::upper(n, t.column, j)]);
      }
    }
    for (Index c = 0; c < m; ++c) {
      for (Index d = c; d < m; ++d) {
        Lane value;
        fill(value, R(c, d));
        for (const SparseRows::Term& t : H.rows[static_cast<std::size_t>(d)]) add(value, t.factor, HP[c * n + t.column]);
        S[c * m + d] = S[d * m + c] = value;
        store(a.S + KalmanLanes::upper(m, c, d) * a.stride + first, value);
      }
    }
  }

  /// S = L D L' in place, and the first filter that has a measurement and no such S.
  SURVTRACK_SIMD_INLINE static void factors(const KalmanLanes& a, bool checked, Index first, Lane* S, const Lane& missing,
                                            LaneFaults& faults) {
    constexpr double smallest_share = 16.0 * std::numeric_limits<double>::epsilon();
    const Index m = a.m;
    for (Index j = 0; j < m; ++j) {
      Lane square = S[j * m + j], scaled;
      for (Index k = 0; k < j; ++k) {
        scaled = S[j * m + k];
        SURVTRACK_SIMD_LOOP for (Index l = 0; l < W; ++l) scaled.v[l] *= S[k * m + k].v[l];
        subtract(square, S[j * m + k], scaled);
        for (Index i = j + 1; i < m; ++i) subtract(S[i * m + j], S[i * m + k], scaled);
      }
      double regular = 1.0;
      for (Index l = 0; l < W; ++l) {
        const double pivot = checked ? square.v[l] : std::abs(square.v[l]);
        const bool fine = pivot > smallest_share * std::abs(S[j * m + j].v[l]) || missing.v[l] != 0.0;
        regular = fine ? regular : 0.0;
      }
      for (Index l = 0; regular == 0.0 && l < W && first + l < a.size; ++l) {
        const double pivot = checked ? square.v[l] : std::abs(square.v[l]);
        const bool fine = pivot > smallest_share * std::abs(S[j * m + j].v[l]) || missing.v[l] != 0.0;
        if (!fine && faults.singular < 0) faults.singular = first + l;
      }
      S[j * m + j] = square;
      for (Index i = j + 1; i < m; ++i) divide(S[i * m + j], square);
    }
  }

  /// G = S^-1 G.
  SURVTRACK_SIMD_INLINE static void solve(Index n, Index m, const Lane* S, Lane* G) {
    for (Index i = 1; i < m; ++i) {
      for (Index k = 0; k < i; ++k) {
        for (Index j = 0; j < n; ++j) subtract(G[i * n + j], S[i * m + k], G[k * n + j]);
      }
    }
    for (Index i = m - 1; i >= 0; --i) {
      for (Index j = 0; j < n; ++j) {
        divide(G[i * n + j], S[i * m + i]);
        for (Index k = i + 1; k < m; ++k) subtract(G[i * n + j], S[k * m + i], G[k * n + j]);
      }
    }
  }
};

}  // namespace

LaneFaults update_lanes(const KalmanLanes& lanes, const SparseRows& H, const Eigen::MatrixXd& R,
                        const Eigen::VectorXd& periods, bool checked) {
  const Index n = lanes.n, m = lanes.m;
  std::vector<Lane> scratch(static_cast<std::size_t>(n * (n + 1) / 2 + n + 3 * m * n + m * m + m + 2 * n * n));
  LaneFaults faults;
  simd::run<UpdateKernel>(lanes, H, R, periods, checked, scratch.data(), &faults);
  return faults;
}

}  // namespace survtrack
