// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <memory>
#include <opencv2/core/mat.hpp>

#include "survtrack/segmentation/cleanup_options.hpp"

namespace survtrack {

/// Removes noise from a mask (CV_8UC1, 0 or 255; strided views are fine) in place: median, opening,
/// closing as the options say. The border takes no part: an object that touches it keeps its shape,
/// and no gap between an object and the border is filled. Allocates nothing while the size stays.
class Cleanup {
 public:
  /// Throws `ConfigError` for options out of their ranges.
  explicit Cleanup(const CleanupOptions& options);
  ~Cleanup();
  Cleanup(Cleanup&&) noexcept;
  Cleanup& operator=(Cleanup&&) noexcept;

  void apply(cv::Mat& mask);

 private:
  struct Steps;
  std::unique_ptr<Steps> steps_;
};

}  // namespace survtrack
