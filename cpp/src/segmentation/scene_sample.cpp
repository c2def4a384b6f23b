// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "segmentation/scene_sample.hpp"

#include <algorithm>
#include <cmath>

namespace survtrack {
namespace {

/// The rounded means of each channel over a rectangle.
template <int channels>
void mean_of(const cv::Mat& frame, const cv::Rect& rect, std::uint8_t* mean) {
  unsigned sums[channels] = {};
  const std::size_t stride = frame.step[0];
  const std::uint8_t* row = frame.data + static_cast<std::size_t>(rect.y) * stride + static_cast<std::size_t>(rect.x) * channels;
  for (int y = 0; y < rect.height; ++y, row += stride) {
    for (int x = 0; x < rect.width; ++x) {
      for (int c = 0; c < channels; ++c) sums[c] += row[x * channels + c];
    }
  }
  const auto area = static_cast<unsigned>(rect.area());
  for (int c = 0; c < channels; ++c) mean[c] = static_cast<std::uint8_t>((2 * sums[c] + area) / (2 * area));
  if (channels == 1) mean[1] = mean[2] = mean[0];
}

}  // namespace

SceneGrid scene_grid(const cv::Size& frame, int samples) {
  const double area = static_cast<double>(frame.width) * frame.height;
  const double cell_px = std::max(1.0, std::sqrt(area / samples));
  SceneGrid grid;
  grid.columns = std::clamp(static_cast<int>(frame.width / cell_px), 1, std::min(frame.width, samples));
  grid.rows = std::clamp(static_cast<int>(frame.height / cell_px), 1, std::min(frame.height, samples / grid.columns));
  return grid;
}

void take_sample(const cv::Mat& frame, const SceneGrid& grid, int low_pass_px, SceneSample& sample) {
  sample.grid = grid;
  sample.levels.resize(3 * grid.count());
  const cv::Rect whole(0, 0, frame.cols, frame.rows);
  const int side = std::max(low_pass_px, 1);
  const auto middle = [](int cell, int cells, int size) {
    return static_cast<int>((2 * std::int64_t{cell} + 1) * size / (2 * std::int64_t{cells}));
  };
  std::uint8_t* levels = sample.levels.data();
  for (int row = 0; row < grid.rows; ++row) {
    const int y = middle(row, grid.rows, frame.rows);
    for (int column = 0; column < grid.columns; ++column, levels += 3) {
      const int x = middle(column, grid.columns, frame.cols);
      const cv::Rect rect = cv::Rect(x - side / 2, y - side / 2, side, side) & whole;
      if (frame.channels() == 3) {
        mean_of<3>(frame, rect, levels);
      } else {
        mean_of<1>(frame, rect, levels);
      }
    }
  }
}

double color_of(const SceneSample& sample) {
  std::int64_t sum = 0;
  for (std::size_t i = 0; i < sample.count(); ++i) {
    const auto [least, most] = std::minmax({sample.levels[3 * i], sample.levels[3 * i + 1], sample.levels[3 * i + 2]});
    sum += most - least;
  }
  return static_cast<double>(sum) / static_cast<double>(sample.count());
}

double black_part_of(const SceneSample& sample, int level) {
  std::size_t black = 0;
  for (std::size_t i = 0; i < sample.count(); ++i) {
    const std::uint8_t* const levels = sample.levels.data() + 3 * i;
    black += std::max({levels[0], levels[1], levels[2]}) <= level ? 1 : 0;
  }
  return static_cast<double>(black) / static_cast<double>(sample.count());
}

double correlation(const SceneSample& a, const SceneSample& b) {
  std::int64_t sum_a = 0, sum_b = 0, sum_aa = 0, sum_bb = 0, sum_ab = 0;
  for (std::size_t i = 0; i < a.count(); ++i) {
    const std::int64_t level_a = a.sum(i);
    const std::int64_t level_b = b.sum(i);
    sum_a += level_a;
    sum_b += level_b;
    sum_aa += level_a * level_a;
    sum_bb += level_b * level_b;
    sum_ab += level_a * level_b;
  }
  const auto n = static_cast<double>(a.count());
  const double variance_a = static_cast<double>(sum_aa) - static_cast<double>(sum_a) * static_cast<double>(sum_a) / n;
  const double variance_b = static_cast<double>(sum_bb) - static_cast<double>(sum_b) * static_cast<double>(sum_b) / n;
  const double least = 1e-9 * (1.0 + static_cast<double>(sum_aa) + static_cast<double>(sum_bb));
  if (variance_a <= least || variance_b <= least) return 0.0;
  const double covariance = static_cast<double>(sum_ab) - static_cast<double>(sum_a) * static_cast<double>(sum_b) / n;
  return std::clamp(covariance / std::sqrt(variance_a * variance_b), -1.0, 1.0);
}

}  // namespace survtrack
