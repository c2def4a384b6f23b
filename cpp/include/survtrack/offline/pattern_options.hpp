// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "survtrack/core/fields.hpp"

namespace survtrack {

/// When tracks go the same way, and which are unusual. An object's size is the root of its box area, so that near and
/// far objects are treated alike.
struct PatternOptions {
  int points = 16;
  double min_travel = 2.0;
  double max_distance = 1.5;
  double max_angle_deg = 45.0;
  int min_tracks = 3;
  double max_speed_deviations = 3.0;
  double min_speed_spread = 0.1;

  static constexpr auto fields() {
    using O = PatternOptions;
    return std::make_tuple(
        field("points", &O::points, "", "points by which a way is described, evenly spaced along it", between(4, 256)),
        field("min_travel", &O::min_travel, "object sizes",
              "a track that never gets so far from its first place is standing, and neither learned from nor unusual",
              between(0.01, 1e6)),
        field("max_distance", &O::max_distance, "object sizes",
              "largest mean distance between corresponding points of a track and the way that it follows", above_up_to(0, 1e6)),
        field("max_angle_deg", &O::max_angle_deg, "degrees",
              "largest angle between their directions; its cosine is the mean over the way", above_up_to(0, 180)),
        field("min_tracks", &O::min_tracks, "tracks", "what fewer tracks do is no pattern", between(1, 1e6)),
        field("max_speed_deviations", &O::max_speed_deviations, "standard deviations",
              "a track is too fast or too slow beyond this many from the pattern's mean speed", above_up_to(0, 1e6)),
        field("min_speed_spread", &O::min_speed_spread, "",
              "least standard deviation of a pattern's speed that counts, in parts of the mean", above_up_to(0, 1e6)));
  }
};

}  // namespace survtrack
