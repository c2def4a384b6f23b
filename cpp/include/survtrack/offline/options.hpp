// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "survtrack/core/fields.hpp"

namespace survtrack {

/// When two tracks are one, and which tracks are too short to be real. An object's size is the root of its box area,
/// so that near and far objects are treated alike. A limit of 1e6 switches a criterion off.
struct LinkOptions {
  double max_gap_s = 3.0;
  double max_distance = 0.75;
  double max_distance_growth = 0.5;
  double max_speed_difference = 1.0;
  double max_color_difference = 0.3;
  double max_cost = 0.5;
  double end_s = 1.0;
  int min_frames = 3;
  double min_s = 0.5;
  double min_travel = 0.5;

  static constexpr auto fields() {
    using O = LinkOptions;
    return std::make_tuple(
        field("max_gap_s", &O::max_gap_s, "s",
              "longest time between the end of a track and the start of the next; 0: none are joined", between(0, 1e6)),
        field("max_distance", &O::max_distance, "object sizes",
              "largest distance between end and start, both extrapolated to the middle of the gap", between(0, 1e6)),
        field("max_distance_growth", &O::max_distance_growth, "object sizes/s", "what each second of the gap adds to max_distance",
              between(0, 1e6)),
        field("max_speed_difference", &O::max_speed_difference, "object sizes/s",
              "largest difference of the velocities before and after the gap", between(0, 1e6)),
        field("max_color_difference", &O::max_color_difference, "",
              "largest distance of the mean colours, 0 to 1.73 (Narayana 2007, eq. 3.6)", between(0, 1e6)),
        field("max_cost", &O::max_cost, "",
              "a join costs less: the mean of gap, distance, speed and colour difference in parts of their limits", between(0, 1)),
        field("end_s", &O::end_s, "s",
              "stretch of a track from which the velocity, size and colour of its end are taken", between(0, 1e6)),
        field("min_frames", &O::min_frames, "frames", "a track seen in fewer is dropped", between(0, 1e6)),
        field("min_s", &O::min_s, "s", "a track that lasts less is dropped", between(0, 1e6)),
        field("min_travel", &O::min_travel, "object sizes",
              "a track that never gets so far from its first place is dropped; 0 where objects may stand", between(0, 1e6)));
  }
};

}  // namespace survtrack
