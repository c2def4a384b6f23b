// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "survtrack/blobs/blob_part.hpp"
#include "survtrack/blobs/close_blobs.hpp"
#include "survtrack/blobs/fragments.hpp"
#include "survtrack/blobs/options.hpp"
#include "survtrack/blobs/run_labeller.hpp"
#include "survtrack/blobs/sharing.hpp"
#include "survtrack/core/detection.hpp"
#include "survtrack/core/expectation.hpp"

namespace survtrack {

/// Turns a mask into detections: components, their statistics (area, centroid, mean colour, box,
/// second moments), dropping what is too small (Narayana 2007, 3.3).
class BlobExtractor {
 public:
  /// Throws `ConfigError` for options out of their ranges.
  explicit BlobExtractor(const BlobOptions& options);

  /// Fills `detections.items` from `mask` (CV_8UC1, not 0 is foreground) and the colours of `frame`
  /// (grey or BGR, same size), in the raster order of the blobs' first pixels, and `.contours` with
  /// their outer contours (corner points, px) if asked, else with nothing. Sums are exact: area, mean colour
  /// and moments do not depend on where a blob lies. Throws `InputError` for a mask or frame it cannot read.
  void extract(const cv::Mat& mask, const cv::Mat& frame, const Expectation& expectation, bool contours,
               Detections& detections);

  /// Colour histograms of the pixels of each detection of the last `extract`, from the same frame.
  void histograms(const cv::Mat& frame, std::vector<ColorHistogram>& histograms);

 private:
  /// Sums over a blob's pixels.
  struct Sums {
    std::int64_t area = 0;
    std::int64_t x = 0, y = 0;
    std::int64_t xx = 0, xy = 0, yy = 0;
    std::int64_t blue = 0, green = 0, red = 0;
    int left = 0, top = 0, right = 0, bottom = 0;  ///< right and bottom: one beyond
    int detection = -1;                            ///< its index; -1: dropped
  };

  void merge(const cv::Mat& frame, const Expectation& expectation, double min_area_px);
  void drop_below(double area_px);
  void drop_unexpected(const Expectation& expectation, double min_area_px, const cv::Size& size);
  void drop_beyond_count();
  int number_blobs();
  void add_shapes(const std::vector<Run>& runs);
  void add_colors(const std::vector<Run>& runs, const cv::Mat& frame);
  void find_contours(const std::vector<Detection>& items, std::vector<std::vector<cv::Point>>& contours) const;
  static Detection detection_of(const Sums& sums);

  BlobOptions options_;
  RunLabeller labeller_;
  std::vector<Run> runs_;
  std::vector<BlobPart> parts_;  ///< by label
  FragmentMerger fragments_;
  CloseMerger close_;
  BlobSharer sharer_;
  std::vector<std::size_t> remaining_;
  std::vector<Sums> sums_;  ///< by label
  std::vector<ColorCounter> counters_;
};

}  // namespace survtrack
