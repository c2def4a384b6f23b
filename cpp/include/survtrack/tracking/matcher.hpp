// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <optional>
#include <vector>

#include "survtrack/association/appearance_options.hpp"
#include "survtrack/association/cost_matrix.hpp"
#include "survtrack/association/hungarian.hpp"
#include "survtrack/association/options.hpp"
#include "survtrack/core/detection.hpp"
#include "survtrack/core/matches.hpp"
#include "survtrack/tracking/belief_cost.hpp"
#include "survtrack/tracking/track_table.hpp"

namespace survtrack {

/// Who is who: fills the matrix of costs, tracks by detections, and assigns.
class Matcher {
 public:
  Matcher(const CostOptions& cost, const AssignmentOptions& assignment, const AppearanceOptions& appearance = {});

  /// Reuses the memory of `matches`. Throws `InputError` for detections that the cost cannot be computed of.
  void match(const TrackTable& table, const Detections& detections, Matches& matches);

  /// The matrix of the last `match`.
  const CostMatrix& costs() const { return costs_; }
  /// The beliefs behind them; empty when costs are no beliefs.
  std::optional<BeliefCost>& belief() { return belief_; }
  const std::optional<BeliefCost>& belief() const { return belief_; }

 private:
  void add_appearance(const TrackTable& table, const Detections& detections);
  void assign_rows(const TrackTable& table, const Detections& detections, Assignment& assignment);
  void refuse_foreign(const TrackTable& table, const Detections& detections);
  void assign_largest(const Detections& detections, Assignment& assignment);
  void assign_in_row_order(const Detections& detections, Assignment& assignment);

  CostOptions cost_;
  AssignmentOptions assignment_;
  AppearanceOptions appearance_;
  CostMatrix costs_;
  std::optional<BeliefCost> belief_;
  HungarianSolver solver_;
  std::vector<int> rows_;  ///< those of one round; else what there is of each detection
};

}  // namespace survtrack
