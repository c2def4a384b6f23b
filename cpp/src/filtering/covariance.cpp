// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "survtrack/filtering/covariance.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <cmath>

#include "core/text_of.hpp"
#include "survtrack/core/errors.hpp"
#include "survtrack/filtering/correction.hpp"

namespace survtrack {
namespace {

constexpr double rounding = 1e-9;  // relative; products of valid matrices stay far below it

[[noreturn]] void throw_not_semidefinite(const std::string& name, double smallest) {
  throw InputError(name + ": is not positive semi-definite, its smallest eigenvalue is " + text_of(smallest) +
                   "; a covariance has none below 0");
}

}  // namespace

void check_matrix(const std::string& name, const MatrixView& matrix, Eigen::Index rows, Eigen::Index columns) {
  const auto size = [](Eigen::Index r, Eigen::Index c) { return std::to_string(r) + "x" + std::to_string(c); };
  if (matrix.rows() != rows || matrix.cols() != columns) {
    throw InputError(name + ": is " + size(matrix.rows(), matrix.cols()) + "; expected " + size(rows, columns));
  }
  if (rows == 0 || columns == 0) throw InputError(name + ": is empty; expected at least one number");
  for (Eigen::Index i = 0; i < rows; ++i) {
    for (Eigen::Index j = 0; j < columns; ++j) {
      if (std::isfinite(matrix(i, j))) continue;
      const std::string place = columns == 1 ? std::to_string(i) : std::to_string(i) + ", " + std::to_string(j);
      throw InputError(name + "[" + place + "]: is " + text_of(matrix(i, j)) + "; expected a finite number");
    }
  }
}

void check_covariance(const std::string& name, const MatrixView& matrix, Eigen::Index size, Covariances covariances) {
  check_matrix(name, matrix, size, size);
  if (covariances == Covariances::as_published) return;
  const double largest = matrix.cwiseAbs().maxCoeff();
  for (Eigen::Index i = 0; i < size; ++i) {
    for (Eigen::Index j = 0; j < i; ++j) {
      if (std::abs(matrix(i, j) - matrix(j, i)) <= rounding * largest) continue;
      throw InputError(name + ": is not symmetric, [" + std::to_string(j) + ", " + std::to_string(i) + "] is " +
                       text_of(matrix(j, i)) + " and [" + std::to_string(i) + ", " + std::to_string(j) + "] " +
                       text_of(matrix(i, j)) + "; a covariance is");
    }
  }
  if (largest == 0.0) return;
  // Numbers near the largest and smallest doubles would leave their range inside the decompositions.
  const Eigen::MatrixXd scaled = matrix / largest;
  if (Eigen::LLT<Eigen::MatrixXd>(scaled).info() == Eigen::Success) return;
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(scaled, Eigen::EigenvaluesOnly);
  const Eigen::VectorXd& values = solver.eigenvalues();
  if (values.minCoeff() < -rounding * values.cwiseAbs().maxCoeff()) {
    throw_not_semidefinite(name, largest * values.minCoeff());
  }
}

Eigen::MatrixXd semidefinite_root(const std::string& name, const MatrixView& P) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(P);
  const Eigen::VectorXd& values = solver.eigenvalues();
  if (!(values.minCoeff() >= -rounding * values.cwiseAbs().maxCoeff())) throw_not_semidefinite(name, values.minCoeff());
  return solver.eigenvectors() * values.cwiseMax(0.0).cwiseSqrt().asDiagonal();
}

void throw_singular(const std::string& name, const MatrixView& matrix) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(matrix, Eigen::EigenvaluesOnly);
  throw InputError(name + ": the innovation covariance H P H' + R is singular, its smallest eigenvalue is " +
                   text_of(solver.eigenvalues().minCoeff()) + " and its largest " +
                   text_of(solver.eigenvalues().maxCoeff()) + "; a larger R makes it regular");
}

void throw_overflow(const std::string& where) {
  throw InputError(where + ": the state or its covariance would no longer be finite; the model diverges, or its numbers"
                           " are too large");
}

double wrapped_difference(double difference, double period) {
  if (!(period >= 0.0) || !std::isfinite(period)) {
    throw InputError("period: is " + text_of(period) + "; expected a length above 0, or 0 for none");
  }
  if (period == 0.0) return difference;
  return difference - period * std::floor(difference / period + 0.5);
}

}  // namespace survtrack
