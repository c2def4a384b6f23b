// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

// What the detector reads of a frame.

#include <algorithm>
#include <opencv2/core.hpp>

#include "segmentation/pixel_rect.hpp"
#include "survtrack/pipeline/detector.hpp"

namespace survtrack {
namespace {

/// Of the strip that is read in turn, a larger part than this is foreground when the light or the camera changed.
constexpr double flood = 0.6;

}  // namespace

/// Reads the frame, whole or in regions.
void Detector::segment(const TimedFrame& frame, const Expectation& expectation, Detections& detections) {
  plan(frame.image.size(), frame.time_s, expectation, detections.regions);
  detections.pixels_read = plan_.pixels();
  if (plan_.whole()) {
    segmenter_->segment(frame.image, expectation, detections.mask, detections.events);
  } else {
    segmenter_->segment_regions(frame.image, expectation, plan_, detections.mask, detections.events);
  }
  // The strip says something of the scene; a region that its object fills does not.
  const bool flooded = !strip_rows_.empty() && cv::countNonZero(detections.mask.rowRange(strip_rows_)) >
                                                   flood * strip_rows_.size() * frame.image.cols;
  look_at_all_ = !plan_.whole() && flooded && !flooded_;
  flooded_ = flooded;
}

/// Turns what is expected, and the strip whose turn it is, into `plan_`, and into the list of regions read.
void Detector::plan(const cv::Size& size, double time_s, const Expectation& expectation, std::vector<Region>& regions) {
  regions.clear();
  strip_rows_ = {};
  plan_.clear(size);
  const bool whole = !expectation.only_regions || segmenter_->needs_whole_frame() || look_at_all_;
  // A whole frame has its acquisition regions, too: newcomers start there only.
  if (expectation.only_regions) regions = expectation.regions;
  if (!whole) {
    for (const Region& region : regions) plan_.add(pixel_rect(region.box, size));
    if (regions_ && regions_->refresh_frames > 0) add_strip(size, time_s, regions);
    plan_.finish();
  }
  // Regions of the caller's own are read as they are asked for.
  const bool dear = regions_ && static_cast<double>(plan_.cost_px()) >
                                    regions_->whole_above * static_cast<double>(ReadPlan::whole_cost_px(size));
  if (!whole && !dear && !plan_.whole()) return;
  plan_.read_whole(size);
  if (!strip_rows_.empty()) regions.pop_back();  // the strip is no more
  strip_rows_ = {};
  regions.push_back({{0.0, 0.0, static_cast<double>(size.width), static_cast<double>(size.height)}, RegionKind::whole_frame, 0});
  // The first frame is one of these.
  if (regions_) strip_read_s_.assign(static_cast<std::size_t>(std::min(regions_->refresh_frames, size.height)), time_s);
  strip_ = 0;
}

void Detector::add_strip(const cv::Size& size, double time_s, std::vector<Region>& regions) {
  const auto count = static_cast<std::int64_t>(strip_read_s_.size());
  const auto strip = static_cast<std::int64_t>(strip_);
  const auto edge = [&](std::int64_t i) { return static_cast<int>(i * size.height / count); };
  const int top = edge(strip), bottom = edge(strip + 1);
  plan_.refresh(top, bottom, time_s - strip_read_s_[strip_]);
  strip_rows_ = {top, bottom};
  regions.push_back({{0.0, static_cast<double>(top), static_cast<double>(size.width), static_cast<double>(bottom - top)},
                     RegionKind::refresh, 0});
  strip_read_s_[strip_] = time_s;
  strip_ = (strip_ + 1) % strip_read_s_.size();
}

}  // namespace survtrack
