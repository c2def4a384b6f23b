// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <vector>

#include "offline/way.hpp"

namespace survtrack {

/// Places in a list of ways, in its order.
using WayGroup = std::vector<std::size_t>;

/// Groups of at least `min_tracks` ways that are the same as the group's mean way, the largest first, of equal ones that
/// with the first way. A way belongs to one group or none. Of equally good choices the first way's is taken.
std::vector<WayGroup> group_ways(const std::vector<Way>& ways, const PatternOptions& options);

/// Mean of corresponding points of some of the ways.
std::vector<Point> mean_points(const std::vector<Way>& ways, const WayGroup& group);

/// Mean of their sizes, px.
double mean_size_px(const std::vector<Way>& ways, const WayGroup& group);

}  // namespace survtrack
