// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "survtrack/tracking/track_table.hpp"

#include <algorithm>
#include <cmath>

#include "survtrack/tracking/path_bank.hpp"

namespace survtrack {
namespace {

/// Of two objects nearer than this part of their sides together, neither says something about the scene's scale.
constexpr double group_margin = 0.6;
/// What moves slower, in object sizes per second, says nothing about the scene's scale: it may be a ghost.
constexpr double scale_min_speed = 0.2;
/// Variance of what is not measured: far beyond any frame.
constexpr double unmeasured_px2 = 1e12;

/// How far [low, low + length] has to move to lie in [from, from + whole], or about its middle where it is longer.
double way_into(double low, double length, double from, double whole) {
  if (length >= whole) return from + 0.5 * whole - (low + 0.5 * length);
  return std::clamp(low, from, from + whole - length) - low;
}

std::unique_ptr<FilterBank> make_bank(const FilterOptions& filter) {
  if (const auto* path = std::get_if<KalmanPathOptions>(&filter)) return std::make_unique<PathBank>(*path);
  return make_filter_bank(filter);
}

/// Variances that a share adds to a measured size: what differs from the known one is less certain.
BoxSize share_px2(const Detection& detection, const OpenTrack& row) {
  if (!detection.shared) return {};
  const double width = detection.box.width - row.width_px, height = detection.box.height - row.height_px;
  return {width * width, height * height};
}

}  // namespace

TrackTable::TrackTable(const FilterOptions& filter, const MeasurementOptions& measurement, const ReentryOptions& reentry,
                       double time_unit_s)
    : measurement_(measurement), filters_(make_bank(filter)), time_unit_s_(time_unit_s) {
  if (const auto* remember = std::get_if<RememberOptions>(&reentry)) memory_.emplace(*remember);
}

void TrackTable::set_paths(const Paths& paths) {
  if (auto* bank = dynamic_cast<PathBank*>(filters_.get())) bank->set_paths(paths);
}

void TrackTable::predict(double time_s) {
  dt_s_ = started_ ? time_s - time_s_ : 0.0;
  time_s_ = time_s;
  started_ = true;
  if (dt_s_ > 0.0) filters_->predict(dt_s_ / time_unit_s_);
  for (int i = 0; i < size(); ++i) {
    OpenTrack& row = rows_[static_cast<std::size_t>(i)];
    row.track.predicted_position = filters_->predicted_position(i);
    follow_size(i);
    row.track.detection = -1;
  }
  find_near();
}

void TrackTable::find_near() {
  for (OpenTrack& row : rows_) row.near_another = false;
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    for (std::size_t j = i + 1; j < rows_.size(); ++j) {
      OpenTrack& a = rows_[i];
      OpenTrack& b = rows_[j];
      if (!a.believed() || !b.believed()) continue;
      const Point d = a.track.predicted_position - b.track.predicted_position;
      if (std::abs(d.x) < group_margin * (a.width_px + b.width_px) &&
          std::abs(d.y) < group_margin * (a.height_px + b.height_px)) {
        a.near_another = b.near_another = true;
      }
    }
  }
}

Observation TrackTable::observe(int i, const Detection& detection) const {
  return survtrack::observe(measurement_, row(i), predicted_position(i), detection);
}

TrackTable::Motion TrackTable::motion(int i) const {
  const Track& track = row(i).track;
  const double elapsed_s = time_s_ - row(i).seen_time_s;
  if (track.matched_frames < 2 || elapsed_s <= 0.0) return {};
  return {true, row(i).seen_position, time_unit_s_ * track.velocity_px_per_s, time_unit_s_ / elapsed_s};
}

void TrackTable::match(int i, int detection, const Detections& detections) {
  OpenTrack& row = rows_[static_cast<std::size_t>(i)];
  const Detection& seen = detections.items[static_cast<std::size_t>(detection)];
  const Observation observation = observe(i, seen);
  row.step_px = observation.position - row.seen_position;
  row.step_s = detections.time_s - row.seen_time_s;
  row.seen_time_s = detections.time_s;
  filters_->correct(i, observation.position, observation.extra_px2);
  filters_->correct_size(i, {seen.box.width, seen.box.height}, share_px2(seen, row));
  learn_size(measurement_, row, seen, dt_s_);
  follow_size(i);
  filters_->set_object_size(i, row.size_px());
  if (histogram_rate_ && !seen.shared) {
    survtrack::refresh(histograms_[static_cast<std::size_t>(i)], detections.histograms[static_cast<std::size_t>(detection)], *histogram_rate_);
  }
  Track& track = row.track;
  track.detection = detection;
  track.mean_color = seen.mean_color;
  track.lost_frames = 0;
  ++track.age_frames;
  ++track.matched_frames;
  track.end_index = detections.index;
  track.end_time_s = detections.time_s;
  refresh(i);
  row.seen_velocity_px_per_s = track.velocity_px_per_s;
  const Point from_start = track.position - row.start_position;
  row.travelled_px = std::max(row.travelled_px, std::hypot(from_start.x, from_start.y));
  const double speed = std::hypot(track.velocity_px_per_s.x, track.velocity_px_per_s.y);
  const bool alone = !row.near_another && !seen.shared;
  if (alone && row.believed() && detections.frame_height > 0 && speed > scale_min_speed * row.size_px() &&
      !touches_border(seen.box, detections.frame_width, detections.frame_height)) {
    scale_.add(seen.box, detections.frame_height);
  }
}

