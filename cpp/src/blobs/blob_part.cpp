// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "survtrack/blobs/blob_part.hpp"

#include <algorithm>

namespace survtrack {

void BlobPart::add(const Run& run) {
  const bool first = area_px == 0;
  left = first ? run.x_begin : std::min(left, run.x_begin);
  top = first ? run.y : std::min(top, run.y);
  right = std::max(right, run.x_end);
  bottom = std::max(bottom, run.y + 1);
  area_px += run.x_end - run.x_begin;
}

void BlobPart::add(const BlobPart& other) {
  left = std::min(left, other.left);
  top = std::min(top, other.top);
  right = std::max(right, other.right);
  bottom = std::max(bottom, other.bottom);
  area_px += other.area_px;
}

void measure_parts(const std::vector<Run>& runs, int count, std::vector<BlobPart>& parts) {
  parts.assign(static_cast<std::size_t>(count), BlobPart{});
  for (const Run& run : runs) parts[static_cast<std::size_t>(run.label)].add(run);
}

}  // namespace survtrack
