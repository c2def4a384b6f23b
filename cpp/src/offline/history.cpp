// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "survtrack/offline/history.hpp"

#include <algorithm>
#include <initializer_list>
#include <string>
#include <utility>

#include "core/text_of.hpp"
#include "survtrack/core/errors.hpp"

namespace survtrack {
namespace {

constexpr double largest_px = 1e9, smallest_px = 1e-3, largest_s = 1e12, largest_px_per_s = 1e12;

bool within(std::initializer_list<double> values, double low, double high) {
  return std::all_of(values.begin(), values.end(), [&](double value) { return value >= low && value <= high; });
}

std::string where(const RecordedTrack& track, const TrackPoint& point) {
  return "track " + std::to_string(track.id) + ", frame index " + std::to_string(point.index) + ": ";
}

void check_point(const RecordedTrack& track, const TrackPoint& point) {
  const auto demand = [&](const char* name, std::initializer_list<double> values, double low, double high,
                          const char* expected) {
    if (within(values, low, high)) return;
    throw InputError(where(track, point) + name + " " + (values.size() > 1 ? text_of(values) : text_of(*values.begin())) + " is not allowed; expected " + expected);
  };
  if (point.index < 0) throw InputError(where(track, point) + "frames count from 0");
  const Box& box = point.box;
  const Color& color = point.mean_color;
  demand("time_s", {point.time_s}, -largest_s, largest_s, "a finite number of seconds within +-1e12");
  demand("box left and top", {box.x, box.y}, -largest_px, largest_px, "px within +-1e9");
  demand("box width and height", {box.width, box.height}, smallest_px, largest_px, "px, 0.001 to 1e9");
  demand("position", {point.position.x, point.position.y}, -largest_px, largest_px, "px within +-1e9");
  demand("velocity_px_per_s", {point.velocity_px_per_s.x, point.velocity_px_per_s.y}, -largest_px_per_s, largest_px_per_s,
         "px/s within +-1e12");
  demand("mean_color", {color.blue, color.green, color.red}, 0.0, 255.0, "0 to 255 a channel");
}

void check_track(const RecordedTrack& track) {
  const std::string name = "track " + std::to_string(track.id);
  if (track.id < 0) throw InputError(name + ": ids count from 0");
  if (track.points.empty()) throw InputError(name + ": has no points");
  for (std::size_t i = 0; i < track.points.size(); ++i) {
    check_point(track, track.points[i]);
    if (i == 0 || track.points[i].index > track.points[i - 1].index) continue;
    throw InputError(where(track, track.points[i]) + "comes after frame index " + std::to_string(track.points[i - 1].index) +
                     "; the frames of a track must increase");
  }
}

/// A clock that all tracks share: what is later in time is a later frame.
void check_times(const History& history) {
  std::vector<std::pair<const TrackPoint*, const RecordedTrack*>> points;
  for (const RecordedTrack& track : history.tracks) {
    for (const TrackPoint& point : track.points) points.emplace_back(&point, &track);
  }
  std::sort(points.begin(), points.end(), [](const auto& a, const auto& b) {
    return a.first->index != b.first->index ? a.first->index < b.first->index : a.second->id < b.second->id;
  });
  for (std::size_t i = 1; i < points.size(); ++i) {
    const auto [before, other] = points[i - 1];
    const auto [point, track] = points[i];
    const bool same_frame = before->index == point->index;
    if (same_frame ? before->time_s == point->time_s : before->time_s < point->time_s) continue;
    throw InputError(where(*track, *point) + "time_s " + text_of(point->time_s) + " is not allowed; track " +
                     std::to_string(other->id) + " has " + text_of(before->time_s) + " s " +
                     (same_frame ? "in the same frame" : "in frame index " + std::to_string(before->index)) +
                     ", and times must increase with the frames");
  }
}

}  // namespace

void check_history(const History& history) {
  std::vector<std::int64_t> ids;
  for (const RecordedTrack& track : history.tracks) {
    check_track(track);
    ids.push_back(track.id);
  }
  std::sort(ids.begin(), ids.end());
  const auto twice = std::adjacent_find(ids.begin(), ids.end());
  if (twice != ids.end()) throw InputError("track " + std::to_string(*twice) + ": the id is given twice");
  check_times(history);
}

void HistoryRecorder::add(const TrackingResult& result) {
  for (const Track& track : result.tracks) {
    if (!track.reported) continue;
    const auto [found, is_new] = row_of_id_.try_emplace(track.id, history_.tracks.size());
    if (is_new) history_.tracks.push_back({track.id, {}});
    history_.tracks[found->second].points.push_back(
        {result.index, result.time_s, track.box, track.position, track.velocity_px_per_s, track.mean_color});
  }
}

}  // namespace survtrack
