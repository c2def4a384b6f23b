// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cmath>
#include <random>
#include <vector>

#include "survtrack/tracking/path.hpp"

namespace survtrack {

/// Once round a square of 100 px, clockwise as seen, from its upper left corner.
inline const std::vector<Point> square_points{{0, 0}, {100, 0}, {100, 100}, {0, 100}};

/// Points round (200, 200), 60 to 140 px from it, by their angles: no path through them by straight lines meets itself.
inline std::vector<Point> star(int count, std::mt19937& random) {
  std::uniform_real_distribution<double> radius(60.0, 140.0), jitter(0.0, 0.6);
  std::vector<Point> points;
  for (int i = 0; i < count; ++i) {
    const double angle = 2.0 * M_PI * (i + jitter(random)) / count, r = radius(random);
    points.push_back({200.0 + r * std::cos(angle), 200.0 + r * std::sin(angle)});
  }
  return points;
}

/// `count` points at equal angles on a circle round (0, 0), clockwise as seen, from (radius, 0).
inline std::vector<Point> circle(int count, double radius) {
  std::vector<Point> points;
  for (int i = 0; i < count; ++i) {
    const double angle = 2.0 * M_PI * i / count;
    points.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  return points;
}

inline double distance(const Point& a, const Point& b) { return std::hypot(a.x - b.x, a.y - b.y); }

}  // namespace survtrack
