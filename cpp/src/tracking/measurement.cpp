// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "survtrack/tracking/measurement.hpp"

#include <algorithm>
#include <cmath>

namespace survtrack {

double OpenTrack::size_px() const { return std::sqrt(width_px * height_px); }

namespace {

/// Centre of an object of length `whole` of which [low, low + seen] is visible: the edge that agrees better with
/// the prediction is taken for the object's own.
double inferred_center(double low, double seen, double whole, double predicted) {
  const double from_low = low + 0.5 * whole;
  const double from_high = low + seen - 0.5 * whole;
  return std::abs(from_low - predicted) < std::abs(from_high - predicted) ? from_low : from_high;
}

double squared(double x) { return x * x; }

}  // namespace

Observation observe(const MeasurementOptions& options, const OpenTrack& track, const Point& predicted,
                    const Detection& detection) {
  Observation seen{measured_position(options, detection), {}};
  const auto* center = std::get_if<BoxCenterOptions>(&options);
  if (center == nullptr || !detection.shared) return seen;
  const Box& box = detection.box;
  // What differs from the known size is less certain.
  seen.extra_px2.xx = squared(0.5 * (box.width - track.width_px));
  seen.extra_px2.yy = squared(0.5 * (box.height - track.height_px));
  if (box.width < center->hidden_below * track.width_px) {
    seen.position.x = inferred_center(box.x, box.width, track.width_px, predicted.x);
  }
  if (box.height < center->hidden_below * track.height_px) {
    seen.position.y = inferred_center(box.y, box.height, track.height_px, predicted.y);
  }
  return seen;
}

Point measured_position(const MeasurementOptions& options, const Detection& detection) {
  return std::holds_alternative<BoxCenterOptions>(options) ? detection.box.center() : detection.position;
}

Box box_at(const MeasurementOptions& options, const OpenTrack& track, const Point& position) {
  if (std::holds_alternative<BoxCenterOptions>(options)) {
    return Box::around(position, track.width_px, track.height_px);
  }
  // The box keeps its place around the position: a centroid is not the box's centre.
  const Point moved = position - track.seen_position;
  return {track.seen.x + moved.x, track.seen.y + moved.y, track.seen.width, track.seen.height};
}

void learn_size(const MeasurementOptions& options, OpenTrack& track, const Detection& detection, double dt_s) {
  track.seen = detection.box;
  track.seen_position = measured_position(options, detection);
  const auto* center = std::get_if<BoxCenterOptions>(&options);
  if (center == nullptr) {
    track.width_px = detection.box.width;
    track.height_px = detection.box.height;
    return;
  }
  // A plain mean at first, later a mean with the time constant.
  double gain = std::max(1.0 / (track.size_samples + 1), std::min(1.0, dt_s / center->size_time_s));
  if (detection.shared) gain *= center->shared_size_gain;
  track.width_px += gain * (detection.box.width - track.width_px);
  track.height_px += gain * (detection.box.height - track.height_px);
  ++track.size_samples;
}

}  // namespace survtrack
