// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "offline/way.hpp"

namespace survtrack {

/// What patterns see of a track.
struct TrackWay {
  std::int64_t id = 0;
  bool moves = false;  ///< at least `min_travel` away from its first place
  double length_px = 0.0;
  double duration_s = 0.0;
  double speed_px_per_s = 0.0;  ///< 0 for a single point
  Way way;
  std::vector<double> time_s;  ///< since the first point, at each point of the way
};

TrackWay track_way(const RecordedTrack& track, const PatternOptions& options);

}  // namespace survtrack
