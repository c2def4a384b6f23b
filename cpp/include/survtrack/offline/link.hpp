// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <vector>

#include "survtrack/offline/history.hpp"
#include "survtrack/offline/options.hpp"

namespace survtrack {

/// Two tracks that are one, and the numbers that decided it.
struct Link {
  std::int64_t earlier_id = 0;
  std::int64_t later_id = 0;
  double gap_s = 0.0;             ///< from the last point of the one to the first of the other
  double distance = 0.0;          ///< object sizes, both extrapolated to the middle of the gap
  double speed_difference = 0.0;  ///< object sizes per second
  double color_difference = 0.0;  ///< 0 to 1.73
  double cost = 0.0;              ///< mean of the four in parts of their limits, 0 to 1
};

/// A track that is too short, after joining.
struct DroppedTrack {
  std::int64_t id = 0;
  std::int64_t frames = 0;  ///< in which it has a point
  double duration_s = 0.0;
  double travel = 0.0;      ///< object sizes; largest distance from its first place
};

/// What is left of a history, and why.
struct Linked {
  History history;                    ///< by id
  std::vector<Link> links;            ///< in order of the earlier one's start; ids are those of the given tracks
  std::vector<DroppedTrack> dropped;  ///< by id
};

/// Joins the pieces of broken tracks, then drops tracks that are too short (Narayana 2007, 11.2). A chain of pieces gets
/// the id of its first; its gaps stay gaps. Of all ways to give each track at most one successor, the one is taken in
/// which the joins save most against `max_cost` each. The order of the tracks does not matter. Throws `InputError` as
/// check_history() does, `ConfigError` for options out of their bounds.
Linked link_tracks(const History& history, const LinkOptions& options = {});

}  // namespace survtrack
