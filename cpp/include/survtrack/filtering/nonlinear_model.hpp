// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <functional>

#include "survtrack/core/errors.hpp"
#include "survtrack/filtering/correction.hpp"
#include "survtrack/filtering/covariance.hpp"

namespace survtrack {

/// x = f(x, u) + noise of covariance Q, z = h(x) + noise of covariance R. `NonlinearModel<4, 2>` has 4 states and 2
/// measured numbers; `NonlinearModel<>` takes its sizes from the matrices.
template <int N = Eigen::Dynamic, int M = Eigen::Dynamic>
struct NonlinearModel {
  using State = Eigen::Matrix<double, N, 1>;
  using StateMatrix = Eigen::Matrix<double, N, N>;
  using Measurement = Eigen::Matrix<double, M, 1>;
  using MeasurementMatrix = Eigen::Matrix<double, M, N>;
  using MeasurementCovariance = Eigen::Matrix<double, M, M>;

  std::function<State(const State& x, const Eigen::VectorXd& u)> f;
  std::function<Measurement(const State& x)> h;
  StateMatrix Q;            ///< n x n
  MeasurementCovariance R;  ///< m x m
  Residual residual = {};   ///< of measurements that wrap; empty: z - predicted

  /// f and h, refused by `InputError` where they return another size or a number that is not finite.
  State moved(const State& x, const Eigen::VectorXd& u) const {
    State next = f(x, u);
    check_matrix("f", next, Q.rows(), 1);
    return next;
  }
  Measurement measured(const State& x) const {
    Measurement z = h(x);
    check_matrix("h", z, R.rows(), 1);
    return z;
  }
  /// The residual of a measurement, refused likewise.
  Measurement difference(const Measurement& z, const Measurement& predicted) const {
    check_matrix("z", z, R.rows(), 1);
    if (!residual) return z - predicted;
    const Eigen::VectorXd y = residual(z, predicted);
    check_matrix("residual", y, R.rows(), 1);
    return y;
  }

  /// Refuses a missing callable, and what does not fit a state x of covariance P.
  void check(const State& x, const StateMatrix& P) const {
    if (!f) throw InputError("f: is missing; expected the function that moves a state");
    if (!h) throw InputError("h: is missing; expected the function that measures a state");
    check_matrix("x", x, x.size(), 1);
    check_covariance("Q", Q, x.size());
    check_covariance("R", R, R.rows());
    check_covariance("P", P, x.size());
  }
};

/// The derivative of `function` at x by central differences: column j is (f(x + d_j) - f(x - d_j)) / 2 d_j with d_j the
/// third root of the machine precision, times the size of x_j where that is above 1. `difference` is how two values
/// differ, a - b if empty. The values may not be empty nor change their size; throws `InputError`. `Rows`: how many
/// numbers they have, if that is known.
template <int Rows = Eigen::Dynamic, class Function, int N>
Eigen::Matrix<double, Rows, N> numeric_jacobian(const Function& function, const Eigen::Matrix<double, N, 1>& x,
                                                const Residual& difference = {}) {
  using Value = Eigen::Matrix<double, Rows, 1>;
  constexpr double third_root = 6.0554544523933395e-06;  // of 2^-52: rounding and curvature err alike
  check_matrix("x", x, x.size(), 1);
  Eigen::Matrix<double, Rows, N> J;
  Eigen::Matrix<double, N, 1> at = x;
  for (Eigen::Index j = 0; j < x.size(); ++j) {
    const double step = third_root * std::max(1.0, std::abs(x(j)));
    const double above = x(j) + step, below = x(j) - step;
    at(j) = above;
    const Value ahead = function(at);
    at(j) = below;
    const Value behind = function(at);
    at(j) = x(j);
    if (j == 0) J.resize(ahead.size(), x.size());
    check_matrix("function", ahead, J.rows(), 1);
    check_matrix("function", behind, J.rows(), 1);
    const Value apart = difference ? Value(difference(ahead, behind)) : Value(ahead - behind);
    check_matrix("difference", apart, J.rows(), 1);
    J.col(j) = apart / (above - below);
  }
  return J;
}

}  // namespace survtrack
