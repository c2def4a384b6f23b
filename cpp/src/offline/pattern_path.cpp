// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "survtrack/offline/pattern_path.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/text_of.hpp"
#include "survtrack/core/errors.hpp"

namespace survtrack {
namespace {

double distance_px(const Point& a, const Point& b) { return std::hypot(a.x - b.x, a.y - b.y); }
double dot(const Point& a, const Point& b) { return a.x * b.x + a.y * b.y; }

/// Where on the stretch from `from` to `to` the point nearest to `p` is, 0 to 1.
double nearest_between(const Point& p, const Point& from, const Point& to) {
  const Point step = to - from;
  const double length_px2 = dot(step, step);
  return length_px2 > 0.0 ? std::clamp(dot(p - from, step) / length_px2, 0.0, 1.0) : 0.0;
}

/// How many points the first lap of a way has: up to where, having been away, it passes its start, or ends before it,
/// in about the direction in which it began. 0: it makes no lap.
std::size_t points_of_lap(const std::vector<Point>& way, double close_px) {
  const Point& start = way.front();
  bool away = false;
  for (std::size_t i = 1; i + 1 < way.size(); ++i) {
    away = away || distance_px(way[i], start) > 2.0 * close_px;
    const double t = nearest_between(start, way[i], way[i + 1]);
    const bool passes = t < 1.0 || i + 2 == way.size();
    const Point place = way[i] + t * (way[i + 1] - way[i]);
    const bool same_direction = dot(way[i + 1] - way[i], way[1] - start) > 0.0;
    if (away && passes && same_direction && distance_px(place, start) <= close_px) return t < 1.0 ? i + 1 : i + 2;
  }
  return 0;
}

double mean_step_px(const std::vector<Point>& points) {
  double length_px = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i) length_px += distance_px(points[i - 1], points[i]);
  return length_px / static_cast<double>(points.size() - 1);
}

}  // namespace

Path path_of_pattern(const Pattern& pattern, PathKind kind, std::optional<double> close_within_px, double max_distance_px) {
  if (close_within_px && !(*close_within_px >= 0.0)) {
    throw InputError("close_within_px: is " + text_of(*close_within_px) + "; expected px of at least 0");
  }
  std::vector<Point> points = pattern.way;
  if (points.size() < 2) throw InputError("way: has " + std::to_string(points.size()) + " points; expected at least 2");
  const std::size_t lap = points_of_lap(points, close_within_px.value_or(pattern.size_px));
  if (lap > 0) points.resize(lap);
  // A last point that all but is the first would make a kink.
  const double near_px = 0.5 * mean_step_px(points);
  while (lap > 0 && points.size() > 3 && distance_px(points.back(), points.front()) < near_px) points.pop_back();
  return Path(std::move(points), lap > 0 && points.size() > 2, kind, max_distance_px);
}

}  // namespace survtrack
