// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "offline/track_way.hpp"
#include "survtrack/core/errors.hpp"
#include "survtrack/offline/patterns.hpp"

namespace survtrack {
namespace {

constexpr double most_px = 1e9, smallest = 1e-30, most = 1e30;

struct KnownWay {
  const Pattern* pattern;
  Polyline line;
  Way way;
  Box around;  ///< of the way
};

Box box_around(const std::vector<Point>& points) {
  Point low = points.front(), high = low;
  for (const Point& p : points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  return {low.x, low.y, high.x - low.x, high.y - low.y};
}

/// Learned or read patterns are as they should be; those that a program makes may not be.
void check_pattern(const Pattern& p) {
  const auto demand = [&](bool holds, const char* expected) {
    if (!holds) throw InputError("pattern " + std::to_string(p.id) + ": expected " + expected);
  };
  demand(p.way.size() >= 2, "a way of at least 2 points");
  for (const Point& point : p.way) demand(std::abs(point.x) <= most_px && std::abs(point.y) <= most_px, "a way within +-1e9 px");
  demand(p.time_s.size() == p.way.size() && std::is_sorted(p.time_s.begin(), p.time_s.end()) && p.time_s.front() >= 0.0 &&
             p.time_s.back() <= most,
         "a time_s at each point of the way, from 0 to 1e30 and never falling");
  demand(p.size_px >= smallest && p.size_px <= most_px, "a size_px between 1e-30 and 1e9");
  demand(p.speed_px_per_s >= smallest && p.speed_px_per_s <= most, "a speed_px_per_s between 1e-30 and 1e30");
  demand(p.speed_deviation_px_per_s >= 0.0 && p.speed_deviation_px_per_s <= most,
         "a speed_deviation_px_per_s between 0 and 1e30");
}

std::vector<KnownWay> known_ways(const Patterns& patterns) {
  std::vector<KnownWay> known;
  for (const Pattern& pattern : patterns.patterns) {
    check_pattern(pattern);
    Polyline line(pattern.way);
    Way way = way_along(line, patterns.options.points, pattern.size_px);
    known.push_back({&pattern, std::move(line), std::move(way), box_around(pattern.way)});
  }
  return known;
}

/// The nearest way so far: one within the limits before all that are not.
struct Nearest {
  const Pattern* pattern = nullptr;
  bool within = false;
  bool partial = false;
  double pace = 1.0;  ///< the pattern's speed on the stretch, in parts of its mean
  double distance = HUGE_VAL;
  double angle_deg = 0.0;

  void consider(const Way& track, const KnownWay& known, const Way& stretch, double pace_there, bool is_partial,
                const PatternOptions& options) {
    const double d = distance_between(track, stretch);
    const bool fits = same_way(track, stretch, options);
    if (fits == within ? d >= distance : within) return;
    *this = {known.pattern, fits, is_partial, pace_there, d, angle_between_deg(track, stretch)};
  }
};

/// Less than the distance from any stretch of the way: the middles of both are no farther apart, and one is in the box.
double least_distance(const TrackWay& track, const KnownWay& known) {
  const Point& middle = track.way.middle;
  const double x = std::clamp(middle.x, known.around.x, known.around.right()) - middle.x;
  const double y = std::clamp(middle.y, known.around.y, known.around.bottom()) - middle.y;
  return 0.999 * std::hypot(x, y) / (0.5 * (track.way.size_px + known.pattern->size_px));
}

/// How fast a pattern is on a stretch of its way, in parts of its mean: what comes nearer the camera becomes faster.
double pace_on(const KnownWay& known, double from_px, double to_px) {
  constexpr double slowest = 1e-6, fastest = 1e6;
  const std::vector<double>& time_s = known.pattern->time_s;
  const double whole_s = time_s.back() - time_s.front();
  const double stretch_s = known.line.value_at(to_px, time_s) - known.line.value_at(from_px, time_s);
  const double part = (to_px - from_px) / known.line.length_px();
  if (!(whole_s > 0.0 && stretch_s > 0.0)) return 1.0;
  return std::clamp(part / (stretch_s / whole_s), slowest, fastest);
}

/// A track shorter than a known way beside stretches of its length: all along the way, from where the track begins and
/// to where it ends.
void consider_stretches(Nearest& nearest, const TrackWay& track, const KnownWay& known, const PatternOptions& options) {
  const double spare = known.line.length_px() - track.length_px;
  if (!(spare > 0.0)) return;
  const double least = least_distance(track, known);
  if (least >= nearest.distance && (nearest.within || least > options.max_distance)) return;
  const auto consider = [&](double from_px) {
    const double from = std::clamp(from_px, 0.0, spare);
    const Way stretch = way_along(known.line, from, from + track.length_px, options.points, known.pattern->size_px);
    nearest.consider(track.way, known, stretch, pace_on(known, from, from + track.length_px), true, options);
  };
  consider(known.line.nearest(track.way.points.front()));
  consider(known.line.nearest(track.way.points.back()) - track.length_px);
  for (int k = 0; k < options.points; ++k) consider(spare * k / (options.points - 1));
}

/// A whole way within the limits comes before a stretch: what a pattern was learned from follows it.
Nearest nearest_way(const TrackWay& track, const std::vector<KnownWay>& known, const PatternOptions& options) {
  Nearest nearest;
  for (const KnownWay& one : known) nearest.consider(track.way, one, one.way, 1.0, false, options);
  if (nearest.within) return nearest;
  for (const KnownWay& one : known) consider_stretches(nearest, track, one, options);
  return nearest;
}

ActivityKind kind_of(double speed_ratio, const Pattern& pattern, const PatternOptions& options) {
  const double spread = std::max(pattern.speed_deviation_px_per_s / pattern.speed_px_per_s, options.min_speed_spread);
  // Ratios are held against each other: twice as fast is as far as half as fast.
  const double allowed = 1.0 + options.max_speed_deviations * spread;
  if (speed_ratio > allowed) return ActivityKind::too_fast;
  return speed_ratio < 1.0 / allowed ? ActivityKind::too_slow : ActivityKind::usual;
}

Activity activity_of(const RecordedTrack& track, const std::vector<KnownWay>& known, const PatternOptions& options) {
  const TrackWay way = track_way(track, options);
  Activity activity;
  activity.track_id = track.id;
  activity.speed_px_per_s = way.speed_px_per_s;
  if (!way.moves) return activity;
  activity.kind = ActivityKind::other_way;
  const Nearest nearest = nearest_way(way, known, options);
  if (nearest.pattern == nullptr) return activity;
  activity.partial = nearest.partial;
  activity.distance = nearest.distance;
  activity.angle_deg = nearest.angle_deg;
  if (!nearest.within) return activity;
  activity.pattern = nearest.pattern->id;
  activity.speed_ratio = way.speed_px_per_s / (nearest.pace * nearest.pattern->speed_px_per_s);
  activity.kind = kind_of(*activity.speed_ratio, *nearest.pattern, options);
  return activity;
}

}  // namespace

std::vector<Activity> Patterns::classify(const History& history) const {
  check_fields(options);
  check_history(history);
  const std::vector<KnownWay> known = known_ways(*this);
  std::vector<Activity> activities;
  for (const RecordedTrack& track : history.tracks) activities.push_back(activity_of(track, known, options));
  std::sort(activities.begin(), activities.end(),
            [](const Activity& a, const Activity& b) { return a.track_id < b.track_id; });
  return activities;
}

Activity Patterns::classify(const RecordedTrack& track) const { return classify(History{{track}}).front(); }

}  // namespace survtrack
