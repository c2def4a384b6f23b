// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "survtrack/filtering/nonlinear_model.hpp"

#include <cmath>


namespace survtrack {

Eigen::MatrixXd numeric_jacobian(const std::function<Eigen::VectorXd(const Eigen::VectorXd&)>& function,
                                 const Eigen::VectorXd& x, const Residual& difference) {
  constexpr double third_root = 6.0554544523933395e-06;  // of 2^-52: rounding and curvature err alike
  check_matrix("x", x, x.size(), 1);
  Eigen::MatrixXd J;
  Eigen::VectorXd at = x;
  for (Eigen::Index j = 0; j < x.size(); ++j) {
    const double step = third_root * std::max(1.0, std::abs(x(j)));
    const double above = x(j) + step, below = x(j) - step;
    at(j) = above;
    const Eigen::VectorXd ahead = function(at);
    at(j) = below;
    const Eigen::VectorXd behind = function(at);
    at(j) = x(j);
    if (j == 0) J.resize(ahead.size(), x.size());
    check_matrix("function", ahead, J.rows(), 1);
    check_matrix("function", behind, J.rows(), 1);
    const Eigen::VectorXd apart = difference ? difference(ahead, behind) : Eigen::VectorXd(ahead - behind);
    check_matrix("difference", apart, J.rows(), 1);
    J.col(j) = apart / (above - below);
  }
  return J;
}

}  // namespace survtrack
