// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "offline/track_way.hpp"

#include <algorithm>
#include <utility>

#include "offline/track_end.hpp"

namespace survtrack {
namespace {

constexpr double shortest_s = 1e-9;  // speeds stay finite

}  // namespace

TrackWay track_way(const RecordedTrack& track, const PatternOptions& options) {
  const double size_px = size_of(track);
  std::vector<Point> corners;
  std::vector<double> times_s;
  for (const TrackPoint& step : steps_of(track, size_px)) {
    corners.push_back(step.position);
    times_s.push_back(step.time_s - track.points.front().time_s);
  }
  const Polyline line(std::move(corners));
  TrackWay result;
  result.id = track.id;
  result.moves = travel_of(track) >= options.min_travel * size_px;
  result.length_px = line.length_px();
  result.duration_s = times_s.back();
  result.speed_px_per_s = result.length_px / std::max(result.duration_s, shortest_s);
  result.way = way_along(line, options.points, size_px);
  for (int i = 0; i < options.points; ++i) {
    const double part = static_cast<double>(i) / (options.points - 1);
    result.time_s.push_back(line.value_at(part * line.length_px(), times_s));
  }
  result.time_s.back() = result.duration_s;  // whatever the rounding of the length
  return result;
}

}  // namespace survtrack
