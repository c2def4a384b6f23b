// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <array>
#include <string>
#include <utility>

#include "survtrack/core/fields.hpp"
#include "survtrack/filtering/covariances.hpp"

namespace survtrack {

/// Where a new filter starts.
enum class FilterStart {
  detection,     ///< at the measured position
  frame_center,  ///< at (width / 2, height / 2), and is at once predicted by a step and corrected (Nashenda 2011)
};
constexpr auto enum_names(FilterStart) {
  return std::array{std::pair{"detection", FilterStart::detection}, std::pair{"frame_center", FilterStart::frame_center}};
}

/// Kalman filter with constant velocity whose covariances are given as printed: those of one step of `step_time`. The
/// state is (x, y, vx, vy) in px and px a time unit of the config. See `discrete_step` for frames that come late.
struct KalmanDiscreteOptions {
  static constexpr const char* model = "kalman_discrete";
  static constexpr const char* meaning = "Kalman filter, constant velocity, with the covariances of one step as given";

  std::array<double, 4> process_variances{1.0, 1.0, 400.0, 400.0};
  std::array<double, 3> measurement_covariance{4.0, 0.0, 4.0};
  std::array<double, 4> initial_variances{4.0, 4.0, 2500.0, 2500.0};
  std::array<double, 4> control_input{};
  double step_time = 1.0;
  FilterStart start = FilterStart::detection;
  Covariances covariances = Covariances::checked;

  static constexpr auto fields() {
    using O = KalmanDiscreteOptions;
    return std::make_tuple(
        field("process_variances", &O::process_variances, "px^2, (px/unit)^2",
              "diagonal of Q for x, y, vx, vy: what a step adds to the variances", between(0, 1e12)),
        field("measurement_covariance", &O::measurement_covariance, "px^2", "R as xx, xy, yy", between(-1e12, 1e12)),
        field("initial_variances", &O::initial_variances, "px^2, (px/unit)^2", "diagonal of a new filter's P",
              between(0, 1e12)),
        field("control_input", &O::control_input, "px, px/unit", "B u, which a step adds to x, y, vx, vy",
              between(-1e6, 1e6)),
        field("step_time", &O::step_time, "unit", "time of the step that Q and B u are given for", between(1e-6, 1e6)),
        field("start", &O::start, "", "where a new filter starts; frame_center needs the frame's size"),
        field("covariances", &O::covariances, "",
              "whether R has to be a covariance; as_published takes any, to reproduce what is printed"));
  }
};

/// Throws `ConfigError` that names the option and its smallest eigenvalue unless R is a covariance without which nothing
/// is measured exactly: positive definite. With `as_published` there is nothing to check.
void check_measurement_covariance(const KalmanDiscreteOptions& options, const std::string& path);

}  // namespace survtrack
