// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "survtrack/association/cost_matrix.hpp"
#include "survtrack/core/matches.hpp"
#include "survtrack/tracking/track_table.hpp"

namespace survtrack {

/// Tracks that believe to be the same blob, the oldest first.
struct Convergence {
  int detection = 0;
  std::vector<std::int64_t> track_ids;
};

/// Tells when the beliefs of two tracks meet on one blob (Narayana 2007, 8.1): the blob is the most probable entry
/// of both their rows. They have met until each is matched to a blob of its own and
/// they no longer believe to be the same.
class ConvergenceWatch {
 public:
  /// Looks at the beliefs of one frame, before its tracks are closed; the rows are those of `table`.
  void update(const TrackTable& table, const CostMatrix& beliefs, const Matches& matches);
  /// What met in this frame and had not met before.
  const std::vector<Convergence>& met() const { return met_; }
  void clear();

 private:
  void find_claims(const TrackTable& table, const CostMatrix& beliefs);
  void forget_parted(const TrackTable& table, const Matches& matches);

  std::set<std::pair<std::int64_t, std::int64_t>> pairs_;  ///< that have met, the older one first
  std::map<int, Convergence> claims_;                      ///< by blob: who believes to be it
  std::vector<Convergence> met_;
};

}  // namespace survtrack
