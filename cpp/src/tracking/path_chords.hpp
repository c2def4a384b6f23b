// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "survtrack/core/geometry.hpp"

namespace survtrack {

/// Straight pieces in their order, in blocks of eight: one is looked at as a whole, or left out by its bounding box.
struct PathChords {
  static constexpr std::size_t lanes = 8;

  std::size_t count = 0;
  std::vector<double> x, y, dx, dy, inverse_px2;  // as many as whole blocks have: the last one is repeated
  std::vector<double> left, top, right, bottom;   // of the blocks

  void add(const Point& start, const Point& end);
  void finish();  ///< after the last add()

  std::size_t blocks() const { return left.size(); }
  Point start(std::size_t i) const { return {x[i], y[i]}; }
  Point step(std::size_t i) const { return {dx[i], dy[i]}; }

  /// Squared, from a block's bounding box; a hair less, so that rounding leaves no block out.
  double least_px2(std::size_t block, const Point& p) const {
    const double across = std::max(std::max(left[block] - p.x, p.x - right[block]), 0.0);
    const double down = std::max(std::max(top[block] - p.y, p.y - bottom[block]), 0.0);
    return (1.0 - 1e-12) * (across * across + down * down);
  }

  /// Squared distance of a point from a chord.
  double distance_px2(std::size_t i, const Point& p) const {
    const double wx = p.x - x[i], wy = p.y - y[i];
    double t = (wx * dx[i] + wy * dy[i]) * inverse_px2[i];
    t = t < 0.0 ? 0.0 : t;
    t = t > 1.0 ? 1.0 : t;
    const double rx = wx - t * dx[i], ry = wy - t * dy[i];
    return rx * rx + ry * ry;
  }
};

struct NearestChord {
  double distance_px2 = 0.0;
  std::size_t chord = 0;  ///< of those at equal distance the first
};

/// Of each point the chord nearest to it.
void find_nearest_chords(const PathChords& chords, const Point* points, std::size_t count, NearestChord* found);

}  // namespace survtrack
