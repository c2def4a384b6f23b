// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "survtrack/association/cost_matrix.hpp"
#include "survtrack/core/event.hpp"
#include "survtrack/core/matches.hpp"
#include "survtrack/core/track.hpp"
#include "survtrack/core/vicinity_grid.hpp"

namespace survtrack {

/// What the tracker knows after one frame.
struct TrackingResult {
  std::int64_t index = 0;
  double time_s = 0.0;
  std::vector<Track> tracks;     ///< believed tracks (confirmed, lost, or closed in this frame) in order of id
  std::vector<Track> tentative;  ///< candidates, seen too few times to be believed
  Matches matches;             ///< its rows are those of the tracks open before this frame
  std::vector<Event> events;   ///< the detector's, then the tracker's
  bool has_matrices = false;   ///< costs and beliefs were asked for
  CostMatrix costs;            ///< the whole matrix, when asked for
  CostMatrix beliefs;          ///< the same as probabilities, with a last column for "lost"; with cost.model belief
  std::vector<std::int64_t> matrix_track_ids;  ///< the rows of both; 0: tentative
  std::map<int, VicinityGrid> vicinity;        ///< by class of detections (-1: none), when asked for
};

}  // namespace survtrack
