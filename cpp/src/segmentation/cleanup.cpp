// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "survtrack/segmentation/cleanup.hpp"

#include <optional>
#include <string>

#include "core/check_mask.hpp"
#include "segmentation/mask_median.hpp"
#include "segmentation/mask_morphology.hpp"
#include "segmentation/mask_temporal_median.hpp"
#include "survtrack/core/errors.hpp"

namespace survtrack {

using kernels::MaskMedian;
using kernels::MaskMorphology;
using kernels::MaskTemporalMedian;

namespace {

std::optional<TileGrid> grid_of(const TilingOptions& options) {
  if (const auto* whole = std::get_if<WholeFrameOptions>(&options)) {
    return TileGrid{1, 1, 0, whole->shape, {{whole->erode_px, whole->dilate_px}}};
  }
  if (const auto* quadrants = std::get_if<QuadrantsOptions>(&options)) {
    const QuadrantsOptions& q = *quadrants;
    return TileGrid{2, 2, q.overlap_px, q.shape,
                    {{q.erode_top_left_px, q.dilate_top_left_px},
                     {q.erode_top_right_px, q.dilate_top_right_px},
                     {q.erode_bottom_left_px, q.dilate_bottom_left_px},
                     {q.erode_bottom_right_px, q.dilate_bottom_right_px}}};
  }
  return std::nullopt;
}

void check_size(const MaskTemporalMedian& median, const cv::Mat& mask) {
  const auto height = static_cast<int>(median.height()), width = static_cast<int>(median.width());
  if (median.empty() || (mask.rows == height && mask.cols == width)) return;
  throw InputError("mask: is " + std::to_string(mask.rows) + "x" + std::to_string(mask.cols) +
                   ", the masks before were " + std::to_string(height) + "x" + std::to_string(width) +
                   "; temporal_median_frames takes one size (reset() starts another)");
}

}  // namespace

void check_tiling(const TilingOptions& options, const std::string& path) {
  if (const auto grid = grid_of(options)) check_tile_grid(*grid, path);
}

struct Cleanup::Steps {
  std::optional<MaskTemporalMedian> temporal_median;
  std::optional<MaskMedian> median;
  std::optional<MaskMorphology> opening;
  std::optional<MaskMorphology> closing;
  std::optional<TiledMorphology> tiling;
};

// A square of one pixel changes nothing, nor does the median of one mask.
Cleanup::Cleanup(const CleanupOptions& options) : steps_(std::make_unique<Steps>()) {
  check_fields(options);
  check_tiling(options.tiling);
  if (options.temporal_median_frames > 1) steps_->temporal_median.emplace(options.temporal_median_frames);
  if (options.median_px > 1) steps_->median.emplace(options.median_px);
  if (options.open_px > 1) steps_->opening.emplace(MaskMorphology::Operation::opening, options.open_px);
  if (options.close_px > 1) steps_->closing.emplace(MaskMorphology::Operation::closing, options.close_px);
  if (const auto grid = grid_of(options.tiling)) steps_->tiling.emplace(*grid);
}

Cleanup::~Cleanup() = default;
Cleanup::Cleanup(Cleanup&&) noexcept = default;
Cleanup& Cleanup::operator=(Cleanup&&) noexcept = default;

void Cleanup::apply(cv::Mat& mask) {
  check_mask(mask);
  if (steps_->temporal_median) check_size(*steps_->temporal_median, mask);
  if (steps_->tiling) steps_->tiling->check(mask);
  const kernels::MaskView view{mask.data, static_cast<std::size_t>(mask.cols), static_cast<std::size_t>(mask.rows),
                               mask.step[0]};
  if (steps_->temporal_median) steps_->temporal_median->apply(view);
  if (steps_->median) steps_->median->apply(view);
  if (steps_->opening) steps_->opening->apply(view);
  if (steps_->closing) steps_->closing->apply(view);
  if (steps_->tiling) steps_->tiling->apply(mask);
}

void Cleanup::reset() {
  if (steps_->temporal_median) steps_->temporal_median->reset();
}

}  // namespace survtrack
