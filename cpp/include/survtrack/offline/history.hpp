// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "survtrack/core/geometry.hpp"
#include "survtrack/tracking/tracking_result.hpp"

namespace survtrack {

/// Where a track was in one frame.
struct TrackPoint {
  std::int64_t index = 0;  ///< the frame's index in its source, from 0
  double time_s = 0.0;
  Box box;                 ///< px
  Point position;          ///< px
  Point velocity_px_per_s;
  Color mean_color;        ///< of the detection last matched; zero when there was no image
};

/// One track of a run that is over.
struct RecordedTrack {
  std::int64_t id = 0;
  std::vector<TrackPoint> points;  ///< by frame; at least one, not every frame has one
};

/// All tracks of a run that is over, in any order.
struct History {
  std::vector<RecordedTrack> tracks;
};

/// Refuses, in an `InputError` that names track and frame: an id below 0 or given twice, a track without points,
/// frames that do not increase or are below 0, what is not finite or far out of an image (1e9 px), sizes below
/// 0.001 px, colours outside 0 to 255, times that do not increase with the frames or differ within one frame.
void check_history(const History& history);

/// Collects the reported tracks of a run, frame by frame.
class HistoryRecorder {
 public:
  /// Frames come in order.
  void add(const TrackingResult& result);
  const History& history() const { return history_; }

 private:
  History history_;
  std::unordered_map<std::int64_t, std::size_t> row_of_id_;
};

}  // namespace survtrack
