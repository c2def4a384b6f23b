// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <vector>

#include "survtrack/blobs/blob_part.hpp"
#include "survtrack/blobs/options.hpp"
#include "survtrack/core/expectation.hpp"

namespace survtrack {

/// Divides blobs that cover several expected tracks, or are much larger than the one they cover: each pixel goes
/// to the track in whose predicted box it lies deepest, and what is far from all is a part of its own.
class BlobSharer {
 public:
  /// Cuts the runs, adds the new parts, and marks those where a track is expected. Shares smaller than
  /// `min_area_px` are dropped.
  void share(const BlobOptions& options, const Expectation& expectation, double min_area_px, std::vector<Run>& runs,
             std::vector<BlobPart>& parts);

 private:
  /// A part that is divided among `count` tracks of `tracks_`, into as many parts and one for the rest.
  struct Division {
    std::size_t part;
    std::size_t first_track;
    std::size_t count;
    std::size_t first_new_part;
  };

  void find_divisions(const BlobOptions& options, const Expectation& expectation, std::vector<BlobPart>& parts);
  bool must_be_shared(const BlobPart& part, std::size_t first_track) const;
  std::size_t owner(const Division& division, int x, int y) const;
  void cut_run(const Run& run, const Division& division, std::vector<BlobPart>& parts);
  void settle(const Division& division, double min_area_px, std::vector<BlobPart>& parts) const;

  std::vector<const PredictedTrack*> tracks_;
  std::vector<Division> divisions_;
  std::vector<int> division_of_part_;  ///< -1: none
  std::vector<Run> cut_runs_;
};

}  // namespace survtrack
