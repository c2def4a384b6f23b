// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "survtrack/offline/history.hpp"

namespace survtrack {

/// How a track starts or ends.
struct TrackEnd {
  double time_s = 0.0;     ///< of its outermost point
  Point position;          ///< px, of its outermost point
  Point velocity_px_per_s; ///< slope of the positions by least squares; a single point's own
  double size_px = 0.0;    ///< mean root of the box area
  Color mean_color;
};

/// Over the points within `stretch_s` of the track's first or last one, that one counted.
TrackEnd start_of(const RecordedTrack& track, double stretch_s);
TrackEnd end_of(const RecordedTrack& track, double stretch_s);

/// Mean root of the box area over the whole track, px.
double size_of(const RecordedTrack& track);

/// Largest distance from the first place, px.
double travel_of(const RecordedTrack& track);

}  // namespace survtrack
