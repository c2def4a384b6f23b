// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <vector>

#include "survtrack/blobs/blob_part.hpp"
#include "survtrack/blobs/options.hpp"
#include "survtrack/core/expectation.hpp"

namespace survtrack {

/// Joins fragments that stand above each other: legs and body of one person. The limit is the height that is
/// expected there: of the track whose predicted box holds most of the two, else of the scene's scale.
class FragmentMerger {
 public:
  /// Runs get the label of the part they end in; the other parts are dropped.
  void merge(const FragmentMergeOptions& options, const Expectation& expectation, std::vector<Run>& runs,
             std::vector<BlobPart>& parts);

 private:
  int final_label(int label) const;

  std::vector<std::size_t> open_;  ///< parts that are still their own, from left to right
  std::vector<int> target_;        ///< the part that a part was joined to
};

}  // namespace survtrack
