// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <optional>
#include <vector>

#include "survtrack/core/region.hpp"
#include "survtrack/tracking/predicted_region.hpp"
#include "survtrack/tracking/track_table.hpp"

namespace survtrack {

/// Says which parts of the coming frame must be read: those where tracks are expected, and those where newcomers are
/// looked for. What is read in turn, to keep the background up to date, the detector adds.
class RegionPlanner {
 public:
  explicit RegionPlanner(const PredictedRegionsOptions& options) : options_(options) {}

  bool wants_zones() const { return options_.acquisition == Acquisition::zones; }
  /// The zones of `acquisition = zones`, px. Throws `InputError` for none, and for one that is not
  /// finite or has no size.
  void load_zones(const std::vector<Box>& zones);
  /// Throws `InputError` for zones that are missing, or wholly outside of frames of this size.
  void check(int frame_width, int frame_height) const;

  /// Fills `regions` after the table's `predict`, each cut to the frame; what lies outside of it is left out.
  void plan(const TrackTable& table, int frame_width, int frame_height, std::vector<Region>& regions) const;

 private:
  std::optional<Box> region_of(const TrackTable& table, int i) const;

  PredictedRegionsOptions options_;
  std::vector<Box> zones_;
};

}  // namespace survtrack
