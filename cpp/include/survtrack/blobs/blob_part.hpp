// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <vector>

#include "survtrack/blobs/run_labeller.hpp"
#include "survtrack/core/geometry.hpp"

namespace survtrack {

/// The pixels of one label while blobs are joined and divided; runs point to their part by `Run::label`.
struct BlobPart {
  int left = 0, top = 0, right = 0, bottom = 0;  ///< right and bottom: one beyond
  std::int64_t area_px = 0;
  bool dropped = false;
  bool expected = false;  ///< a track is expected here
  bool shared = false;    ///< cut out of a blob that covers several tracks

  Box box() const {
    return {static_cast<double>(left), static_cast<double>(top), static_cast<double>(right - left),
            static_cast<double>(bottom - top)};
  }
  void add(const Run& run);
  void add(const BlobPart& other);
};

/// Box and area of each label.
void measure_parts(const std::vector<Run>& runs, int count, std::vector<BlobPart>& parts);

}  // namespace survtrack
