// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>

#include "survtrack/filtering/measured_track.hpp"

namespace survtrack {

/// The straight line in time through a track's positions, by least squares. Of at least 2 measurements.
struct StraightLine {
  double middle_time = 0.0;
  Point middle;
  Point slope;  ///< px per time unit

  explicit StraightLine(const MeasuredTrack& track) {
    const double share = 1.0 / static_cast<double>(track.times.size());
    // About the first ones, so that large times and places lose no digits.
    const double time_0 = track.times.front();
    const Point place_0 = track.positions.front();
    for (const double time : track.times) middle_time += share * (time - time_0);
    for (const Point& place : track.positions) middle = middle + share * (place - place_0);
    middle_time += time_0;
    middle = middle + place_0;
    double square = 0.0;
    Point product;
    for (std::size_t i = 0; i < track.times.size(); ++i) {
      const double t = track.times[i] - middle_time;
      square += t * t;
      product = product + t * (track.positions[i] - middle);
    }
    slope = (1.0 / square) * product;
  }

  Point residual(double time, const Point& place) const { return place - middle - (time - middle_time) * slope; }
};

}  // namespace survtrack
