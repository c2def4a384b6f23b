// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "survtrack/core/detection.hpp"
#include "survtrack/core/track.hpp"
#include "survtrack/tracking/options.hpp"

namespace survtrack {

/// A track as the tracker keeps it: the public part, and what is needed to go on.
struct OpenTrack {
  Track track;
  double width_px = 0.0;   ///< estimated size of the whole object
  double height_px = 0.0;
  int size_samples = 0;    ///< frames in which the size was learned
  bool near_another = false;  ///< another believed object stands near
  Point start_position;    ///< px, where it was first seen
  double travelled_px = 0.0;  ///< greatest distance from there
  Box seen;                ///< box of the detection last matched
  Point seen_position;     ///< its measured position
  Point seen_velocity_px_per_s;
  double seen_time_s = 0.0;   ///< of that detection, which was its own: none that a group shares
  double reentry_confidence = 0.0;  ///< of having got an identity again; 0: it has one of its own
  Point step_px;           ///< from the measured position before to that
  double step_s = 0.0;     ///< time between the two; 0 before there are two

  bool believed() const { return track.id != 0; }
  double size_px() const;  ///< root of the box area
};

/// What a detection says of a track's position: the position, and the variances that hidden edges add.
struct Observation {
  Point position;
  Symmetric2 extra_px2;
};

/// Measures an expected track, predicted at `predicted`, by a detection.
Observation observe(const MeasurementOptions& options, const OpenTrack& track, const Point& predicted,
                    const Detection& detection);

/// The position that a detection measures by itself: that of a new track.
Point measured_position(const MeasurementOptions& options, const Detection& detection);

/// The box of a track at a position.
Box box_at(const MeasurementOptions& options, const OpenTrack& track, const Point& position);

/// Lets the track's size follow a detection, over `dt_s` since the frame before.
void learn_size(const MeasurementOptions& options, OpenTrack& track, const Detection& detection, double dt_s);

}  // namespace survtrack
