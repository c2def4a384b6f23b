// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <Eigen/Core>
#include <functional>

#include "survtrack/filtering/correction.hpp"

namespace survtrack {

/// x = f(x, u) + noise of covariance Q, z = h(x) + noise of covariance R.
struct NonlinearModel {
  std::function<Eigen::VectorXd(const Eigen::VectorXd& x, const Eigen::VectorXd& u)> f;
  std::function<Eigen::VectorXd(const Eigen::VectorXd& x)> h;
  Eigen::MatrixXd Q;      ///< n x n
  Eigen::MatrixXd R;      ///< m x m
  Residual residual = {};  ///< of measurements that wrap; empty: z - predicted

  /// f and h, refused by `InputError` where they return another size or a number that is not finite.
  Eigen::VectorXd moved(const Eigen::VectorXd& x, const Eigen::VectorXd& u) const;
  Eigen::VectorXd measured(const Eigen::VectorXd& x) const;
  /// The residual of a measurement, refused likewise.
  Eigen::VectorXd difference(const Eigen::VectorXd& z, const Eigen::VectorXd& predicted) const;

  /// Refuses a missing callable, and what does not fit a state x of covariance P.
  void check(const Eigen::VectorXd& x, const Eigen::MatrixXd& P) const;
};

/// The derivative of `function` at x by central differences: column j is (f(x + d_j) - f(x - d_j)) / 2 d_j with d_j the
/// third root of the machine precision, times the size of x_j where that is above 1. `difference` is how two values
/// differ, a - b if empty. The values may not be empty nor change their size; throws `InputError`.
Eigen::MatrixXd numeric_jacobian(const std::function<Eigen::VectorXd(const Eigen::VectorXd&)>& function,
                                 const Eigen::VectorXd& x, const Residual& difference = {});

}  // namespace survtrack
