// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "survtrack/pipeline/tracker.hpp"

namespace survtrack {

/// Detections of boxes alone, as of a user's own detector.
inline Detections detections_of(const std::vector<Box>& boxes, double time_s, std::int64_t index, int frame_width = 0,
                                int frame_height = 0) {
  Detections detections;
  detections.index = index;
  detections.time_s = time_s;
  detections.frame_width = frame_width;
  detections.frame_height = frame_height;
  for (const Box& box : boxes) {
    Detection detection;
    detection.box = box;
    detection.position = box.center();
    detection.area_px = box.area_px();
    detections.items.push_back(detection);
  }
  return detections;
}

/// A tracker fed with boxes, one frame after the other at a steady rate.
class BoxRun {
 public:
  explicit BoxRun(const Config& config, double frame_period_s = 0.1, int frame_width = 0, int frame_height = 0)
      : tracker_(config), period_s_(frame_period_s), width_(frame_width), height_(frame_height) {}

  const TrackingResult& frame(const std::vector<Box>& boxes) {
    return see(detections_of(boxes, 0.0, 0).items);
  }
  /// The same for detections that have more than a box.
  const TrackingResult& see(const std::vector<Detection>& items) {
    const auto index = next_++;
    Detections detections = detections_of({}, period_s_ * static_cast<double>(index), index, width_, height_);
    detections.items = items;
    result_ = tracker_.process(detections);
    return result_;
  }
  /// Frames that never came.
  void skip(int frames = 1) { next_ += frames; }
  const TrackingResult& result() const { return result_; }
  Tracker& tracker() { return tracker_; }

 private:
  Tracker tracker_;
  double period_s_;
  int width_;
  int height_;
  std::int64_t next_ = 0;
  TrackingResult result_;
};

/// Events of a frame as "track_started 1, track_lost 2".
inline std::string events_of(const TrackingResult& result) {
  std::string text;
  for (const Event& event : result.events) {
    text += (text.empty() ? "" : ", ") + std::string(to_string(event.kind)) + " " + std::to_string(event.track_id);
  }
  return text;
}

inline std::vector<std::int64_t> ids_of(const TrackingResult& result) {
  std::vector<std::int64_t> ids;
  for (const Track& track : result.tracks) ids.push_back(track.id);
  return ids;
}

}  // namespace survtrack
