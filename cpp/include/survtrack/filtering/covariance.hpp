// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <string>

#include "survtrack/filtering/covariances.hpp"

namespace survtrack {

using MatrixView = Eigen::Ref<const Eigen::MatrixXd>;

/// Refuses a matrix of another size, or with a number that is not finite; throws `InputError` naming it.
void check_matrix(const std::string& name, const MatrixView& matrix, Eigen::Index rows, Eigen::Index columns);

/// Also refuses what is not symmetric or has an eigenvalue below 0, in an `InputError` that says the smallest
/// one. Both up to rounding: to 1e-9 of the largest element or eigenvalue.
void check_covariance(const std::string& name, const MatrixView& matrix, Eigen::Index size,
                      Covariances covariances = Covariances::checked);

/// A square root of a covariance that may be singular; see covariance_root().
Eigen::MatrixXd semidefinite_root(const std::string& name, const MatrixView& P);

/// A square root L of a covariance, L L' = P: lower triangular if P is positive definite. Throws `InputError`
/// naming P and its smallest eigenvalue if that is below 0.
template <int N>
Eigen::Matrix<double, N, N> covariance_root(const std::string& name, const Eigen::Matrix<double, N, N>& P) {
  const Eigen::LLT<Eigen::Matrix<double, N, N>> cholesky(P);
  if (cholesky.info() == Eigen::Success) return cholesky.matrixL();
  return semidefinite_root(name, P);
}

/// Throw an `InputError` each; apart from the code that they are called in, which is to stay short.
[[noreturn]] void throw_singular(const std::string& name, const MatrixView& matrix);
[[noreturn]] void throw_overflow(const std::string& where);

/// Refuses a state whose numbers have grown beyond what a double holds. No element of a covariance is larger than the
/// largest on its diagonal.
template <class State, class Covariance>
void check_still_finite(const char* where, const State& x, const Covariance& P) {
  const double sum = x.sum() + P.diagonal().sum();  // not finite if any of them is not
  if (!(sum - sum == 0.0)) throw_overflow(where);
}

}  // namespace survtrack
