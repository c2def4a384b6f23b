// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <Eigen/Core>
#include <cmath>
#include <limits>

#include "survtrack/filtering/covariance.hpp"

namespace survtrack {

/// S = L D L' of a small symmetric matrix, such as the covariance of an innovation. Throws `InputError` where
/// S is singular: where a component is determined by those before it but for rounding.
template <int M>
class Ldl {
 public:
  using Square = Eigen::Matrix<double, M, M>;
  using Vector = Eigen::Matrix<double, M, 1>;

  Ldl(const Square& S, Covariances covariances) : L_(S) {
    for (Eigen::Index j = 0; j < size(); ++j) {
      for (Eigen::Index k = 0; k < j; ++k) L_(j, j) -= L_(j, k) * L_(j, k) * L_(k, k);
      const double share = covariances == Covariances::checked ? L_(j, j) : std::abs(L_(j, j));
      if (!(share > smallest_share * std::abs(S(j, j)))) throw_singular("S", S);
      for (Eigen::Index i = j + 1; i < size(); ++i) {
        for (Eigen::Index k = 0; k < j; ++k) L_(i, j) -= L_(i, k) * L_(j, k) * L_(k, k);
        L_(i, j) /= L_(j, j);
      }
    }
  }

  Eigen::Index size() const { return L_.rows(); }

  /// X = X S^-1, for a matrix of as many columns.
  template <class Matrix>
  void solve_from_right(Matrix& X) const {
    for (Eigen::Index i = 1; i < size(); ++i) {
      for (Eigen::Index k = 0; k < i; ++k) X.col(i) -= L_(i, k) * X.col(k);
    }
    for (Eigen::Index i = size() - 1; i >= 0; --i) {
      X.col(i) *= 1.0 / L_(i, i);
      for (Eigen::Index k = i + 1; k < size(); ++k) X.col(i) -= L_(k, i) * X.col(k);
    }
  }

  /// y' S^-1 y.
  double squared_distance(Vector y) const {
    double sum = 0.0;
    for (Eigen::Index i = 0; i < size(); ++i) {
      for (Eigen::Index k = 0; k < i; ++k) y(i) -= L_(i, k) * y(k);
      sum += y(i) * y(i) / L_(i, i);
    }
    return sum;
  }

  /// Logarithm of the determinant of a positive definite S.
  double log_determinant() const {
    double sum = 0.0;
    for (Eigen::Index i = 0; i < size(); ++i) sum += std::log(L_(i, i));
    return sum;
  }

 private:
  static constexpr double smallest_share = 16.0 * std::numeric_limits<double>::epsilon();

  Square L_;  ///< below the diagonal L, on it D
};

}  // namespace survtrack
