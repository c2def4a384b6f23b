// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "survtrack/offline/measurement_recorder.hpp"

#include <cmath>
#include <string>

#include "core/text_of.hpp"
#include "survtrack/core/errors.hpp"
#include "survtrack/tracking/measurement.hpp"

namespace survtrack {

MeasurementRecorder::MeasurementRecorder(const Config& config, double max_gap_s)
    : measurement_(config.check().measurement), time_unit_s_(config.time_unit_s), max_gap_s_(max_gap_s) {
  if (max_gap_s > 0.0 && std::isfinite(max_gap_s)) return;
  throw InputError("max_gap_s: " + text_of(max_gap_s) + " is not allowed; expected a number above 0");
}

void MeasurementRecorder::add(const TrackingResult& result, const Detections& detections) {
  const bool has_border = detections.frame_width > 0 && detections.frame_height > 0;
  for (const Track& track : result.tracks) {
    const double size_px = std::sqrt(track.box.area_px());
    const auto known = going_.find(track.id);
    const double size_before_px = known == going_.end() ? size_px : known->second.size_px;
    if (known != going_.end()) known->second.size_px = size_px;
    if (track.status != TrackStatus::confirmed || track.detection < 0) continue;
    if (static_cast<std::size_t>(track.detection) >= detections.items.size()) {
      throw InputError("detections: there are " + std::to_string(detections.items.size()) + ", and track " +
                       std::to_string(track.id) + " was matched to number " + std::to_string(track.detection) +
                       "; expected those of the same frame");
    }
    const Detection& seen = detections.items[static_cast<std::size_t>(track.detection)];
    if (seen.shared || track.group != 0) {
      ++shared_;
      continue;
    }
    if (has_border && touches_border(seen.box, detections.frame_width, detections.frame_height)) {
      ++at_border_;
      continue;
    }
    const bool goes_on = known != going_.end() && result.time_s - known->second.last_time_s <= max_gap_s_;
    if (!goes_on) {
      going_[track.id] = {tracks_.size(), result.time_s, size_px};
      tracks_.emplace_back();
    }
    Going& going = going_[track.id];
    going.last_time_s = result.time_s;
    MeasuredTrack& measured = tracks_[going.track];
    measured.times.push_back(result.time_s / time_unit_s_);
    measured.positions.push_back(measured_position(measurement_, seen));
    measured.lengths.push_back(size_before_px);
    ++used_;
  }
}

std::vector<MeasuredTrack> MeasurementRecorder::tracks(int least) const {
  std::vector<MeasuredTrack> found;
  for (const MeasuredTrack& track : tracks_) {
    if (static_cast<int>(track.times.size()) >= least) found.push_back(track);
  }
  return found;
}

}  // namespace survtrack
