// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "survtrack/filtering/noise_identification.hpp"

namespace survtrack {

/// The noises of a filter of constant velocity or acceleration, in its noise unit.
struct Noises {
  double process = 0.0;   ///< root of Q's density
  double position = 0.0;  ///< root of R
  double start_position = 0.0;  ///< deviation of a new track's position; 0: `position`
  double start_velocity = 0.0;
  double start_acceleration = 0.0;
};

/// All measurements, made ready for running a filter over them many times with other noises.
class Innovations {
 public:
  virtual ~Innovations() = default;
  virtual FilterConsistency judge(const Noises& noises) const = 0;  ///< without the bounds
};

std::unique_ptr<Innovations> make_innovations(const std::vector<MeasuredTrack>& tracks, const TunableOptions& options);

}  // namespace survtrack
