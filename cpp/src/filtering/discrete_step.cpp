// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "survtrack/filtering/discrete_step.hpp"

#include <algorithm>
#include <cmath>

#include "survtrack/filtering/motion_model.hpp"

namespace survtrack {

DiscreteStep discrete_step(const std::array<double, 4>& process_variances, const std::array<double, 4>& control_input,
                           double step_time, double dt) {
  const double n = std::max(1.0, std::round(dt / step_time));
  const double h = dt / n;              // of one of them
  const double part = h / step_time;
  // Sums over the steps i = 0 to n - 1 that a change of the velocity still has before it.
  const double first = 0.5 * n * (n - 1.0) * h;                              // of i h
  const double second = n * (n - 1.0) * (2.0 * n - 1.0) / 6.0 * h * h;      // of (i h)^2
  DiscreteStep step;
  step.F = ConstantVelocity::transition(dt);
  step.Q.setZero();
  for (int axis = 0; axis < 2; ++axis) {
    const auto p = static_cast<std::size_t>(axis), v = p + 2;
    const double position = part * process_variances[p], velocity = part * process_variances[v];
    step.Q(axis, axis) = n * position + second * velocity;
    step.Q(axis, axis + 2) = step.Q(axis + 2, axis) = first * velocity;
    step.Q(axis + 2, axis + 2) = n * velocity;
    step.Bu(axis) = part * (n * control_input[p] + first * control_input[v]);
    step.Bu(axis + 2) = part * n * control_input[v];
  }
  return step;
}

}  // namespace survtrack