void TrackTable::share(int i, int detection, const Detections& detections) {
  OpenTrack& row = rows_[static_cast<std::size_t>(i)];
  const Box& blob = detections.items[static_cast<std::size_t>(detection)].box;
  const Box predicted = predicted_box(i);
  const Point way{way_into(predicted.x, predicted.width, blob.x, blob.width),
                  way_into(predicted.y, predicted.height, blob.y, blob.height)};
  if (way.x != 0.0 || way.y != 0.0) {
    // All places in the box are equally likely: within it nothing is measured, from outside its edge is.
    const Symmetric2 extra_px2{way.x == 0.0 ? unmeasured_px2 : 0.0, 0.0, way.y == 0.0 ? unmeasured_px2 : 0.0};
    filters_->correct(i, predicted_position(i) + way, extra_px2);
  }
  row.step_px = {};
  row.step_s = 0.0;
  Track& track = row.track;
  track.detection = detection;
  track.lost_frames = 0;
  ++track.age_frames;
  ++track.matched_frames;
  track.end_index = detections.index;
  track.end_time_s = detections.time_s;
  refresh(i);
}

void TrackTable::miss(int i) {
  Track& track = rows_[static_cast<std::size_t>(i)].track;
  ++track.age_frames;
  ++track.lost_frames;
  refresh(i);
}

void TrackTable::restart(int i) {
  OpenTrack& row = rows_[static_cast<std::size_t>(i)];
  filters_->restart(i, row.seen_position, row.size_px());
  filters_->start_size(i, {row.seen.width, row.seen.height});
  follow_size(i);
  row.step_px = {};
  row.step_s = 0.0;
  refresh(i);
}

int TrackTable::start(int detection, const Detections& detections) {
  const Detection& seen = detections.items[static_cast<std::size_t>(detection)];
  OpenTrack row;
  row.width_px = seen.box.width;
  row.height_px = seen.box.height;
  row.size_samples = 1;
  row.start_position = row.seen_position = measured_position(measurement_, seen);
  row.seen = seen.box;
  row.track.predicted_position = row.start_position;
  row.track.mean_color = seen.mean_color;
  row.track.detection = detection;
  row.track.matched_frames = 1;
  row.track.start_index = row.track.end_index = detections.index;
  row.track.start_time_s = row.track.end_time_s = row.seen_time_s = detections.time_s;
  filters_->start_size(filters_->add(row.start_position, row.size_px()), {seen.box.width, seen.box.height});
  rows_.push_back(row);
  if (histogram_rate_) histograms_.push_back(detections.histograms[static_cast<std::size_t>(detection)]);
  refresh(size() - 1);
  return size() - 1;
}

void TrackTable::believe(int i) {
  Track& track = rows_[static_cast<std::size_t>(i)].track;
  track.id = ++last_id_;
  track.status = TrackStatus::confirmed;
}

void TrackTable::recognize() {
  if (!memory_) return;
  std::vector<OpenTrack*> found;
  for (OpenTrack& row : rows_) {
    if (row.track.id > last_known_id_) found.push_back(&row);
  }
  std::sort(found.begin(), found.end(), [](const auto* a, const auto* b) { return a->track.id < b->track.id; });
  const auto identities = memory_->claim({found.begin(), found.end()});
  last_id_ = last_known_id_;
  for (std::size_t k = 0; k < found.size(); ++k) {
    const bool known = identities[k].id != 0;
    found[k]->track.id = known ? identities[k].id : ++last_id_;
    found[k]->reentry_confidence = identities[k].confidence;
  }
  last_known_id_ = last_id_;
}

void TrackTable::remove_closed() {
  for (int i = size() - 1; i >= 0; --i) {
    if (row(i).track.status != TrackStatus::closed) continue;
    if (memory_ && row(i).believed()) memory_->remember(row(i));
    filters_->remove(i);
    rows_.erase(rows_.begin() + i);
    if (histogram_rate_) histograms_.erase(histograms_.begin() + i);
  }
}

void TrackTable::clear() {
  filters_->clear();
  rows_.clear();
  histograms_.clear();
  scale_.clear();
  if (memory_) memory_->clear();
  last_id_ = last_known_id_ = 0;
  started_ = false;
}

void TrackTable::refresh(int i) {
  OpenTrack& row = rows_[static_cast<std::size_t>(i)];
  const Estimate now = filters_->estimate(i);
  row.track.position = now.position;
  row.track.velocity_px_per_s = (1.0 / time_unit_s_) * now.velocity;
  row.track.position_covariance_px2 = now.covariance_px2;
  const double per_s = 1.0 / time_unit_s_;
  row.track.velocity_covariance_px2_per_s2 = per_s * per_s * now.velocity_covariance;
  row.track.position_velocity_covariance_px2_per_s = per_s * now.cross_covariance;
  row.track.velocity_noise_px2_per_s3 = per_s * per_s * per_s * now.velocity_noise;
  row.track.box = box_at(measurement_, row, now.position);
}

void TrackTable::follow_size(int i) {
  const std::optional<BoxSize> size = filters_->box_size(i);
  if (!size) return;
  OpenTrack& row = rows_[static_cast<std::size_t>(i)];
  row.width_px = size->width_px;
  row.height_px = size->height_px;
}

}  // namespace survtrack
