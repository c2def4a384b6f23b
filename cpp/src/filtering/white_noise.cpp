// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "survtrack/filtering/white_noise.hpp"

#include <cmath>
#include <sstream>

#include "survtrack/core/errors.hpp"

namespace survtrack {
namespace {

[[noreturn]] void refuse(const char* name, double value, const char* expected) {
  std::ostringstream text;
  text << name << ": is " << value << "; expected " << expected;
  throw InputError(text.str());
}

void check(int dim, double dt, const char* strength_name, double strength, int axes) {
  if (dim < 2 || dim > 4) refuse("dim", dim, "2, 3 or 4");
  if (!(dt > 0.0 && dt <= 1e6)) refuse("dt", dt, "a time above 0 and at most 1e6");
  if (!(strength >= 0.0 && std::isfinite(strength))) refuse(strength_name, strength, "a finite number of at least 0");
  if (axes < 1 || axes > 1000) refuse("axes", axes, "1 to 1000");
}

/// dt^k / k!, the response to a unit step k integrations ago.
double response(double dt, int k) { return k == 0 ? 1.0 : response(dt, k - 1) * dt / k; }

Eigen::MatrixXd spread(const Eigen::MatrixXd& one_axis, int axes, StateOrder order) {
  const Eigen::Index n = one_axis.rows();
  Eigen::MatrixXd Q = Eigen::MatrixXd::Zero(n * axes, n * axes);
  for (Eigen::Index axis = 0; axis < axes; ++axis) {
    const auto place = [&](Eigen::Index i) { return order == StateOrder::by_axis ? axis * n + i : i * axes + axis; };
    for (Eigen::Index i = 0; i < n; ++i) {
      for (Eigen::Index j = 0; j < n; ++j) Q(place(i), place(j)) = one_axis(i, j);
    }
  }
  return Q;
}

}  // namespace

Eigen::MatrixXd discrete_white_noise(int dim, double dt, double variance, int axes, StateOrder order) {
  check(dim, dt, "variance", variance, axes);
  // The effect of the noise on each state. The noise of 2 derivatives is the acceleration, which moves the position by
  // dt^2 / 2; that of 3 is a change of the acceleration at the start of the step, which does the same.
  Eigen::VectorXd effect(dim);
  const int on_position = dim == 2 ? 2 : dim - 1;
  for (int i = 0; i < dim; ++i) effect(i) = response(dt, on_position - i);
  return spread(variance * effect * effect.transpose(), axes, order);
}

Eigen::MatrixXd continuous_white_noise(int dim, double dt, double density, int axes, StateOrder order) {
  check(dim, dt, "density", density, axes);
  Eigen::MatrixXd Q(dim, dim);
  for (int i = 0; i < dim; ++i) {
    for (int j = 0; j < dim; ++j) {
      // Integral over the step of the responses s^a/a! and s^b/b! of derivatives i and j to the noise.
      const int a = dim - 1 - i, b = dim - 1 - j;
      Q(i, j) = density * response(dt, a) * response(dt, b) * dt / (a + b + 1);
    }
  }
  return spread(Q, axes, order);
}

}  // namespace survtrack
