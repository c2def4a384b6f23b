// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "survtrack/core/detection.hpp"
#include "survtrack/core/vicinity_grid.hpp"
#include "survtrack/tracking/options.hpp"
#include "survtrack/tracking/track_table.hpp"

namespace survtrack {

/// The mean displacement of the whole scene, px per time unit.
struct SceneMotion {
  double mean_y_px = 0.0;
  double mean_x_px = 0.0;
  std::int64_t updates = 0;
};

/// One grid with what it takes to go on learning.
struct LearnedVicinity {
  VicinityGrid grid;
  SceneMotion motion;
};

/// Learns the vicinity factor (Narayana 2007, 6), a grid per class of detections, and tells whose speed is anomalous
/// in its cell (11.3).
class VicinityLearner {
 public:
  explicit VicinityLearner(const GridVicinityOptions& options) : options_(options) {}

  /// Throws `InputError` for a frame of unknown size, or smaller than a cell. All frames of a learner
  /// have one size.
  void check(int frame_width, int frame_height) const;

  /// Learns from the tracks matched in this frame. The ids of those whose speed became anomalous: `anomalous()`.
  void update(const TrackTable& table, const Detections& detections);
  const std::vector<std::int64_t>& anomalous() const { return anomalous_; }

  /// The grids by class (-1: detections without class).
  const std::map<int, LearnedVicinity>& learned() const { return learned_; }
  void restore(const std::map<int, LearnedVicinity>& learned) { learned_ = learned; }
  const GridVicinityOptions& options() const { return options_; }
  void clear();

 private:
  LearnedVicinity& of_class(int class_id, const Detections& detections);
  void learn_factor(LearnedVicinity& learned, VicinityCell& cell, const Point& step) const;
  bool is_anomalous(const VicinityCell& cell, double step_px) const;

  GridVicinityOptions options_;
  std::map<int, LearnedVicinity> learned_;
  std::map<std::int64_t, int> strange_frames_;  ///< in a row, by track id
  std::vector<std::int64_t> anomalous_;
};

}  // namespace survtrack
