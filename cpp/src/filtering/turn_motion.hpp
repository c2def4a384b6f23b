// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <Eigen/Core>
#include <complex>

#include "survtrack/core/geometry.hpp"
#include "survtrack/filtering/noise_unit.hpp"

namespace survtrack {

/// The numbers of the filters of turning objects that their options share.
struct TurnNoise {
  NoiseUnit unit;
  double velocity, turn_rate, turn_time, position, initial_velocity, lost_damping_time;

  template <class Options>
  explicit TurnNoise(const Options& o)
      : unit(o.noise_unit), velocity(o.velocity_noise), turn_rate(o.turn_rate), turn_time(o.turn_time),
        position(o.position_noise), initial_velocity(o.initial_velocity), lost_damping_time(o.lost_damping_time) {}

  double length(double object_size_px) const { return unit == NoiseUnit::px ? 1.0 : object_size_px; }
  /// Of the velocity's process noise beyond the turn, px^2 per time unit^3.
  double velocity_density(double length) const { return velocity * length * velocity * length; }
  Eigen::Matrix2d R(double length, const Symmetric2& extra_px2) const;
};

/// The coordinated turn over one step: state (x, y, vx, vy, w) with the turn rate w (Bar-Shalom, Li and Kirubarajan
/// 2001, 11.7). The velocity v = vx + i vy turns by e^(i w s) and, of a lost object, falls by e^(-s / tau), so that
/// v' = v e^z and p' = p + v dt (e^z - 1) / z with z = (i w - 1 / tau) dt. The turn rate falls by e^(-s / T) to 0, and the
/// step is taken at its mean.
class TurnMotion {
 public:
  using State = Eigen::Matrix<double, 5, 1>;
  using Matrix = Eigen::Matrix<double, 5, 5>;
  using LinearMatrix = Eigen::Matrix4d;  ///< of (x, y, vx, vy) where the turn rate is known

  /// `lost`: the velocity falls.
  TurnMotion(const TurnNoise& noise, double dt, bool lost);

  State moved(const State& x) const;
  /// The derivative of `moved`.
  Matrix jacobian(const State& x) const;
  /// Process noise of an object whose unit of noise is `length` px.
  Matrix noise(double length) const;

  LinearMatrix transition(double turn_rate) const;
  double turn_kept() const { return turn_kept_; }           ///< part of the turn rate that is left after the step
  double turn_variance() const { return turn_variance_; }  ///< what its variance gains in the step

 private:
  std::complex<double> exponent(double turn_rate) const { return {-decay_ * dt_, mean_turn_ * turn_rate * dt_}; }

  double dt_;
  double decay_;      ///< of the velocity, 1 / time unit
  double mean_turn_;  ///< mean turn rate over the step in parts of that at its start
  double turn_kept_, turn_variance_, velocity_density_;
};

/// What a new track's state is believed to be.
TurnMotion::State turn_start(const Point& position);
TurnMotion::Matrix turn_start_covariance(const TurnNoise& noise, double length);

}  // namespace survtrack
