// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "survtrack/core/geometry.hpp"
#include "survtrack/core/path_position.hpp"

namespace survtrack {

/// How a path goes from point to point.
enum class PathKind {
  line,   ///< straight, with corners
  curve,  ///< a centripetal Catmull-Rom spline (Catmull and Rom 1974; Yuksel et al. 2011): no corners
};

const char* to_string(PathKind kind);

struct PathShape;

/// A way through the image and coordinates by it: S along and T across (O'Malley 2000, 3). A level path that begins in
/// the corner of the image and goes right has S = x, T = y.
///
/// To each position belongs the nearest point of the path; of those at equal distance the one with the smallest S.
/// Beyond the ends of an open path both go straight on: S is below 0 or above the length. Back from (S, T) comes the
/// same position wherever the path's radius of curvature is above its distance. Outside of a corner, where no leg of it is
/// abreast, S is the corner's and T the distance from it; the way back is then the line that halves the angle.
class Path {
 public:
  static constexpr std::size_t most_points = 2000;
  static constexpr double most_px = 1e6;           ///< of the coordinates of its points
  static constexpr double most_position_px = 1e9;  ///< of what is converted

  /// points: 2 to 2000 in px, 3 or more when closed; the last of a closed path is not the first again.
  /// max_distance_px: above 0; a position farther off the path has no place by it, and gets NaN.
  /// Throws `InputError` that names the point: not finite or beyond 1e6 px, less than 1e-6 px from the one before,
  /// where the path turns straight back, or meets itself.
  explicit Path(std::vector<Point> points, bool closed = false, PathKind kind = PathKind::line,
                double max_distance_px = std::numeric_limits<double>::infinity());
  Path(const Path&) = default;  // and no move: a path is never empty
  Path& operator=(const Path&) = default;

  const std::vector<Point>& points() const;
  bool closed() const;
  PathKind kind() const;
  double max_distance_px() const;
  double length_px() const;  ///< of a closed path: once round

  /// S of a closed path is at least 0 and below the length. Throws `InputError` for a number not within +-1e9.
  PathPosition to_path(const Point& point) const;
  void to_path(const Point* points, std::size_t count, PathPosition* places) const;

  /// Any S of a closed path: it goes round and round. Throws `InputError` for what is not finite or beyond 1e9 px.
  Point to_image(const PathPosition& place) const;
  void to_image(const PathPosition* places, std::size_t count, Point* points) const;

  /// How fast S and T change of a point that moves: ds/dt = (v . tangent) / (1 - T / radius). The divisor is kept above
  /// 0.01, since S leaps at the centre of curvature. NaN as of to_path().
  PathPosition velocity(const Point& point, const Point& velocity_px_per_s) const;

  /// How far a point at this place moves along for each px of S: 1 - T / radius, kept between 0.01 and 100. Its velocity
  /// in the image is stretch ds/dt tangent + dt/dt normal.
  double stretch(const PathPosition& place) const;

  /// Of length 1, where the path goes at S; at a corner the mean of both directions.
  Point tangent(double s_px) const;
  /// Of length 1, to the side where T is positive.
  Point normal(double s_px) const;

  /// S of a closed path brought to at least 0 and below the length.
  double wrap(double s_px) const;

  /// From the predicted to the measured S: of a closed path the shorter way round, ((d + l/2) mod l) - l/2, so that an
  /// object that passes the start does not leap (O'Malley 2000; the listing there is wrong by 2 l).
  double residual(double measured_s_px, double predicted_s_px) const;

  /// As in a file of paths (see Paths), alone; from_json() throws `InputError` that names `source` and the entry.
  std::string to_json() const;
  static Path from_json(const std::string& json, const std::string& source);

  friend bool operator==(const Path& a, const Path& b);

 private:
  std::shared_ptr<const PathShape> shape_;  // never changes: copies share it
};

}  // namespace survtrack
