// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include <vector>

#include "filtering/kalman_lanes.hpp"
#include "filtering/lane.hpp"

namespace survtrack {
namespace {

using namespace lane;

struct PredictKernel {
  SURVTRACK_SIMD_INLINE void operator()(const KalmanLanes& a, const SparseRows& F, const Eigen::MatrixXd& Q,
                                        const double* shift, Index shift_stride, Lane* scratch, LaneFaults* faults) const {
    const Index n = a.n;
    Lane* const FP = scratch;     // n x n
    Lane* const P = FP + n * n;          // upper triangle
    Lane* const x = P + n * (n + 1) / 2;
    for (Index first = 0; first < a.size; first += W) {
      for (Index c = 0; c < n * (n + 1) / 2; ++c) load(P[c], a.P + c * a.stride + first);
      for (Index c = 0; c < n; ++c) load(x[c], a.x + c * a.stride + first);
      Lane sum, value;
      fill(sum, 0.0);
      for (Index i = 0; i < n; ++i) {
        fill(value, shift != nullptr && shift_stride == 0 ? shift[i] : 0.0);
        if (shift_stride != 0) load(value, shift + i * shift_stride + first);
        for (const SparseRows::Term& t : F.rows[static_cast<std::size_t>(i)]) add(value, t.factor, x[t.column]);
        store(a.next_x + i * a.stride + first, value);
        add(sum, 1.0, value);
        for (Index j = 0; j < n; ++j) {
          Lane& out = FP[i * n + j];
          fill(out, 0.0);
          for (const SparseRows::Term& t : F.rows[static_cast<std::size_t>(i)]) {
            add(out, t.factor, P[KalmanLanes::upper(n, t.column, j)]);
          }
        }
      }
      for (Index i = 0; i < n; ++i) {
        for (Index j = i; j < n; ++j) {
          fill(value, Q(i, j));
          for (const SparseRows::Term& t : F.rows[static_cast<std::size_t>(j)]) add(value, t.factor, FP[i * n + t.column]);
          store(a.next_P + KalmanLanes::upper(n, i, j) * a.stride + first, value);
          add(sum, 1.0, value);
        }
      }
      find_overflow(sum, first, a.size, *faults);
    }
  }
};

}  // namespace

SparseRows::SparseRows(const Eigen::MatrixXd& matrix) : rows(static_cast<std::size_t>(matrix.rows())) {
  for (Index j = 0; j < matrix.cols(); ++j) {
    for (Index i = 0; i < matrix.rows(); ++i) {
      if (matrix(i, j) == 0.0) continue;
      rows[static_cast<std::size_t>(i)].push_back({j, matrix(i, j)});
      if (columns.empty() || columns.back() != j) columns.push_back(j);
    }
  }
}

LaneFaults predict_lanes(const KalmanLanes& lanes, const SparseRows& F, const Eigen::MatrixXd& Q, const double* shift,
                         Index shift_stride) {
  const Index n = lanes.n;
  std::vector<Lane> scratch(static_cast<std::size_t>(n * n + n * (n + 1) / 2 + n));
  LaneFaults faults;
  simd::run<PredictKernel>(lanes, F, Q, shift, shift_stride, scratch.data(), &faults);
  return faults;
}

}  // namespace survtrack
