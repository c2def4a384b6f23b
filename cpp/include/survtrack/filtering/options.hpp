// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <array>
#include <utility>
#include <variant>

#include "survtrack/core/fields.hpp"
#include "survtrack/filtering/box_options.hpp"
#include "survtrack/filtering/discrete_options.hpp"
#include "survtrack/filtering/noise_unit.hpp"
#include "survtrack/filtering/path_options.hpp"
#include "survtrack/filtering/turn_options.hpp"

namespace survtrack {

/// How a filter's process noise Q is made.
enum class NoiseForm {
  continuous,  ///< of white noise in the highest derivative: two half steps are one whole
  identity,    ///< the same variance for every state: q^2 dt I (Semko 2007, IV.D)
};
constexpr auto enum_names(NoiseForm) {
  return std::array{std::pair{"continuous", NoiseForm::continuous}, std::pair{"identity", NoiseForm::identity}};
}

/// Kalman filter with constant velocity. Lengths in `noise_unit`, times in the config's `time_unit_s`.
struct KalmanCvOptions {
  static constexpr const char* model = "kalman_cv";
  static constexpr const char* meaning = "Kalman filter, constant velocity";

  NoiseUnit noise_unit = NoiseUnit::object_size;
  double velocity_noise = 0.75;
  double position_noise = 0.06;
  double initial_velocity = 1.0;
  double lost_damping_time = 2.0;

  static constexpr auto fields() {
    using O = KalmanCvOptions;
    return std::make_tuple(
        field("noise_unit", &O::noise_unit, "", "the length that noises are measured in"),
        field("velocity_noise", &O::velocity_noise, "length/unit",
              "standard deviation of the velocity gained or lost in one time unit (root of Q's density)", between(1e-6, 1e6)),
        field("position_noise", &O::position_noise, "length", "standard deviation of a measured position (root of R)",
              between(1e-6, 1e6)),
        field("initial_velocity", &O::initial_velocity, "length/unit", "standard deviation of a new track's velocity",
              between(0, 1e6)),
        field("lost_damping_time", &O::lost_damping_time, "unit",
              "the velocity of an unmatched track falls by 1/e in this time; 0: it does not fall", between(0, 1e6)));
  }
};

/// Kalman filter with constant acceleration. Lengths in `noise_unit`, times in the config's `time_unit_s`.
struct KalmanCaOptions {
  static constexpr const char* model = "kalman_ca";
  static constexpr const char* meaning = "Kalman filter, constant acceleration";

  NoiseUnit noise_unit = NoiseUnit::object_size;
  double acceleration_noise = 0.4;
  NoiseForm noise_form = NoiseForm::continuous;
  double position_noise = 0.06;
  double initial_position = 0.0;
  double initial_velocity = 1.0;
  double initial_acceleration = 0.5;

  static constexpr auto fields() {
    using O = KalmanCaOptions;
    return std::make_tuple(
        field("noise_unit", &O::noise_unit, "", "the length that noises are measured in"),
        field("acceleration_noise", &O::acceleration_noise, "length/unit^2",
              "standard deviation of the acceleration gained or lost in one time unit (root of Q's density)", between(1e-6, 1e6)),
        field("noise_form", &O::noise_form, "",
              "how Q is made; identity: the square of acceleration_noise is the variance that each state gains in one time unit"),
        field("position_noise", &O::position_noise, "length", "standard deviation of a measured position (root of R)",
              between(1e-6, 1e6)),
        field("initial_position", &O::initial_position, "length",
              "standard deviation of a new track's position; 0: that of a measured one", between(0, 1e6)),
        field("initial_velocity", &O::initial_velocity, "length/unit", "standard deviation of a new track's velocity",
              between(0, 1e6)),
        field("initial_acceleration", &O::initial_acceleration, "length/unit^2",
              "standard deviation of a new track's acceleration", between(0, 1e6)));
  }
};

/// Narayana 2007, 3.4: the position is the one measured, the velocity the mean displacement over the last
/// steps, the prediction their sum. All change on a match only.
struct MeanVelocityOptions {
  static constexpr const char* model = "mean_velocity";
  static constexpr const char* meaning = "mean displacement over the last steps (Narayana 2007, 3.4)";

  int window_steps = 5;
  bool extrapolate_lost = false;

  static constexpr auto fields() {
    using O = MeanVelocityOptions;
    return std::make_tuple(
        field("window_steps", &O::window_steps, "steps", "steps of the mean", between(1, 1000)),
        field("extrapolate_lost", &O::extrapolate_lost, "",
              "a lost track moves on with its velocity; published: it stays frozen"));
  }
};

using FilterOptions = std::variant<KalmanCvOptions, KalmanCaOptions, MeanVelocityOptions, KalmanDiscreteOptions,
                                   KalmanBoxOptions, KalmanPathOptions, ExtendedOptions, UnscentedOptions, ParticleOptions>;

}  // namespace survtrack
