// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <vector>

#include "survtrack/blobs/blob_part.hpp"
#include "survtrack/blobs/options.hpp"
#include "survtrack/core/expectation.hpp"

namespace survtrack {

/// Divides blobs that cover several expected tracks, or are much larger than the one they cover: each pixel goes
/// to the track in whose predicted box it lies deepest, and what is far from all is a part of its own. Marks
/// parts where a track is expected. `min_area_px`: smaller shares are dropped.
void share_blobs(const BlobOptions& options, const Expectation& expectation, double min_area_px, std::vector<Run>& runs,
                 std::vector<BlobPart>& parts);

}  // namespace survtrack
