// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>
#include <utility>

#include "offline/track_way.hpp"
#include "offline/way_groups.hpp"
#include "survtrack/offline/patterns.hpp"

namespace survtrack {
namespace {

/// Those that move, by id, so that the order in which the tracks were given does not matter.
std::vector<TrackWay> moving_ways(const History& history, const PatternOptions& options) {
  std::vector<TrackWay> tracks;
  for (const RecordedTrack& track : history.tracks) {
    TrackWay one = track_way(track, options);
    if (one.moves) tracks.push_back(std::move(one));
  }
  std::sort(tracks.begin(), tracks.end(), [](const TrackWay& a, const TrackWay& b) { return a.id < b.id; });
  return tracks;
}

struct MeanAndDeviation {
  double mean = 0.0;
  double deviation = 0.0;
};

template <class Value>
MeanAndDeviation over(const WayGroup& group, Value&& value) {
  const double n = static_cast<double>(group.size());
  MeanAndDeviation result;
  for (const std::size_t a : group) result.mean += value(a) / n;
  double squares = 0.0;
  for (const std::size_t a : group) squares += std::pow(value(a) - result.mean, 2);
  result.deviation = std::sqrt(squares / n);
  return result;
}

/// Root mean square distance of the tracks across the way, at each of its points.
std::vector<double> spread_across(const std::vector<Point>& way, const std::vector<Way>& ways, const WayGroup& group) {
  std::vector<double> spread;
  for (std::size_t i = 0; i < way.size(); ++i) {
    const Point along = way[std::min(i + 1, way.size() - 1)] - way[i > 0 ? i - 1 : 0];
    const double px = std::hypot(along.x, along.y);
    double squares = 0.0;
    for (const std::size_t a : group) {
      const Point off = ways[a].points[i] - way[i];
      const double across = px > 0.0 ? (along.x * off.y - along.y * off.x) / px : std::hypot(off.x, off.y);
      squares += across * across;
    }
    spread.push_back(std::sqrt(squares / static_cast<double>(group.size())));
  }
  return spread;
}

std::vector<double> mean_times_s(const std::vector<TrackWay>& tracks, const WayGroup& group) {
  std::vector<double> times_s(tracks[group.front()].time_s.size());
  for (std::size_t i = 0; i < times_s.size(); ++i) {
    times_s[i] = over(group, [&](std::size_t a) { return tracks[a].time_s[i]; }).mean;
    if (i > 0) times_s[i] = std::max(times_s[i], times_s[i - 1]);  // sums are rounded
  }
  return times_s;
}

Pattern pattern_of(const std::vector<TrackWay>& tracks, const std::vector<Way>& ways, const WayGroup& group) {
  Pattern pattern;
  pattern.count = static_cast<std::int64_t>(group.size());
  pattern.way = mean_points(ways, group);
  pattern.spread_px = spread_across(pattern.way, ways, group);
  pattern.time_s = mean_times_s(tracks, group);
  pattern.size_px = mean_size_px(ways, group);
  const MeanAndDeviation speed = over(group, [&](std::size_t a) { return tracks[a].speed_px_per_s; });
  const MeanAndDeviation duration = over(group, [&](std::size_t a) { return tracks[a].duration_s; });
  pattern.speed_px_per_s = speed.mean;
  pattern.speed_deviation_px_per_s = speed.deviation;
  pattern.duration_s = duration.mean;
  pattern.duration_deviation_s = duration.deviation;
  return pattern;
}

}  // namespace

Patterns learn_patterns(const History& history, const PatternOptions& options) {
  check_fields(options);
  check_history(history);
  const std::vector<TrackWay> tracks = moving_ways(history, options);
  std::vector<Way> ways;
  for (const TrackWay& track : tracks) ways.push_back(track.way);
  Patterns learned;
  learned.options = options;
  for (const WayGroup& group : group_ways(ways, options)) {
    learned.patterns.push_back(pattern_of(tracks, ways, group));
    learned.patterns.back().id = static_cast<int>(learned.patterns.size());
  }
  return learned;
}

}  // namespace survtrack
