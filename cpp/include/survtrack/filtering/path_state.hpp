// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "survtrack/core/geometry.hpp"
#include "survtrack/core/path_position.hpp"

namespace survtrack {

class Path;

/// What a filter along a path believes, by that path.
struct PathState {
  const Path* path = nullptr;   ///< as long as the filter runs
  PathPosition place_before;    ///< estimate before the last prediction
  PathPosition predicted;       ///< estimate now: after `predict` the predicted one, after `correct` the corrected one
  PathPosition velocity;        ///< px per time unit
  Symmetric2 covariance_px2;    ///< of `predicted`, over (S, T)
};

}  // namespace survtrack
