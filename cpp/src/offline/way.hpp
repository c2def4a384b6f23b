// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "survtrack/offline/history.hpp"
#include "survtrack/offline/pattern_options.hpp"

namespace survtrack {

/// A line of straight pieces that knows its length at each corner.
class Polyline {
 public:
  explicit Polyline(std::vector<Point> corners);

  double length_px() const { return lengths_.back(); }
  /// The place that far along, px; the ends beyond them.
  Point at(double length_px) const;
  /// How far along the nearest place to a point is, px.
  double nearest(const Point& point) const;
  /// Of what is known at each corner, such as a time, the value that far along.
  double value_at(double length_px, const std::vector<double>& at_corners) const;

 private:
  /// The corner after a place, and how much of the piece that ends there lies before it. Not beyond the ends.
  std::pair<std::size_t, double> piece_at(double length_px) const;

  std::vector<Point> corners_;   ///< at least one
  std::vector<double> lengths_;  ///< up to each corner
};

/// Where something goes: points evenly spaced along it, and the directions between them.
struct Way {
  std::vector<Point> points;
  std::vector<Point> directions;  ///< unit vectors, one fewer; zero where it does not move
  double size_px = 0.0;           ///< of the object
  Point middle;                   ///< mean of the points
};

/// `count` points, 2 or more, of the stretch between two places of a line.
Way way_along(const Polyline& line, double from_px, double to_px, int count, double size_px);

/// The same of the whole.
Way way_along(const Polyline& line, int count, double size_px);

/// A track's points without those that the box's trembling alone can explain: a standing object goes nowhere.
std::vector<TrackPoint> steps_of(const RecordedTrack& track, double size_px);

/// Mean distance of corresponding points, in parts of the mean of both sizes. Both have as many points.
double distance_between(const Way& a, const Way& b);

/// The angle whose cosine is the mean of those between corresponding directions, 0 to 180.
double angle_between_deg(const Way& a, const Way& b);

/// Most that distance_between() may be in px, for the sum of both sizes.
inline double limit_px(double size_a_px, double size_b_px, const PatternOptions& options) {
  return options.max_distance * 0.5 * (size_a_px + size_b_px);
}

/// Whether both are within the options' limits; quick where they are not.
bool same_way(const Way& a, const Way& b, const PatternOptions& options);

}  // namespace survtrack
