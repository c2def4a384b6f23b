// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "tracking/path_checks.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <sstream>
#include <string>

#include "survtrack/core/errors.hpp"
#include "tracking/path_shape.hpp"

namespace survtrack {
namespace {

constexpr double least_step_px = 1e-6;
constexpr double straight_back = 1e-9;  // sine of an angle

template <class... Parts>
[[noreturn]] void refuse(const Parts&... parts) {
  std::ostringstream text;
  text.precision(12);
  ((text << parts), ...);
  throw InputError(text.str());
}

std::string words(const Point& p) {
  std::ostringstream text;
  text.precision(12);
  text << "(" << p.x << ", " << p.y << ")";
  return text.str();
}

std::string at(std::size_t i) { return "points[" + std::to_string(i) + "]"; }

void check_neighbours(const std::vector<Point>& points, bool closed) {
  const std::size_t count = points.size();
  for (std::size_t i = 0; i < (closed ? count : count - 1); ++i) {
    const std::size_t next = (i + 1) % count;
    if (norm(points[next] - points[i]) >= least_step_px) continue;
    if (next == 0) {
      refuse(at(i), ": ", words(points[i]),
             " is the first point again; a closed path goes back to its first by itself");
    }
    refuse(at(next), ": ", words(points[next]), " is the same as ", at(i), "; expected at least 1e-6 px between them");
  }
  for (std::size_t i = closed ? 0 : 1; i < (closed ? count : count - 1); ++i) {
    const Point in = unit(points[i] - points[(i + count - 1) % count]), out = unit(points[(i + 1) % count] - points[i]);
    if (dot(in, out) < 0.0 && std::abs(cross(in, out)) <= straight_back) {
      refuse(at(i), ": the path turns straight back at ", words(points[i]),
             "; expected no two stretches on each other");
    }
  }
}

bool ranges_meet(double a, double a_step, double b, double b_step) {
  return std::max(std::min(a, a + a_step), std::min(b, b + b_step)) <=
         std::min(std::max(a, a + a_step), std::max(b, b + b_step));
}

/// Whether two chords have a point in common: each has its ends on different sides of the other, or on it.
bool meet(const PathChords& chords, std::size_t i, std::size_t j) {
  const Point p = chords.start(i), u = chords.step(i), q = chords.start(j), v = chords.step(j);
  if (!ranges_meet(p.x, u.x, q.x, v.x) || !ranges_meet(p.y, u.y, q.y, v.y)) return false;
  return cross(u, q - p) * cross(u, q + v - p) <= 0.0 && cross(v, p - q) * cross(v, p + u - q) <= 0.0;
}

[[noreturn]] void refuse_crossing(const PathShape& shape, std::size_t i, std::size_t j) {
  const auto leg = [&](std::size_t piece) {
    const std::size_t first = shape.pieces[piece].leg;
    return "between " + at(first) + " and " + at((first + 1) % shape.points.size());
  };
  const PathChords& chords = shape.chords;
  const Point p = chords.start(i), u = chords.step(i), q = chords.start(j), v = chords.step(j);
  const double turn = cross(u, v);
  const Point where = turn == 0.0 ? q : p + (cross(q - p, v) / turn) * u;
  refuse("points: the path meets itself near ", words(where), ", ", leg(i), " and ", leg(j),
         "; expected one that does not cross or touch itself");
}

}  // namespace

void check_path_points(const std::vector<Point>& points, bool closed, double max_distance_px) {
  const std::size_t least = closed ? 3 : 2;
  if (points.size() < least || points.size() > Path::most_points) {
    refuse("points: has ", points.size(), "; expected ", least, " to ", Path::most_points,
           closed ? " of a closed path" : "");
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point& p = points[i];
    if (std::abs(p.x) <= Path::most_px && std::abs(p.y) <= Path::most_px) continue;
    refuse(at(i), ": is ", words(p), "; expected finite px within +-1e6");
  }
  if (!(max_distance_px > 0.0)) refuse("max_distance_px: is ", max_distance_px, "; expected px above 0");
  check_neighbours(points, closed);
}

void check_path_crossings(const PathShape& shape) {
  const PathChords& chords = shape.chords;
  for (std::size_t i = 0; i < chords.count; ++i) {
    const double x = chords.x[i], y = chords.y[i], dx = chords.dx[i], dy = chords.dy[i];
    // Of each pair once; neighbours meet where the one ends and the other begins.
    for (std::size_t block = i / PathChords::lanes; block < chords.blocks(); ++block) {
      if (!ranges_meet(x, dx, chords.left[block], chords.right[block] - chords.left[block])) continue;
      if (!ranges_meet(y, dy, chords.top[block], chords.bottom[block] - chords.top[block])) continue;
      const std::size_t last = std::min(chords.count, (block + 1) * PathChords::lanes);
      for (std::size_t j = std::max(i + 2, block * PathChords::lanes); j < last; ++j) {
        const bool neighbours = shape.closed && i == 0 && j + 1 == chords.count;
        if (!neighbours && meet(chords, i, j)) refuse_crossing(shape, i, j);
      }
    }
  }
}

}  // namespace survtrack
