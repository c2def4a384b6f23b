// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "survtrack/association/cost_matrix.hpp"
#include "survtrack/association/options.hpp"
#include "survtrack/core/detection.hpp"
#include "survtrack/core/track.hpp"

namespace survtrack {

/// How a detection would measure a track.
struct Innovation {
  Point residual;           ///< observed minus predicted position, px
  Symmetric2 covariance_px2;  ///< S
};

/// Squared Mahalanobis distance r' S^-1 r.
double squared_mahalanobis(const Innovation& innovation);

/// Cost of a pair by eq. 3.6 of Narayana 2007: distance in parts of the frame's sides plus distance in colour.
double match_matrix_entry(const Track& track, const Detection& detection, double frame_width, double frame_height);

/// Cost of a pair: d^2 + ln(det S / size^4); infinite beyond the gate on d^2.
/// `track_area_px` is the area of the track's box, the unit of size^2.
double gaussian_cost(const GaussianCostOptions& options, const Innovation& innovation, double track_area_px);

}  // namespace survtrack
