// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <vector>

#include "survtrack/core/geometry.hpp"

namespace survtrack {

struct PathShape;

/// Each point for itself, against its neighbours, and the largest distance. Throws `InputError`.
void check_path_points(const std::vector<Point>& points, bool closed, double max_distance_px);

/// That a path nowhere meets itself, by its chords. Throws `InputError`.
void check_path_crossings(const PathShape& shape);

}  // namespace survtrack
