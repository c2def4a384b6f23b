// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <array>
#include <utility>
#include <variant>

#include "survtrack/core/fields.hpp"

namespace survtrack {

/// Which neighbours belong to the same blob.
enum class Connectivity {
  four,   ///< those that share an edge
  eight,  ///< those that share an edge or a corner
};
constexpr auto enum_names(Connectivity) {
  return std::array{std::pair{"four", Connectivity::four}, std::pair{"eight", Connectivity::eight}};
}

/// Joins fragments that stand above each other, up to the height of an object.
struct FragmentMergeOptions {
  static constexpr const char* model = "fragments";
  static constexpr const char* meaning = "join fragments that stand above each other, up to an object's height";

  double min_fragment_fraction = 2e-5;
  double gap = 0.25;

  static constexpr auto fields() {
    using O = FragmentMergeOptions;
    return std::make_tuple(
        field("min_fragment_fraction", &O::min_fragment_fraction, "",
              "smaller fragments, as a part of the frame's area, are noise", between(0, 1)),
        field("gap", &O::gap, "object heights", "widest gap between fragments that are joined", between(0, 10)));
  }
};

/// The merge module of Narayana 2007, 4.1: blobs whose centroids and mean colours are close are one object.
struct CloseMergeOptions {
  static constexpr const char* model = "close";
  static constexpr const char* meaning =
      "join blobs whose centroids and mean colours are close (Narayana 2007, eq. 4.1)";

  double threshold_y_px = 10.0;
  double threshold_x_px = 10.0;
  double color_threshold = 50.0;
  bool vicinity_scaled = false;

  static constexpr auto fields() {
    using O = CloseMergeOptions;
    return std::make_tuple(
        field("threshold_y_px", &O::threshold_y_px, "px", "largest vertical distance of the centroids", between(0, 1e6)),
        field("threshold_x_px", &O::threshold_x_px, "px", "largest horizontal distance of the centroids", between(0, 1e6)),
        field("color_threshold", &O::color_threshold, "grey levels", "largest difference in each mean colour channel",
              between(0, 255)),
        field("vicinity_scaled", &O::vicinity_scaled, "",
              "multiply the distances by the vicinity factor between the two (6.4); needs vicinity.model grid"));
  }
};

/// Every connected region is a blob of its own.
struct NoMergeOptions {
  static constexpr const char* model = "none";
  static constexpr const char* meaning = "every connected region is a blob of its own";
  static constexpr auto fields() { return std::make_tuple(); }
};

using MergeOptions = std::variant<FragmentMergeOptions, CloseMergeOptions, NoMergeOptions>;

/// Which foreground regions count as detections, and how the tracker's expectation divides and joins them.
struct BlobOptions {
  double min_area_px = 0.0;
  double min_area_fraction = 1e-4;
  int max_blobs = 500;
  Connectivity connectivity = Connectivity::eight;
  MergeOptions merge;
  bool share_blobs = true;
  double share_cover = 0.5;
  double share_lost_s = 1.0;
  double min_relative_height = 0.5;

  static constexpr auto fields() {
    using O = BlobOptions;
    return std::make_tuple(
        field("min_area_px", &O::min_area_px, "px^2", "smaller blobs are dropped (S of Narayana 2007, 3.3)", between(0, 1e9)),
        field("min_area_fraction", &O::min_area_fraction, "", "the same, as a part of the frame's area; the larger counts",
              between(0, 1)),
        field("max_blobs", &O::max_blobs, "", "of more blobs in one frame the largest are kept", between(1, 100000)),
        field("connectivity", &O::connectivity, "", "pixels of one region meet at an edge, or at a corner too"),
        field("merge", &O::merge, "", "which regions are one blob"),
        field("share_blobs", &O::share_blobs, "", "divide a blob that covers several expected tracks among them"),
        field("share_cover", &O::share_cover, "", "a track is covered when more than this part of its expected box is",
              between(0, 1)),
        field("share_lost_s", &O::share_lost_s, "s", "tracks lost for longer get no share", between(0, 1e6)),
        field("min_relative_height", &O::min_relative_height, "object heights",
              "unexpected blobs lower than this part of what the scene's scale says are dropped", between(0, 1)));
  }
};

}  // namespace survtrack
