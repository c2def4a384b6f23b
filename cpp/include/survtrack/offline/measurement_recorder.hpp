// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "survtrack/filtering/measured_track.hpp"
#include "survtrack/pipeline/config.hpp"
#include "survtrack/pipeline/frame_result.hpp"

namespace survtrack {

/// Collects what was measured of the confirmed tracks of a run, frame by frame, as the config's measurement model sees it:
/// for the identification of its noises. Leaves out what says little about an object's place: blobs that several tracks
/// share, and detections that the frame's border cuts.
class MeasurementRecorder {
 public:
  /// After a longer gap a track goes on as another one. Throws `InputError` for a gap that is not above 0.
  explicit MeasurementRecorder(const Config& config, double max_gap_s = 1.0);

  /// Takes one frame; frames come in order. `detections` are those that the result's tracks point to.
  void add(const TrackingResult& result, const Detections& detections);
  void add(const FrameResult& result) { add(result, result.detections); }

  /// Times are in the config's time units, lengths the sizes of the tracks' boxes before the measurement. Those of at
  /// least `least` measurements.
  std::vector<MeasuredTrack> tracks(int least = 2) const;

  std::int64_t used() const { return used_; }            ///< measurements taken
  std::int64_t shared() const { return shared_; }        ///< left out: blobs of several tracks
  std::int64_t at_border() const { return at_border_; }  ///< left out: cut by the border

 private:
  struct Going {
    std::size_t track;      ///< in tracks_
    double last_time_s;     ///< of its last measurement
    double size_px;         ///< after the last frame
  };

  MeasurementOptions measurement_;
  double time_unit_s_;
  double max_gap_s_;
  std::vector<MeasuredTrack> tracks_;
  std::unordered_map<std::int64_t, Going> going_;  ///< by id
  std::int64_t used_ = 0, shared_ = 0, at_border_ = 0;
};

}  // namespace survtrack
