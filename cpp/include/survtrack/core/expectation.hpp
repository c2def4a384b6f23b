// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "survtrack/core/geometry.hpp"
#include "survtrack/core/region.hpp"
#include "survtrack/core/scene_scale.hpp"
#include "survtrack/core/vicinity_grid.hpp"

namespace survtrack {

/// A track as the tracker expects to see it in the coming frame.
struct PredictedTrack {
  std::int64_t id = 0;     ///< 0: tentative
  bool confirmed = false;  ///< believed in: confirmed, or lost after having been confirmed
  Box box;                 ///< px
  Point position;          ///< px
  Point velocity_px_per_s;
  Symmetric2 innovation_covariance_px2;  ///< of the measurement about its predicted position
  double lost_s = 0.0;     ///< time since its last detection, at the coming frame
};

/// The only thing that flows backwards: what the tracker expects of the coming frame.
struct Expectation {
  double time_s = 0.0;                 ///< the coming frame's time
  std::vector<PredictedTrack> tracks;
  SceneScale scale;                    ///< how large objects are, where
  std::optional<VicinityGrid> vicinity;  ///< how much things move, where; with vicinity.model grid
  bool only_regions = false;           ///< only `regions` are read, and what the detector refreshes in turn; else all is
  std::vector<Region> regions;         ///< where to look
  std::vector<Box> keep;               ///< places that the background must not learn
};

}  // namespace survtrack
