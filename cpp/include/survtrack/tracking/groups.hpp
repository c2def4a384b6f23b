// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "survtrack/association/cost_matrix.hpp"
#include "survtrack/association/hungarian.hpp"
#include "survtrack/core/detection.hpp"
#include "survtrack/core/matches.hpp"
#include "survtrack/tracking/identity_options.hpp"
#include "survtrack/tracking/track_table.hpp"

namespace survtrack {

/// Tracks that merged, or that parted again.
struct GroupChange {
  std::vector<std::int64_t> track_ids;  ///< the oldest first
  Box box;                              ///< px, of the blob that they share, or shared last
};

/// Finds the tracks that share one blob, after the association, which is one to one: a believed track without a
/// detection, most of whose predicted box lies in the detection of another, is in a group with that one. When the blob
/// of a group divides, its tracks and the detections there are assigned anew, by position and by the colours from
/// before: the cost is half the squared Mahalanobis distance plus half the squared colour difference in deviations.
class GroupWatch {
 public:
  explicit GroupWatch(const SharedBlobOptions& options) : options_(options) {}

  /// Between the association and the filters' correction. Changes `matches` where groups divide, and writes each row's
  /// group into the table.
  void update(TrackTable& table, const Detections& detections, Matches& matches);

  /// The detection that a row shares with others; -1: it shares none.
  int shared_detection(int row) const { return shared_[static_cast<std::size_t>(row)]; }
  /// What changed in this frame.
  const std::vector<GroupChange>& merged() const { return merged_; }
  const std::vector<GroupChange>& split() const { return split_; }

  void clear();

 private:
  void divide(const TrackTable& table, const Detections& detections, Matches& matches);
  void divide_one(const TrackTable& table, const Detections& detections, const std::vector<int>& rows, const Box& last,
                  Matches& matches);
  double cost(const TrackTable& table, int row, const Detection& detection) const;
  int host_of(const TrackTable& table, const Detections& detections, const Matches& matches, int row) const;
  void find_splits(const TrackTable& table, const Matches& matches);
  void write_groups(TrackTable& table, const Detections& detections);

  SharedBlobOptions options_;
  std::map<std::int64_t, Box> boxes_;  ///< by group: the blob in the frame before
  std::vector<int> shared_;            ///< a row
  std::vector<GroupChange> merged_, split_;
  // Scratch of one frame.
  std::map<std::int64_t, std::vector<int>> rows_of_group_;
  std::map<int, std::vector<int>> rows_of_detection_;
  std::map<std::int64_t, Box> next_boxes_;
  std::vector<int> found_, local_rows_;
  CostMatrix costs_;
  Assignment assignment_;
  HungarianSolver solver_;
};

}  // namespace survtrack
