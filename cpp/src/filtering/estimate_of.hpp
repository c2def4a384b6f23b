// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "survtrack/filtering/filter_bank.hpp"

namespace survtrack {

/// The estimate of a state that begins with (x, y, vx, vy), and of its covariance.
template <class State, class Covariance>
Estimate estimate_of(const State& x, const Covariance& P, const Symmetric2& velocity_noise) {
  return {{x(0), x(1)},
          {x(2), x(3)},
          {P(0, 0), P(0, 1), P(1, 1)},
          {P(2, 2), P(2, 3), P(3, 3)},
          {P(0, 2), P(0, 3), P(1, 2), P(1, 3)},
          velocity_noise};
}

/// Noise that is the same in all directions.
inline Symmetric2 round_noise(double density) { return {density, 0.0, density}; }

}  // namespace survtrack
