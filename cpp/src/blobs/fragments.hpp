// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <vector>

#include "survtrack/blobs/blob_part.hpp"
#include "survtrack/blobs/options.hpp"
#include "survtrack/core/expectation.hpp"

namespace survtrack {

/// Joins fragments that stand above each other: legs and body of one person. The limit is the height that is
/// expected there: of the track whose predicted box holds most of the two, else of the scene's scale.
/// Runs get the label of the part they end in; the others are dropped.
void merge_fragments(const BlobOptions& options, const Expectation& expectation, std::vector<Run>& runs,
                     std::vector<BlobPart>& parts);

}  // namespace survtrack
