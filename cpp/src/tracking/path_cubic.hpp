// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cmath>
#include <vector>

#include "survtrack/tracking/path.hpp"

namespace survtrack {

inline double dot(const Point& a, const Point& b) { return a.x * b.x + a.y * b.y; }
inline double cross(const Point& a, const Point& b) { return a.x * b.y - a.y * b.x; }
inline double norm(const Point& a) { return std::sqrt(dot(a, a)); }
inline Point unit(const Point& a) { return (1.0 / norm(a)) * a; }

/// From one point of a path to the next: a + b u + c u^2 + d u^3, u from 0 to 1.
struct PathCubic {
  Point a, b, c, d;

  Point at(double u) const { return a + u * (b + u * (c + u * d)); }
  Point rate(double u) const { return b + u * (2.0 * c + (3.0 * u) * d); }
  Point bend(double u) const { return 2.0 * c + (6.0 * u) * d; }

  /// Of the stretch between two parameters, px; for stretches that hardly turn.
  double length_px(double from, double to) const;
};

/// One a leg; of a closed path the last leads back to the first point.
std::vector<PathCubic> cubics_through(const std::vector<Point>& points, bool closed, PathKind kind);

}  // namespace survtrack
