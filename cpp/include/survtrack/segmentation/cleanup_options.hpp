// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <variant>

#include "survtrack/core/fields.hpp"
#include "survtrack/segmentation/tiled_morphology.hpp"

namespace survtrack {

/// No erosion and dilation with edges of their own.
struct NoTilingOptions {
  static constexpr const char* model = "none";
  static constexpr const char* meaning = "no erosion and dilation with edges of their own";
  static constexpr auto fields() { return std::make_tuple(); }
};

/// Erosion, then dilation of the whole frame.
struct WholeFrameOptions {
  static constexpr const char* model = "whole";
  static constexpr const char* meaning = "erosion, then dilation of the whole frame, with edges of their own";

  int erode_px = 4;
  int dilate_px = 14;
  MorphologyShape shape = MorphologyShape::square;

  static constexpr auto fields() {
    using O = WholeFrameOptions;
    return std::make_tuple(
        field("erode_px", &O::erode_px, "px", "edge of the erosion's element; 0 and 1 leave it out", between(0, 99)),
        field("dilate_px", &O::dilate_px, "px", "edge of the dilation's element; 0 and 1 leave it out", between(0, 99)),
        field("shape", &O::shape, "", "shape of both elements"));
  }
};

/// Erosion, then dilation of each quarter of the frame (Semko 2007); the defaults are the published numbers, for
/// 384x288. A grid of any size: `TiledMorphology`.
struct QuadrantsOptions {
  static constexpr const char* model = "quadrants";
  static constexpr const char* meaning =
      "erosion, then dilation of each quarter of the frame, with edges of its own (Semko 2007)";

  int overlap_px = 10;
  MorphologyShape shape = MorphologyShape::square;
  int erode_top_left_px = 4;
  int dilate_top_left_px = 11;
  int erode_top_right_px = 4;
  int dilate_top_right_px = 14;
  int erode_bottom_left_px = 4;
  int dilate_bottom_left_px = 14;
  int erode_bottom_right_px = 4;
  int dilate_bottom_right_px = 15;

  static constexpr auto fields() {
    using O = QuadrantsOptions;
    constexpr auto edge = between(0, 99);
    return std::make_tuple(
        field("overlap_px", &O::overlap_px, "px",
              "by which a quarter reads beyond each mid-line, at least half its two edges together", between(0, 99)),
        field("shape", &O::shape, "", "shape of all elements"),
        field("erode_top_left_px", &O::erode_top_left_px, "px", "edge of the erosion's element; 0 and 1 leave it out", edge),
        field("dilate_top_left_px", &O::dilate_top_left_px, "px", "edge of the dilation's element; 0 and 1 leave it out", edge),
        field("erode_top_right_px", &O::erode_top_right_px, "px", "the same, top right", edge),
        field("dilate_top_right_px", &O::dilate_top_right_px, "px", "the same, top right", edge),
        field("erode_bottom_left_px", &O::erode_bottom_left_px, "px", "the same, bottom left", edge),
        field("dilate_bottom_left_px", &O::dilate_bottom_left_px, "px", "the same, bottom left", edge),
        field("erode_bottom_right_px", &O::erode_bottom_right_px, "px", "the same, bottom right", edge),
        field("dilate_bottom_right_px", &O::dilate_bottom_right_px, "px", "the same, bottom right", edge));
  }
};

using TilingOptions = std::variant<NoTilingOptions, WholeFrameOptions, QuadrantsOptions>;

/// Noise removal on the mask, in this order: temporal median, median, opening, closing, erosion and dilation by
/// tiles. 0 leaves a step out.
struct CleanupOptions {
  int median_px = 5;
  int open_px = 0;
  int close_px = 0;
  int temporal_median_frames = 0;
  TilingOptions tiling = NoTilingOptions{};

  static constexpr auto fields() {
    using O = CleanupOptions;
    return std::make_tuple(
        field("median_px", &O::median_px, "px", "side of the median's square", odd_up_to(31)),
        field("open_px", &O::open_px, "px", "side of the opening's square: removes what is thinner", odd_up_to(99)),
        field("close_px", &O::close_px, "px", "side of the closing's square: joins over narrower gaps",
              odd_up_to(99)),
        field("temporal_median_frames", &O::temporal_median_frames, "frames",
              "foreground is what is so in more than half of this many masks; comes before the other steps; 0 and 1: off",
              odd_up_to(999)),
        field("tiling", &O::tiling, "", "erosion, then dilation of the mask, with edges of their own; comes last"));
  }
};

/// Throws `ConfigError`, its message starting with `path`, for what no range of a single option refuses: an overlap
/// below the reach of its edges.
void check_tiling(const TilingOptions& options, const std::string& path = "tiling");

}  // namespace survtrack
