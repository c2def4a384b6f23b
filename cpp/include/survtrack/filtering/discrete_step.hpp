// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <Eigen/Core>
#include <array>

namespace survtrack {

/// A prediction x = F x + Bu, P = F P F' + Q of a state (x, y, vx, vy).
struct DiscreteStep {
  Eigen::Matrix4d F;
  Eigen::Matrix4d Q;
  Eigen::Vector4d Bu;
};

/// The prediction over a time `dt` by a filter of which the diagonal of Q and B u are given for one step of `step_time`.
/// On time (dt = step_time) it is that step. After missing frames it is as many steps as went by, to the nearest whole
/// one: n predictions of dt / n, in one. What such a step is shorter or longer than step_time, it adds less or more of Q
/// and B u, in proportion.
DiscreteStep discrete_step(const std::array<double, 4>& process_variances, const std::array<double, 4>& control_input,
                           double step_time, double dt);

}  // namespace survtrack
