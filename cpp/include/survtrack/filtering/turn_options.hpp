// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <tuple>

#include "survtrack/core/fields.hpp"
#include "survtrack/filtering/noise_unit.hpp"

namespace survtrack {

/// What the filters of turning objects share. Their motion is the coordinated turn with the state (x, y, vx, vy, turn
/// rate) (Bar-Shalom, Li and Kirubarajan 2001, 11.7): with the velocity as a vector nothing is singular where the object
/// stands, as a heading would be. The turn rate is forgotten over `turn_time`, which bounds its variance while nothing
/// tells of it. Lengths in `noise_unit`, times in the config's `time_unit_s`, angles in rad, clockwise in the image.
template <class O>
constexpr auto turn_fields() {
  return std::make_tuple(
      field("noise_unit", &O::noise_unit, "", "the length that noises are measured in"),
      field("velocity_noise", &O::velocity_noise, "length/unit",
            "standard deviation of the velocity gained or lost in one time unit beyond the turn (root of Q's density)",
            between(1e-6, 1e6)),
      field("turn_rate", &O::turn_rate, "rad/unit", "standard deviation of the turn rate", between(1e-6, 1e3)),
      field("turn_time", &O::turn_time, "unit", "the turn rate is forgotten to 1/e in this time", between(1e-3, 1e6)),
      field("position_noise", &O::position_noise, "length", "standard deviation of a measured position (root of R)",
            between(1e-6, 1e6)),
      field("initial_velocity", &O::initial_velocity, "length/unit", "standard deviation of a new track's velocity",
            between(0, 1e6)),
      field("lost_damping_time", &O::lost_damping_time, "unit",
            "the velocity of an unmatched track falls by 1/e in this time; 0: it does not fall", between(0, 1e6)));
}

/// Coordinated turns by a filter that is linearised where the estimate is (`ExtendedKalmanFilter`).
struct ExtendedOptions {
  static constexpr const char* model = "extended";
  static constexpr const char* meaning = "extended Kalman filter, coordinated turn";

  NoiseUnit noise_unit = NoiseUnit::object_size;
  double velocity_noise = 0.75;
  double turn_rate = 0.5;
  double turn_time = 1.0;
  double position_noise = 0.06;
  double initial_velocity = 1.0;
  double lost_damping_time = 2.0;

  static constexpr auto fields() { return turn_fields<ExtendedOptions>(); }
};

/// Coordinated turns by sigma points (`UnscentedKalmanFilter`).
struct UnscentedOptions {
  static constexpr const char* model = "unscented";
  static constexpr const char* meaning = "unscented Kalman filter, coordinated turn";

  NoiseUnit noise_unit = NoiseUnit::object_size;
  double velocity_noise = 0.75;
  double turn_rate = 0.5;
  double turn_time = 1.0;
  double position_noise = 0.06;
  double initial_velocity = 1.0;
  double lost_damping_time = 2.0;
  double alpha = 0.5;
  double beta = 2.0;

  static constexpr auto fields() {
    using O = UnscentedOptions;
    // With beta at least alpha^2 the predicted covariance has no eigenvalue below 0.
    return std::tuple_cat(turn_fields<O>(),
                          std::make_tuple(field("alpha", &O::alpha, "", "spread of the sigma points", between(1e-3, 1)),
                                          field("beta", &O::beta, "", "weight of the middle one in covariances; 2 is that of a Gaussian",
                                                between(1, 1e6))));
  }
};

/// Coordinated turns by particles: each is a turn rate and, since with that known the rest is linear, a Kalman filter
/// (marginalised particle filter: Schon, Gustafsson and Nordlund 2005).
struct ParticleOptions {
  static constexpr const char* model = "particle";
  static constexpr const char* meaning = "particle filter, coordinated turn";

  NoiseUnit noise_unit = NoiseUnit::object_size;
  double velocity_noise = 0.75;
  double turn_rate = 0.5;
  double turn_time = 1.0;
  double position_noise = 0.06;
  double initial_velocity = 1.0;
  double lost_damping_time = 2.0;
  int particles = 100;
  double resample_below = 0.5;
  int seed = 0;

  static constexpr auto fields() {
    using O = ParticleOptions;
    return std::tuple_cat(
        turn_fields<O>(),
        std::make_tuple(field("particles", &O::particles, "particles", "of each track", between(1, 1e5)),
                        field("resample_below", &O::resample_below, "",
                              "drawn anew when the effective sample size falls under this share of them; 0: never", between(0, 1)),
                        field("seed", &O::seed, "", "of the random numbers; each track has its own, by its turn of birth",
                              between(0, 2147483647))));
  }
};

}  // namespace survtrack
