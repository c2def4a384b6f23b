// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "survtrack/tracking/lifecycle.hpp"

namespace survtrack {

/// See RegionGrowthOptions.
class RegionGrowth final : public Lifecycle {
 public:
  explicit RegionGrowth(const RegionGrowthOptions& options) : options_(options) {}

  void update(TrackTable& table, const Detections& detections, const Matches& matches) override;

 private:
  void keep_or_close(TrackTable& table, int i, const Detections& now) const;
  bool may_start(const TrackTable& table, int open, int d, const Detections& detections) const;

  RegionGrowthOptions options_;
};

}  // namespace survtrack
