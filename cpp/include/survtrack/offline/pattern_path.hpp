// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <limits>
#include <optional>

#include "survtrack/offline/patterns.hpp"
#include "survtrack/tracking/path.hpp"

namespace survtrack {

/// The path along a pattern's way. It is closed when the way, having been twice as far away, comes back to within
/// `close_within_px` of its start (none: the objects' size), in about the direction in which it left: where it passes the
/// start, or where it ends before it. What comes after is another lap and left out, and so are last points that are
/// nearer to the first than half of the mean step. Throws `InputError` as Path does, such as for a way that meets itself
/// elsewhere.
Path path_of_pattern(const Pattern& pattern, PathKind kind = PathKind::curve, std::optional<double> close_within_px = {},
                     double max_distance_px = std::numeric_limits<double>::infinity());

}  // namespace survtrack
