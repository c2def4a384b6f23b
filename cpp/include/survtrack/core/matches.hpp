// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <vector>

namespace survtrack {

/// One candidate pair that passed the gate: the smaller the cost, the better the match.
struct Match {
  int track = 0;      ///< row in the track table before the update
  int detection = 0;  ///< index into the frame's detections
  std::int64_t track_id = 0;  ///< 0: tentative
  double cost = 0.0;
  bool assigned = false;  ///< chosen by the assignment
};

/// What the association found in one frame; each index stands in exactly one place.
struct Matches {
  std::vector<Match> candidates;          ///< all pairs within the gate, row by row
  std::vector<int> detection_of_track;    ///< a detection a track; -1: unmatched
  std::vector<int> track_of_detection;    ///< a track row a detection; -1: unmatched
};

}  // namespace survtrack
