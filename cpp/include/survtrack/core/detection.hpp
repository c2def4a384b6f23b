// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "survtrack/core/color_histogram.hpp"
#include "survtrack/core/event.hpp"
#include "survtrack/core/geometry.hpp"
#include "survtrack/core/region.hpp"

namespace survtrack {

/// Something seen in one frame: a blob, or a box of the user's own detector.
struct Detection {
  Box box;
  Point position;          ///< px; a blob's centroid over all its pixels (Narayana 2007, 3.3), else the box centre
  double area_px = 0.0;    ///< number of foreground pixels; a box's area for a user's own boxes
  Color mean_color;        ///< over the blob's pixels; zero when there was no image
  Symmetric2 moments_px2;  ///< second central moments over the blob's pixels
  double confidence = 1.0; ///< 1 for blobs; the user's detector's own score otherwise
  int class_id = -1;       ///< -1: no class
  bool shared = false;     ///< a share of a blob that several tracks cover: its edges may not be the object's
};

/// A detection of the user's own: the box, its centre and its area.
inline Detection detection_of_box(const Box& box, double confidence = 1.0) {
  Detection detection;
  detection.box = box;
  detection.position = box.center();
  detection.area_px = box.area_px();
  detection.confidence = confidence;
  return detection;
}

/// All detections of one frame, and what was found out on the way to them.
struct Detections {
  std::int64_t index = 0;  ///< the frame's index in its source
  double time_s = 0.0;
  int frame_width = 0;     ///< px; 0 when unknown (a user's own boxes)
  int frame_height = 0;    ///< px
  std::vector<Detection> items;
  std::vector<std::vector<cv::Point>> contours;  ///< outer contour a detection, when asked for
  std::vector<ColorHistogram> histograms;        ///< of its pixels a detection, with appearance.model color_histogram
  std::vector<Region> regions;  ///< the parts of the frame that were read; they may overlap, and lie in one of the whole frame
  std::int64_t pixels_read = 0;  ///< number of pixels in them, each counted once
  std::vector<Event> events;  ///< raised by the detector
  cv::Mat mask;               ///< CV_8UC1, 0 or 255; empty for a user's own boxes
  cv::Mat background;         ///< the model's background picture, when asked for
  cv::Mat flow;               ///< the model's flow field, CV_32FC2 (px right, down), when asked for; empty while it has none
};

}  // namespace survtrack
