// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>

#include "survtrack/offline/history.hpp"

namespace survtrack {

/// Tracks that walk straight on, at ten frames a second; an object measures 40 px: a box of 20 x 80.
struct Walk {
  std::int64_t id = 1;
  int first = 0;  ///< frame index
  int last = 9;
  Point start;  ///< px, in frame `first`
  Point velocity_px_per_s{40.0, 0.0};
  Color color{100.0, 100.0, 100.0};
};

inline RecordedTrack track_of(const Walk& walk) {
  RecordedTrack track{walk.id, {}};
  for (int index = walk.first; index <= walk.last; ++index) {
    const Point at = walk.start + (0.1 * (index - walk.first)) * walk.velocity_px_per_s;
    track.points.push_back({index, 0.1 * index, Box::around(at, 20.0, 80.0), at, walk.velocity_px_per_s, walk.color});
  }
  return track;
}

}  // namespace survtrack
