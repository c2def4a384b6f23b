// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <Eigen/Core>

namespace survtrack {

/// Motion over a time dt, the same for x and y and independent of each other. State order: positions
/// (x, y), then velocities, then accelerations; `Order` is 2 (constant velocity, CV) or 3 (constant
/// acceleration, CA). The noise is white in the first derivative that is not modelled, with the continuous
/// Wiener form, so that two steps of dt/2 give the same as one of dt (Bar-Shalom, Li and Kirubarajan 2001,
/// 6.2.2 and 6.2.3).
template <int Order>
struct MotionModel {
  static constexpr int state_size = 2 * Order;
  using Matrix = Eigen::Matrix<double, state_size, state_size>;

  /// Transition F(dt).
  static Matrix transition(double dt) {
    Matrix F = Matrix::Identity();
    for (int axis = 0; axis < 2; ++axis) {
      for (int i = 0; i + 1 < Order; ++i) F(2 * i + axis, 2 * (i + 1) + axis) = dt;
      if (Order == 3) F(axis, 4 + axis) = 0.5 * dt * dt;
    }
    return F;
  }

  /// Process noise Q(dt) of unit spectral density; multiply by its real one.
  static Matrix unit_noise(double dt) {
    Matrix Q = Matrix::Zero();
    for (int axis = 0; axis < 2; ++axis) {
      for (int i = 0; i < Order; ++i) {
        for (int j = 0; j < Order; ++j) {
          // Integral over the step of the responses s^a/a! and s^b/b! of derivatives i and j to the noise.
          const int a = Order - 1 - i;
          const int b = Order - 1 - j;
          Q(2 * i + axis, 2 * j + axis) = power(dt, a + b + 1) / (factorial(a) * factorial(b) * (a + b + 1));
        }
      }
    }
    return Q;
  }

 private:
  static constexpr double factorial(int n) { return n < 2 ? 1.0 : n * factorial(n - 1); }
  static constexpr double power(double base, int n) { return n == 0 ? 1.0 : base * power(base, n - 1); }
};

using ConstantVelocity = MotionModel<2>;
using ConstantAcceleration = MotionModel<3>;

}  // namespace survtrack
