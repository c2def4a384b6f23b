// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "survtrack/core/fields.hpp"
#include "survtrack/filtering/noise_unit.hpp"

namespace survtrack {

/// Kalman filter over a box: the state is centre x and y, width, height, and the rate of each, constant but for noise.
/// Lengths in `noise_unit`, times in the config's `time_unit_s`.
struct KalmanBoxOptions {
  static constexpr const char* model = "kalman_box";
  static constexpr const char* meaning = "Kalman filter over centre, width and height of the box, constant rates";

  NoiseUnit noise_unit = NoiseUnit::object_size;
  double velocity_noise = 0.75;
  double position_noise = 0.06;
  double initial_velocity = 1.0;
  double size_rate_noise = 0.05;
  double size_noise = 0.15;
  double initial_size_rate = 0.1;
  double lost_damping_time = 2.0;

  static constexpr auto fields() {
    using O = KalmanBoxOptions;
    return std::make_tuple(
        field("noise_unit", &O::noise_unit, "", "the length that noises are measured in"),
        field("velocity_noise", &O::velocity_noise, "length/unit",
              "standard deviation of the velocity gained or lost in one time unit (root of Q's density)", between(1e-6, 1e6)),
        field("position_noise", &O::position_noise, "length", "standard deviation of a measured centre (root of R)",
              between(1e-6, 1e6)),
        field("initial_velocity", &O::initial_velocity, "length/unit", "standard deviation of a new track's velocity",
              between(0, 1e6)),
        field("size_rate_noise", &O::size_rate_noise, "length/unit", "the same as velocity_noise of width and height",
              between(1e-6, 1e6)),
        field("size_noise", &O::size_noise, "length", "standard deviation of a measured width or height",
              between(1e-6, 1e6)),
        field("initial_size_rate", &O::initial_size_rate, "length/unit",
              "standard deviation of a new track's rates of width and height", between(0, 1e6)),
        field("lost_damping_time", &O::lost_damping_time, "unit",
              "the rates of an unmatched track fall by 1/e in this time; 0: they do not fall", between(0, 1e6)));
  }
};

}  // namespace survtrack
