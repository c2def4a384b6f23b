// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <Eigen/Core>
#include <vector>

namespace survtrack {

/// A matrix by its numbers that are not zero: transitions and measurement matrices have few.
struct SparseRows {
  struct Term {
    Eigen::Index column;
    double factor;
  };
  explicit SparseRows(const Eigen::MatrixXd& matrix);

  std::vector<std::vector<Term>> rows;
  std::vector<Eigen::Index> columns;  ///< those that are not all zero
};

/// The arrays of a `KalmanArray` for a pass over all its filters. Component c of filter i is at [c * stride + i]; of
/// symmetric matrices the upper triangle, row by row.
struct KalmanLanes {
  static constexpr Eigen::Index width = 16;  ///< filters that are worked on at a time

  Eigen::Index n, m, size, stride;
  const double *x, *P, *z;
  double *next_x, *next_P;
  double *y, *S, *nis;

  /// Where element (i, j) of a symmetric matrix of `order` rows lies in its upper triangle.
  static constexpr Eigen::Index upper(Eigen::Index order, Eigen::Index i, Eigen::Index j) {
    return i <= j ? i * order - i * (i - 1) / 2 + j - i : upper(order, j, i);
  }
};

/// What came of a pass: the first filter where something is wrong, or -1.
struct LaneFaults {
  Eigen::Index singular = -1;  ///< its innovation covariance is
  Eigen::Index overflow = -1;  ///< its state would no longer be finite
};

/// next_x = F x + shift, next_P = F P F' + Q. `shift`: n rows of `shift_stride` numbers; stride 0: one for all; or null.
LaneFaults predict_lanes(const KalmanLanes& lanes, const SparseRows& F, const Eigen::MatrixXd& Q, const double* shift,
                         Eigen::Index shift_stride);

/// Corrects all filters but those whose z is NaN; also writes y, S and nis.
LaneFaults update_lanes(const KalmanLanes& lanes, const SparseRows& H, const Eigen::MatrixXd& R,
                        const Eigen::VectorXd& periods, bool checked);

/// The same for some sizes, faster; return false, and do nothing, for others. No shift and no periods. `faults`: stride
/// numbers; 0 where nothing is wrong, 1 where S is singular, otherwise NaN.
bool predict_fixed(const KalmanLanes& lanes, const Eigen::MatrixXd& F, const Eigen::MatrixXd& Q, double* faults);
bool update_fixed(const KalmanLanes& lanes, const Eigen::MatrixXd& H, const Eigen::MatrixXd& R, bool checked, double* faults);

}  // namespace survtrack
