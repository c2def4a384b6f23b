// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <algorithm>
#include <vector>

#include "survtrack/core/detection.hpp"
#include "survtrack/pipeline/config.hpp"

namespace survtrack {

/// The tracker of Narayana 2007, whose numbers all stand here: times are counted in frames, a track a blob at once.
/// Its time unit is the frame period of a `BoxRun`.
inline Config counted_config() {
  Config config;
  config.time_unit_s = 0.1;
  config.filter = MeanVelocityOptions{.window_steps = 5, .extrapolate_lost = false};
  config.measurement = CentroidOptions{};
  config.cost = MatchMatrixOptions{};
  config.assignment = OldestFirstOptions{};
  config.lifecycle = LostCountOptions{.lost_after_frames = 5};
  return config;
}

/// The same with fixed densities of belief, and the matrices as outputs.
inline Config belief_config() {
  Config config = counted_config();
  config.cost = BeliefOptions{.order = BeliefOrder::free,
                              .velocity_break_point = 0.0,
                              .color_weight = 30.0,
                              .position_weight = 30.0,
                              .size_weight = 0.0,
                              .color_space = ColorSpace::bgr,
                              .learn_after = 0};
  config.outputs.cost_matrix = true;
  return config;
}

/// A blob of 12x12 px about a point, in one grey level.
inline Detection blob_at(double x, double y, double level = 100.0) {
  Detection blob = detection_of_box(Box::around({x, y}, 12.0, 12.0));
  blob.mean_color = {level, level, level};
  return blob;
}

}  // namespace survtrack
