// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <array>

#include "survtrack/core/fields.hpp"

namespace survtrack {

/// Kalman filter along a path (O'Malley 2000): the state is S and T, along and across the nearest of the paths that were
/// loaded, and their rates. All are those of one step of `step_time`, as in KalmanDiscreteOptions.
struct KalmanPathOptions {
  static constexpr const char* model = "kalman_path";
  static constexpr const char* meaning = "Kalman filter along and across the nearest path (O'Malley 2000)";

  std::array<double, 4> process_variances{1.0, 1.0, 400.0, 25.0};
  std::array<double, 2> measurement_variances{4.0, 4.0};
  std::array<double, 4> initial_variances{4.0, 4.0, 10000.0, 100.0};
  std::array<double, 2> initial_velocity{};
  double step_time = 1.0;
  double unit_px = 1.0;

  static constexpr auto fields() {
    using O = KalmanPathOptions;
    return std::make_tuple(
        field("process_variances", &O::process_variances, "length^2, (length/unit)^2",
              "diagonal of Q for S, T, vS, vT: what a step adds to the variances", between(0, 1e12)),
        field("measurement_variances", &O::measurement_variances, "length^2", "diagonal of R for S, T",
              between(1e-12, 1e12)),
        field("initial_variances", &O::initial_variances, "length^2, (length/unit)^2", "diagonal of a new filter's P",
              between(0, 1e12)),
        field("initial_velocity", &O::initial_velocity, "length/unit", "vS, vT of a new filter", between(-1e6, 1e6)),
        field("step_time", &O::step_time, "unit", "time of the step that Q is given for", between(1e-6, 1e6)),
        field("unit_px", &O::unit_px, "px", "length that the others are measured in", between(1e-6, 1e6)));
  }
};

}  // namespace survtrack
