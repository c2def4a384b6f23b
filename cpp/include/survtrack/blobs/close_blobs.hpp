// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "survtrack/blobs/blob_part.hpp"
#include "survtrack/blobs/options.hpp"
#include "survtrack/core/expectation.hpp"

namespace survtrack {

/// The merge module (Narayana 2007, 4.1): blobs whose centroids and mean colours differ by no more than thresholds are
/// one object. Pairs are tested on the blobs as they were, so that the order does not matter; what is close to
/// something close belongs to it. The thresholds are fixed, or scaled by the vicinity factor half way (6.4).
class CloseMerger {
 public:
  /// Runs get the label of the part they end in; the other parts are dropped.
  void merge(const CloseMergeOptions& options, const Expectation& expectation, const cv::Mat& frame,
             std::vector<Run>& runs, std::vector<BlobPart>& parts);

 private:
  struct Blob {
    std::size_t part = 0;
    Point centroid;
    Color mean_color;
  };
  void measure(const cv::Mat& frame, const std::vector<Run>& runs, const std::vector<BlobPart>& parts);
  void join_close(const CloseMergeOptions& options, const Expectation& expectation);
  std::size_t root(std::size_t part);

  std::vector<Blob> blobs_;          ///< from top to bottom
  std::vector<std::size_t> parent_;  ///< union-find over parts
};

}  // namespace survtrack
