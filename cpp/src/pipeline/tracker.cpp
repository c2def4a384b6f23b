// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "survtrack/pipeline/tracker.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/text_of.hpp"
#include "pipeline/track_events.hpp"
#include "survtrack/core/checks.hpp"
#include "survtrack/core/errors.hpp"
#include "survtrack/tracking/lost_place.hpp"

namespace survtrack {
namespace {

constexpr std::size_t most_costs = 1'000'000;

bool contains(const std::vector<std::int64_t>& ids, std::int64_t id) {
  return std::find(ids.begin(), ids.end(), id) != ids.end();
}

}  // namespace

Tracker::Tracker(const Config& config)
    : outputs_(config.check().outputs),
      table_(config.filter, config.measurement, config.reentry, config.time_unit_s),
      matcher_(config.cost, config.assignment, config.appearance),
      lifecycle_(make_lifecycle(config.lifecycle)) {
  if (const auto* shared = std::get_if<SharedBlobOptions>(&config.groups)) groups_.emplace(*shared);
  if (const auto* colors = std::get_if<ColorHistogramOptions>(&config.appearance)) {
    histograms_ = true;
    table_.keep_histograms(colors->refresh_rate);
  }
  if (const auto* grid = std::get_if<GridVicinityOptions>(&config.vicinity)) vicinity_.emplace(*grid);
  if (const auto* predicted = std::get_if<PredictedRegionsOptions>(&config.regions)) regions_.emplace(*predicted);
}

const Expectation& Tracker::predict(double time_s, int frame_width, int frame_height) {
  check_time(time_s, last_time_s_);
  last_time_s_ = time_s;
  predicted_ = true;
  table_.predict(time_s);
  expectation_.time_s = time_s;
  expectation_.scale = table_.scale().scale();
  if (vicinity_ && !vicinity_->learned().empty()) {
    // Blobs have no class.
    const auto found = vicinity_->learned().find(-1);
    if (found != vicinity_->learned().end()) expectation_.vicinity = found->second.grid;
  }
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
  if (regions_) {
    const cv::Size size = frame_width > 0 && frame_height > 0 ? cv::Size(frame_width, frame_height) : frame_size_.value_or(cv::Size());
    regions_->check(size.width, size.height);
    expectation_.regions.clear();
    expectation_.only_regions = size.area() > 0;
    if (size.area() > 0) regions_->plan(table_, size.width, size.height, expectation_.regions);
  }
  return expectation_;
}

void Tracker::check_frame_size(int width, int height) const {
  table_.check_frame_size(width, height);
  if (vicinity_) vicinity_->check(width, height);
  if (regions_) regions_->check(width, height);
  if (matcher_.belief()) matcher_.belief()->check(width, height);
  const cv::Size size(width, height);
  if (frame_size_ && size != *frame_size_ && size.area() > 0 && (vicinity_ || scene_loaded_)) {
    throw InputError("frame: is " + std::to_string(size.width) + "x" + std::to_string(size.height) +
                     " px, and the scene was learned on frames of " + std::to_string(frame_size_->width) + "x" +
                     std::to_string(frame_size_->height) + " px; expected the same size");
  }
}

void Tracker::check(const Detections& detections) const {
  check_frame_size(detections.frame_width, detections.frame_height);
  if (outputs_.cost_matrix && static_cast<std::size_t>(table_.size()) * detections.items.size() > most_costs) {
    throw InputError("outputs.cost_matrix: " + std::to_string(table_.size()) + " tracks by " +
                     std::to_string(detections.items.size()) + " detections are too many; expected at most a million entries");
  }
  if (histograms_ && detections.histograms.size() != detections.items.size()) {
    throw InputError("detections.histograms: are " + std::to_string(detections.histograms.size()) + " of " +
                     std::to_string(detections.items.size()) +
                     " detections; expected one each, with appearance.model color_histogram");
  }
  for (std::size_t i = 0; i < detections.items.size(); ++i) {
    const Detection& d = detections.items[i];
    const Box& b = d.box;
    const bool finite = std::isfinite(b.x) && std::isfinite(b.y) && std::isfinite(b.width) && std::isfinite(b.height) &&
                        std::isfinite(d.position.x) && std::isfinite(d.position.y);
    const Color& color = d.mean_color;
    const auto is_level = [](double level) { return level >= 0.0 && level <= 255.0; };
    if (!is_level(color.blue) || !is_level(color.green) || !is_level(color.red)) {
      throw InputError("detections[" + std::to_string(i) + "].mean_color: " + text_of({color.blue, color.green, color.red}) +
                       " is not allowed; expected 0 to 255 a channel");
    }
    const double smallest = 1e-3, limit = 1e9;
    if (finite && b.width >= smallest && b.height >= smallest && std::abs(b.x) < limit && std::abs(b.y) < limit &&
        b.width < limit && b.height < limit) {
      continue;
    }
    throw InputError("detections[" + std::to_string(i) + "].box: " + text_of({b.x, b.y, b.width, b.height}) +
                     " is not allowed; expected finite left and top, width and height of at least 0.001 px, all below 1e9 px");
  }
}

void Tracker::update(const Detections& detections, TrackingResult& result) {
  check(detections);
  if (!predicted_ || *last_time_s_ != detections.time_s) {
    throw InputError("detections.time_s: " + text_of(detections.time_s) +
                     " is not the time given to predict() before; expected one update after each predict");
  }
  predicted_ = false;
  if (detections.frame_width > 0 && detections.frame_height > 0) frame_size_ = cv::Size(detections.frame_width, detections.frame_height);
  table_.set_frame_size(detections.frame_width, detections.frame_height);
  matcher_.match(table_, detections, result.matches);
  if (groups_) groups_->update(table_, detections, result.matches);
  was_lost_.assign(static_cast<std::size_t>(table_.size()), 0);
  for (int i = 0; i < table_.size(); ++i) {
    was_lost_[static_cast<std::size_t>(i)] = table_.row(i).track.status == TrackStatus::lost;
    const int detection = result.matches.detection_of_track[static_cast<std::size_t>(i)];
    const int shared = groups_ ? groups_->shared_detection(i) : -1;
    if (shared >= 0) {
      table_.share(i, shared, detections);
    } else if (detection >= 0) {
      table_.match(i, detection, detections);
    } else {
      table_.miss(i);
    }
  }
  believed_before_.assign(static_cast<std::size_t>(table_.size()), 0);
  for (int i = 0; i < table_.size(); ++i) believed_before_[static_cast<std::size_t>(i)] = table_.row(i).believed();
  if (matcher_.belief()) convergence_.update(table_, matcher_.belief()->beliefs(), result.matches);
  result.matrix_track_ids.clear();
  for (int i = 0; i < table_.size(); ++i) result.matrix_track_ids.push_back(table_.row(i).track.id);
  lifecycle_->update(table_, detections, result.matches);
  table_.recognize();
  if (vicinity_) vicinity_->update(table_, detections);
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
    if (!old) result.events.push_back(start_of(table_.row(i), detections));
    if (lost_before && track.status == TrackStatus::confirmed) raise(EventKind::track_recovered);
    if (old && !lost_before && track.lost_frames > 0) raise(EventKind::track_lost);
    if (vicinity_ && contains(vicinity_->anomalous(), track.id)) raise(EventKind::anomalous_speed);
    if (track.status == TrackStatus::closed) {
      result.events.push_back(end_of(table_.row(i), lost_place(table_, i, detections), detections));
    }
  }
  for (const Convergence& met : convergence_.met()) result.events.push_back(meeting_of(met, detections));
  if (groups_) {
    for (const GroupChange& change : groups_->split()) result.events.push_back(change_of(EventKind::split, change, detections));
    for (const GroupChange& change : groups_->merged()) result.events.push_back(change_of(EventKind::merged, change, detections));
  }
  std::sort(result.tracks.begin(), result.tracks.end(), [](const Track& a, const Track& b) { return a.id < b.id; });
  result.has_matrices = outputs_.cost_matrix;
  if (outputs_.cost_matrix) {
    result.costs = matcher_.costs();
    if (matcher_.belief()) result.beliefs = matcher_.belief()->beliefs();
  }
  if (outputs_.vicinity) {
    result.vicinity.clear();
    for (const auto& [class_id, learned] : vicinity_->learned()) result.vicinity[class_id] = learned.grid;
  }
}

