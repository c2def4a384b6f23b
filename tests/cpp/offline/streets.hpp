// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cmath>

#include "straight_tracks.hpp"

namespace survtrack {

/// Walks from one place to another at a speed in px/s, from frame `first` on.
inline RecordedTrack walk_between(std::int64_t id, Point from, Point to, double speed = 40.0, int first = 0) {
  const Point way = to - from;
  const double length = std::hypot(way.x, way.y);
  Walk walk;
  walk.id = id;
  walk.first = first;
  walk.last = first + static_cast<int>(std::lround(10.0 * length / speed));
  walk.start = from;
  walk.velocity_px_per_s = (speed / length) * way;
  return track_of(walk);
}

/// Two streets that cross, 400 px long, and people 40 px high who walk 40 px/s on both, in both directions: 9 to the
/// east, 7 to the west, 5 to the south and 3 to the north, side by side 2 px apart.
inline History two_streets() {
  struct Stream {
    int count;
    Point from, to, across;
  };
  const Stream streams[] = {{3, {200, 400}, {200, 0}, {1, 0}},
                            {9, {0, 200}, {400, 200}, {0, 1}},
                            {5, {200, 0}, {200, 400}, {1, 0}},
                            {7, {400, 200}, {0, 200}, {0, 1}}};
  History history;
  std::int64_t id = 1;
  for (int k = 0; k < 9; ++k) {
    for (const Stream& s : streams) {
      if (k >= s.count) continue;
      const Point aside = (2.0 * k - (s.count - 1)) * s.across;
      history.tracks.push_back(walk_between(id, s.from + aside, s.to + aside, 40.0, 7 * static_cast<int>(id)));
      ++id;
    }
  }
  return history;
}

}  // namespace survtrack
