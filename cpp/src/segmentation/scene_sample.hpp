// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <vector>

namespace survtrack {

/// Where samples lie: the middles of `columns` x `rows` equal cells of the frame.
struct SceneGrid {
  int columns = 0;
  int rows = 0;
  std::size_t count() const { return static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows); }
};

/// At most `samples` cells, about as wide as high.
SceneGrid scene_grid(const cv::Size& frame, int samples);

/// A frame as its samples, row by row: blue, green, red; of a grey frame three times the grey level.
struct SceneSample {
  SceneGrid grid;
  std::vector<std::uint8_t> levels;
  std::size_t count() const { return levels.size() / 3; }
  /// blue + green + red: three times the grey level.
  int sum(std::size_t i) const { return levels[3 * i] + levels[3 * i + 1] + levels[3 * i + 2]; }
};

/// Each sample is the mean, rounded, of the square of `low_pass_px` about its place, as far as it lies in the frame.
void take_sample(const cv::Mat& frame, const SceneGrid& grid, int low_pass_px, SceneSample& sample);

/// Mean of largest less smallest channel, grey levels.
double color_of(const SceneSample& sample);

/// Part of the samples in which no channel is above `level`.
double black_part_of(const SceneSample& sample, int level);

/// Correlation of grey levels; 0 when either has one level only.
double correlation(const SceneSample& a, const SceneSample& b);

}  // namespace survtrack
