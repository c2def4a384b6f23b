// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "segmentation/scene_sample.hpp"
#include "survtrack/segmentation/scene_change_options.hpp"

namespace survtrack {

/// How much two pictures on one grid differ, 0 to 1 (Nashenda 2011, 3.1.1); symmetric, and 0 of a picture and itself.
double scene_difference(const ChangedPixelsOptions& options, const SceneSample& a, const SceneSample& b);
double scene_difference(const BlocksOptions& options, const SceneSample& a, const SceneSample& b);
double scene_difference(const HistogramOptions& options, const SceneSample& a, const SceneSample& b);
double scene_difference(const KolmogorovSmirnovOptions& options, const SceneSample& a, const SceneSample& b);

}  // namespace survtrack
