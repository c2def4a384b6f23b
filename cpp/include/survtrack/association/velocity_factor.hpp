// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <algorithm>

namespace survtrack {

/// The velocity factor of a belief (Narayana 2007, fig. 8.6): falls linearly from 2 without a difference to 0.2 at
/// the break-point and beyond. Both arguments in the same unit, px per time unit; the break-point is above 0.
inline double falling_velocity_factor(double difference, double break_point) {
  return 2.0 - 1.8 * std::min(difference / break_point, 1.0);
}

/// The velocity factor of a match-matrix entry (fig. 4.12): the reciprocal, 0.5 to 5.
inline double velocity_factor(double difference, double break_point) {
  return 1.0 / falling_velocity_factor(difference, break_point);
}

}  // namespace survtrack
