// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "survtrack/blobs/options.hpp"

namespace survtrack {

/// A horizontal stretch of foreground pixels: row `y`, columns `x_begin` to `x_end` - 1.
struct Run {
  int y = 0;
  int x_begin = 0;
  int x_end = 0;
  int label = 0;  ///< number of its blob, from 0 in the order of each blob's first pixel
};

/// 4- or 8-connected components of sparse masks by runs: row-wise runs, joined by union-find with those of the
/// row above. Costs one read of the mask plus work per run, and nothing per background pixel.
class RunLabeller {
 public:
  explicit RunLabeller(Connectivity connectivity = Connectivity::eight) : connectivity_(connectivity) {}

  /// Labels a mask (CV_8UC1, not 0 is foreground; strided views are fine). The runs come in raster order
  /// and are valid until the next call. Throws `InputError` for anything else than a mask.
  const std::vector<Run>& label(const cv::Mat& mask);

  /// Number of components found by the last `label`.
  int count() const { return count_; }

 private:
  void join(std::size_t above, std::size_t above_end, std::size_t begin);
  int root(int label);
  int unite(int a, int b);
  void number_components();

  Connectivity connectivity_;
  std::vector<Run> runs_;
  std::vector<int> parent_;  ///< union-find over provisional labels
  int count_ = 0;
};

}  // namespace survtrack
