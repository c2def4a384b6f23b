// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "survtrack/core/geometry.hpp"
#include "survtrack/tracking/path.hpp"
#include "survtrack/tracking/region_options.hpp"

namespace survtrack {

/// What is expected of an object in the coming frame.
struct ExpectedObject {
  Point before;                    ///< px, its position in the frame before
  Point position;                  ///< px, the predicted one
  Symmetric2 covariance_px2;       ///< of the predicted position
  Box box;                         ///< px, its box at the predicted position
  double lost_s = 0.0;             ///< time since it was found last, at the frame before the coming one
};

/// Where an object that is bound to a path is expected: along (S) and across (T) instead of x and y.
struct ExpectedOnPath {
  PathPosition before;
  PathPosition position;
  Symmetric2 covariance_px2;  ///< xx: of S, yy: of T
};

/// The part of the coming frame that must be read to see the object (O'Malley 2000, 4): about its predicted position,
/// `sigmas_along` standard deviations along the way from `before` and `sigmas_across` across it, and then what its size
/// asks for. Axis-parallel; not cut to the frame. Throws `InputError` for what is not finite or a box without size.
Box predicted_region(const PredictedRegionsOptions& options, const ExpectedObject& object);

/// The same with the reach in the path's coordinates: the box around that piece of the path's band.
Box predicted_region(const PredictedRegionsOptions& options, const ExpectedObject& object, const Path& path,
                     const ExpectedOnPath& place);

}  // namespace survtrack
