// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <vector>

#include "survtrack/association/cost_matrix.hpp"
#include "survtrack/association/hungarian.hpp"
#include "survtrack/association/options.hpp"
#include "survtrack/core/detection.hpp"
#include "survtrack/core/matches.hpp"
#include "survtrack/tracking/track_table.hpp"

namespace survtrack {

/// Who is who: fills the matrix of costs, tracks by detections, and assigns.
class Matcher {
 public:
  Matcher(const CostOptions& cost, const AssignmentOptions& assignment) : cost_(cost), assignment_(assignment) {}

  /// Reuses the memory of `matches`.
  void match(const TrackTable& table, const Detections& detections, Matches& matches);

  /// The matrix of the last `match`.
  const CostMatrix& costs() const { return costs_; }

 private:
  void assign_rows(const TrackTable& table, Assignment& assignment);

  CostOptions cost_;
  AssignmentOptions assignment_;
  CostMatrix costs_;
  HungarianSolver solver_;
  std::vector<int> rows_;  ///< those of one round
};

}  // namespace survtrack