void Tracker::load_paths(const Paths& paths) {
  if (last_time_s_) throw InputError("paths: frames were processed already; expected paths before the first, or after reset()");
  const cv::Size drawn(paths.frame_width, paths.frame_height);
  if (frame_size_ && drawn.area() > 0 && drawn != *frame_size_) {
    throw InputError("paths.frame_size: " + std::to_string(drawn.width) + "x" + std::to_string(drawn.height) +
                     " px is not that of the learned scene, " + std::to_string(frame_size_->width) + "x" +
                     std::to_string(frame_size_->height) + " px; expected the same");
  }
  table_.set_paths(paths);
}

TrackingResult Tracker::process(const Detections& detections) {
  check(detections);
  predict(detections.time_s);
  TrackingResult result;
  update(detections, result);
  return result;
}

void Tracker::load_zones(const std::vector<Box>& zones) {
  if (!regions_ || !regions_->wants_zones()) {
    throw InputError("zones: this config has no use for them; expected regions.model predicted with regions.acquisition zones");
  }
  if (last_time_s_) throw InputError("zones: came after the first frame; expected before it, or after reset()");
  regions_->load_zones(zones);
}

void Tracker::reset() {
  table_.clear();
  lifecycle_->clear();
  if (matcher_.belief()) matcher_.belief()->clear();
  if (vicinity_) vicinity_->clear();
  convergence_.clear();
  if (groups_) groups_->clear();
  expectation_ = {};
  frame_size_.reset();
  scene_loaded_ = false;
  last_time_s_.reset();
  predicted_ = false;
}

}  // namespace survtrack
