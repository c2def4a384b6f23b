// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <vector>

#include "survtrack/core/geometry.hpp"

namespace survtrack {

/// What was measured of one object, in order of time.
struct MeasuredTrack {
  std::vector<double> times;     ///< time units, increasing
  std::vector<Point> positions;  ///< px; as many
  std::vector<double> lengths = {};  ///< the object's size in px as it was known before each; empty: 1 px
};

/// Refuses, in an `InputError` that names track and measurement: fewer than `least` measurements, lists that differ in
/// length, what is not finite or beyond 1e9 px, lengths outside 0.001 to 1e9 px, times that do not increase by 1e-9 to 1e6.
void check_measured_tracks(const std::vector<MeasuredTrack>& tracks, std::size_t least);

/// Whether the object stood: the slope of its positions (least squares) is at most `max_speed` lengths per time unit, and
/// they keep within `max_range` lengths from left to right and from top to bottom. Lengths are means over the track. Throws
/// `InputError` for limits that are not at least 0, and for a track of fewer than 2 measurements.
bool stands_still(const MeasuredTrack& track, double max_speed = 0.05, double max_range = 0.3);

}  // namespace survtrack
