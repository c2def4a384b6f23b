// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "survtrack/core/fields.hpp"

namespace survtrack {

/// Which foreground regions count as detections, and how the tracker's expectation divides and joins them.
struct BlobOptions {
  double min_area_px = 0.0;
  double min_area_fraction = 1e-4;
  int max_blobs = 500;
  bool merge_fragments = true;
  double min_fragment_fraction = 2e-5;
  double merge_gap = 0.25;
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
        field("merge_fragments", &O::merge_fragments, "", "join fragments that stand above each other, up to an object's height"),
        field("min_fragment_fraction", &O::min_fragment_fraction, "",
              "smaller fragments, as a part of the frame's area, are noise", between(0, 1)),
        field("merge_gap", &O::merge_gap, "object heights", "widest gap between fragments that are joined", between(0, 10)),
        field("share_blobs", &O::share_blobs, "", "divide a blob that covers several expected tracks among them"),
        field("share_cover", &O::share_cover, "", "a track is covered when more than this part of its expected box is",
              between(0, 1)),
        field("share_lost_s", &O::share_lost_s, "s", "tracks lost for longer get no share", between(0, 1e6)),
        field("min_relative_height", &O::min_relative_height, "object heights",
              "unexpected blobs lower than this part of what the scene's scale says are dropped", between(0, 1)));
  }
};

}  // namespace survtrack
