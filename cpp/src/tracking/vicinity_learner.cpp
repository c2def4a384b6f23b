// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "survtrack/tracking/vicinity_learner.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "survtrack/core/errors.hpp"

namespace survtrack {
namespace {

/// Centroids jitter by some of a pixel: no cell is known better.
constexpr double least_deviation_px = 0.5;
/// The mean and the spread of a cell follow its last thousand displacements.
constexpr double memory_updates = 1000.0;

std::string sides(int width, int height) { return std::to_string(width) + "x" + std::to_string(height); }

VicinityGrid new_grid(const GridVicinityOptions& options, int width, int height) {
  VicinityGrid grid;
  grid.cell_px = options.cell_px;
  grid.frame_width = width;
  grid.frame_height = height;
  grid.rows = (height + options.cell_px - 1) / options.cell_px;
  grid.columns = (width + options.cell_px - 1) / options.cell_px;
  grid.max_factor = options.max_factor;
  VicinityCell cell;
  cell.factor_y = cell.factor_x = 0.5 * (1.0 + options.max_factor);  // eq. 6.1
  grid.cells.assign(static_cast<std::size_t>(grid.rows) * static_cast<std::size_t>(grid.columns), cell);
  return grid;
}

/// The factor after a displacement of length `step`, in one direction.
double next_factor(const GridVicinityOptions& options, double factor, double step, double mean_step) {
  const double largest = options.max_factor;
  switch (options.form) {
    case VicinityForm::published_constant:
      return std::clamp(factor + (step - 1.0) * largest * options.learning_rate, 1.0, largest);
    case VicinityForm::published_mean:
      return std::clamp(factor + (step - mean_step) * largest * options.learning_rate, 1.0, largest);
    case VicinityForm::settling: break;
  }
  if (mean_step <= 0.0) return factor;  // nothing moved yet in this direction
  const double target = std::clamp(0.5 * (1.0 + largest) * step / mean_step, 1.0, largest);
  return factor + options.learning_rate * (target - factor);
}

void learn_speed(VicinityCell& cell, double step_px) {
  const double gain = 1.0 / std::min(static_cast<double>(cell.updates), memory_updates);
  const double before = step_px - cell.mean_step_px;
  cell.mean_step_px += gain * before;
  cell.step_variance_px2 = (1.0 - gain) * (cell.step_variance_px2 + gain * before * before);
}

}  // namespace

void VicinityLearner::check(int width, int height) const {
  if (width <= 0 || height <= 0) {
    throw InputError("detections.frame_size: is not known, and vicinity.model grid needs it; expected (width, height) in px");
  }
  if (options_.cell_px > std::min(width, height)) {
    throw InputError("vicinity.cell_px: " + std::to_string(options_.cell_px) + " is larger than the frame of " +
                     sides(width, height) + " px; expected at most " + std::to_string(std::min(width, height)));
  }
}

void VicinityLearner::update(const TrackTable& table, const Detections& detections) {
  anomalous_.clear();
  of_class(-1, detections);
  for (int i = 0; i < table.size(); ++i) {
    const OpenTrack& row = table.row(i);
    const Track& track = row.track;
    if (!row.believed() || track.detection < 0 || row.step_s <= 0.0) continue;
    const Detection& seen = detections.items[static_cast<std::size_t>(track.detection)];
    LearnedVicinity& learned = of_class(seen.class_id, detections);
    VicinityCell& cell = learned.grid.cells[learned.grid.index_of(row.seen_position)];
    // A displacement per time unit: after a missed frame it is no faster.
    const Point step = (table.time_unit_s() / row.step_s) * row.step_px;
    int& strange = strange_frames_[track.id];
    const double length = std::hypot(step.x, step.y);
    strange = is_anomalous(cell, length) ? strange + 1 : 0;
    if (strange == options_.anomaly_frames) anomalous_.push_back(track.id);
    learn_factor(learned, cell, step);
    // What is anomalous must not become the rule before it was told.
    if (strange == 0 || strange > options_.anomaly_frames) learn_speed(cell, length);
  }
  for (int i = 0; i < table.size(); ++i) {
    if (table.row(i).track.status == TrackStatus::closed) strange_frames_.erase(table.row(i).track.id);
  }
}

LearnedVicinity& VicinityLearner::of_class(int class_id, const Detections& detections) {
  const auto found = learned_.find(class_id);
  if (found != learned_.end()) return found->second;
  return learned_[class_id] = {new_grid(options_, detections.frame_width, detections.frame_height), {}};
}

bool VicinityLearner::is_anomalous(const VicinityCell& cell, double step_px) const {
  if (options_.anomaly_deviations <= 0.0 || cell.updates < options_.anomaly_after_updates) return false;
  const double deviation = std::max(std::sqrt(cell.step_variance_px2), least_deviation_px);
  return std::abs(step_px - cell.mean_step_px) > options_.anomaly_deviations * deviation;
}

void VicinityLearner::learn_factor(LearnedVicinity& learned, VicinityCell& cell, const Point& step) const {
  SceneMotion& motion = learned.motion;
  const double y = std::abs(step.y);
  const double x = std::abs(step.x);
  ++motion.updates;
  motion.mean_y_px += (y - motion.mean_y_px) / static_cast<double>(motion.updates);
  motion.mean_x_px += (x - motion.mean_x_px) / static_cast<double>(motion.updates);
  cell.factor_y = next_factor(options_, cell.factor_y, y, motion.mean_y_px);
  cell.factor_x = next_factor(options_, cell.factor_x, x, motion.mean_x_px);
  ++cell.updates;
}

void VicinityLearner::clear() {
  learned_.clear();
  strange_frames_.clear();
  anomalous_.clear();
}

}  // namespace survtrack
