// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <opencv2/core/mat.hpp>

#include "survtrack/core/detection.hpp"
#include "survtrack/tracking/tracking_result.hpp"

namespace survtrack {

/// Everything about one processed frame.
struct FrameResult : TrackingResult {
  /// The frame itself. With a pipeline without delay it shares the caller's pixels, otherwise it is a copy.
  cv::Mat frame;
  Detections detections;

  const cv::Mat& mask() const { return detections.mask; }
};

}  // namespace survtrack
