// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "segmentation/scene_measures.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace survtrack {
namespace {

double part(std::int64_t some, std::size_t all) { return static_cast<double>(some) / static_cast<double>(all); }

/// Sums of a block's grey levels, three times as large.
struct BlockSums {
  std::int64_t count = 0;
  std::int64_t sum = 0;
  std::int64_t square_sum = 0;

  double mean() const { return static_cast<double>(sum) / (3.0 * static_cast<double>(count)); }
  double deviation() const {
    const std::int64_t scaled = count * square_sum - sum * sum;  // exact, and never below 0
    return std::sqrt(static_cast<double>(scaled)) / (3.0 * static_cast<double>(count));
  }
};

std::vector<BlockSums> blocks_of(const SceneSample& sample, int side) {
  std::vector<BlockSums> blocks(static_cast<std::size_t>(side) * static_cast<std::size_t>(side));
  std::size_t i = 0;
  for (int row = 0; row < sample.grid.rows; ++row) {
    for (int column = 0; column < sample.grid.columns; ++column, ++i) {
      const int block = row * side / sample.grid.rows * side + column * side / sample.grid.columns;
      BlockSums& sums = blocks[static_cast<std::size_t>(block)];
      const std::int64_t level = sample.sum(i);
      ++sums.count;
      sums.sum += level;
      sums.square_sum += level * level;
    }
  }
  return blocks;
}

std::vector<std::int32_t> histogram_of(const SceneSample& sample, int bins) {
  std::vector<std::int32_t> histogram(static_cast<std::size_t>(bins * bins * bins));
  for (std::size_t i = 0; i < sample.count(); ++i) {
    int bin = 0;
    for (std::size_t c = 0; c < 3; ++c) bin = bin * bins + sample.levels[3 * i + c] * bins / 256;
    ++histogram[static_cast<std::size_t>(bin)];
  }
  return histogram;
}

}  // namespace

double scene_difference(const ChangedPixelsOptions& options, const SceneSample& a, const SceneSample& b) {
  std::int64_t changed = 0;
  for (std::size_t i = 0; i < a.count(); ++i) {
    int most = 0;
    for (std::size_t c = 0; c < 3; ++c) most = std::max(most, std::abs(a.levels[3 * i + c] - b.levels[3 * i + c]));
    changed += most > options.difference ? 1 : 0;
  }
  return part(changed, a.count());
}

double scene_difference(const BlocksOptions& options, const SceneSample& a, const SceneSample& b) {
  const std::vector<BlockSums> blocks_a = blocks_of(a, options.blocks_a_side);
  const std::vector<BlockSums> blocks_b = blocks_of(b, options.blocks_a_side);
  std::int64_t changed = 0;
  std::size_t all = 0;
  for (std::size_t i = 0; i < blocks_a.size(); ++i) {
    if (blocks_a[i].count == 0) continue;  // small frames have fewer samples than blocks
    ++all;
    const bool differs = std::abs(blocks_a[i].mean() - blocks_b[i].mean()) > options.mean_difference ||
                         std::abs(blocks_a[i].deviation() - blocks_b[i].deviation()) > options.deviation_difference;
    changed += differs ? 1 : 0;
  }
  return part(changed, all);
}

double scene_difference(const HistogramOptions& options, const SceneSample& a, const SceneSample& b) {
  const std::vector<std::int32_t> histogram_a = histogram_of(a, options.bins);
  const std::vector<std::int32_t> histogram_b = histogram_of(b, options.bins);
  std::int64_t common = 0;
  for (std::size_t i = 0; i < histogram_a.size(); ++i) common += std::min(histogram_a[i], histogram_b[i]);
  return 1.0 - part(common, a.count());
}

double scene_difference(const KolmogorovSmirnovOptions& /*has none for this*/, const SceneSample& a,
                        const SceneSample& b) {
  std::vector<std::int64_t> more(3 * 255 + 1);  // in a than in b, of each level
  for (std::size_t i = 0; i < a.count(); ++i) {
    ++more[static_cast<std::size_t>(a.sum(i))];
    --more[static_cast<std::size_t>(b.sum(i))];
  }
  std::int64_t cumulative = 0;
  std::int64_t most = 0;
  for (const std::int64_t difference : more) {
    cumulative += difference;
    most = std::max(most, std::abs(cumulative));
  }
  return part(most, a.count());
}

}  // namespace survtrack
