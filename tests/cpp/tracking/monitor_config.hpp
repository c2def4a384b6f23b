// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "survtrack/pipeline/config.hpp"

namespace survtrack {

/// The contact monitor of Semko 2007: counts of frames of a `BoxRun`, noises in px.
inline Config monitor_config(int median_frames = 25) {
  Config config;
  config.time_unit_s = 0.1;
  config.filter = KalmanCaOptions{.noise_unit = NoiseUnit::px,
                                  .acceleration_noise = 0.7071067811865476,
                                  .noise_form = NoiseForm::identity,
                                  .position_noise = 1.0,
                                  .initial_position = 3.0,
                                  .initial_velocity = 5.0,
                                  .initial_acceleration = 7.0};
  config.measurement = CentroidOptions{};
  config.cost = DistanceOptions{.max_distance_px = 0.0};
  config.assignment = HungarianOptions{.confirmed_first = false};
  config.lifecycle = CountMedianOptions{
      .median_frames = median_frames, .max_contacts = 10, .keep_contacts = false, .restart_after_s = 0.0};
  return config;
}

}  // namespace survtrack
