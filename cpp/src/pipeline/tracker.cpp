// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "survtrack/pipeline/tracker.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "survtrack/core/checks.hpp"
#include "survtrack/core/errors.hpp"

namespace survtrack {
namespace {

constexpr std::size_t most_costs = 1'000'000;

Event event_of(EventKind kind, const Track& track, const Detections& now) {
  Event event;
  event.kind = kind;
  event.index = now.index;
  event.time_s = now.time_s;
  event.track_id = track.id;
  event.position = track.position;
  event.box = track.box;
  event.position_covariance_px2 = track.position_covariance_px2;
  const std::string name = "track " + std::to_string(track.id);
  switch (kind) {
    case EventKind::track_started: event.text = name + " started"; break;
    case EventKind::track_lost: event.text = name + " was lost"; break;
    case EventKind::track_recovered: event.text = name + " was found again"; break;
    default: event.text = name + " ended"; break;
  }
  return event;
}

}  // namespace

Tracker::Tracker(const Config& config)
    : outputs_(config.check().outputs),
      table_(config.filter, config.measurement, config.time_unit_s),
      matcher_(config.cost, config.assignment),
      lifecycle_(make_lifecycle(config.lifecycle)) {}

const Expectation& Tracker::predict(double time_s) {
  check_time(time_s, last_time_s_);
  last_time_s_ = time_s;
  predicted_ = true;
  table_.predict(time_s);
  expectation_.time_s = time_s;
  expectation_.scale = table_.scale();
  expectation_.tracks.resize(static_cast<std::size_t>(table_.size()));
  for (int i = 0; i < table_.size(); ++i) {
    const OpenTrack& row = table_.row(i);
    PredictedTrack& expected = expectation_.tracks[static_cast<std::size_t>(i)];
    expected.id = row.track.id;
    expected.confirmed = row.believed();
    expected.box = table_.predicted_box(i);
    expected.position = row.track.predicted_position;
    expected.velocity_px_per_s = row.track.velocity_px_per_s;
    expected.innovation_covariance_px2 = table_.innovation_covariance_px2(i);
    expected.lost_s = time_s - row.track.end_time_s;
  }
  return expectation_;
}

void Tracker::check(const Detections& detections) const {
  if (outputs_.cost_matrix && static_cast<std::size_t>(table_.size()) * detections.items.size() > most_costs) {
    throw InputError("outputs.cost_matrix: " + std::to_string(table_.size()) + " tracks by " +
                     std::to_string(detections.items.size()) + " detections are too many; expected at most a million entries");
  }
  for (std::size_t i = 0; i < detections.items.size(); ++i) {
    const Detection& d = detections.items[i];
    const Box& b = d.box;
    const bool finite = std::isfinite(b.x) && std::isfinite(b.y) && std::isfinite(b.width) && std::isfinite(b.height) &&
                        std::isfinite(d.position.x) && std::isfinite(d.position.y);
    const Color& color = d.mean_color;
    if (!std::isfinite(color.blue) || !std::isfinite(color.green) || !std::isfinite(color.red)) {
      throw InputError("detections[" + std::to_string(i) + "].mean_color: is not finite; expected 0 to 255 a channel");
    }
    const double smallest = 1e-3, limit = 1e9;
    if (finite && b.width >= smallest && b.height >= smallest && std::abs(b.x) < limit && std::abs(b.y) < limit &&
        b.width < limit && b.height < limit) {
      continue;
    }
    throw InputError("detections[" + std::to_string(i) + "].box: (" + std::to_string(b.x) + ", " + std::to_string(b.y) +
                     ", " + std::to_string(b.width) + ", " + std::to_string(b.height) +
                     ") is not allowed; expected finite left and top, width and height of at least 0.001 px, all below 1e9 px");
  }
}

void Tracker::update(const Detections& detections, TrackingResult& result) {
  check(detections);
  if (!predicted_ || *last_time_s_ != detections.time_s) {
    throw InputError("detections.time_s: " + std::to_string(detections.time_s) +
                     " is not the time given to predict() before; expected one update after each predict");
  }
  predicted_ = false;
  matcher_.match(table_, detections, result.matches);
  was_lost_.assign(static_cast<std::size_t>(table_.size()), 0);
  for (int i = 0; i < table_.size(); ++i) {
    was_lost_[static_cast<std::size_t>(i)] = table_.row(i).track.status == TrackStatus::lost;
    const int detection = result.matches.detection_of_track[static_cast<std::size_t>(i)];
    if (detection >= 0) {
      table_.match(i, detection, detections);
    } else {
      table_.miss(i);
    }
  }
  believed_before_.assign(static_cast<std::size_t>(table_.size()), 0);
  for (int i = 0; i < table_.size(); ++i) believed_before_[static_cast<std::size_t>(i)] = table_.row(i).believed();
  lifecycle_->update(table_, detections, result.matches);
  report(detections, result);
  table_.remove_closed();
}

void Tracker::report(const Detections& detections, TrackingResult& result) {
  result.index = detections.index;
  result.time_s = detections.time_s;
  result.events = detections.events;
  result.tracks.clear();
  result.tentative.clear();
  for (int i = 0; i < table_.size(); ++i) {
    const Track& track = table_.row(i).track;
    (table_.row(i).believed() ? result.tracks : result.tentative).push_back(track);
    if (!table_.row(i).believed()) continue;
    const auto at = static_cast<std::size_t>(i);
    const bool old = at < believed_before_.size() && believed_before_[at] != 0;
    const bool lost_before = old && was_lost_[at] != 0;
    const auto raise = [&](EventKind kind) { result.events.push_back(event_of(kind, track, detections)); };
    if (!old) raise(EventKind::track_started);
    if (lost_before && track.status == TrackStatus::confirmed) raise(EventKind::track_recovered);
    if (old && !lost_before && track.lost_frames > 0) raise(EventKind::track_lost);
    if (track.status == TrackStatus::closed) raise(EventKind::track_ended);
  }
  std::sort(result.tracks.begin(), result.tracks.end(), [](const Track& a, const Track& b) { return a.id < b.id; });
  if (outputs_.cost_matrix) result.costs = matcher_.costs();
}

TrackingResult Tracker::process(const Detections& detections) {
  check(detections);
  predict(detections.time_s);
  TrackingResult result;
  update(detections, result);
  return result;
}

void Tracker::reset() {
  table_.clear();
  expectation_ = {};
  last_time_s_.reset();
  predicted_ = false;
}

}  // namespace survtrack
