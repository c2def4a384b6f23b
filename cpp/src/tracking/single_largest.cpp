// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "tracking/single_largest.hpp"

#include <cstddef>

namespace survtrack {

void SingleLargest::update(TrackTable& table, const Detections& detections, const Matches&) {
  if (table.size() == 0) {
    start(table, detections);
  } else {
    go_on(table, detections);
  }
}

/// A frame without a measurement is predicted, as the text has it; the listing's `continue` leaves the state at zero there.
void SingleLargest::go_on(TrackTable& table, const Detections& detections) {
  const Track& track = table.row(0).track;
  const bool restarts = options_.restart_after_frames > 0;
  if (track.lost_frames == 0) {
    if (restarts && missed_ > options_.restart_after_frames) table.restart(0);
    table.set_status(0, TrackStatus::confirmed);
    table.set_reported(0, true);
  } else if (options_.lost_after_frames > 0 && track.lost_frames > options_.lost_after_frames) {
    table.set_status(0, TrackStatus::closed);
    table.set_reported(0, false);
  } else {
    table.set_status(0, TrackStatus::lost);
    // Where it would start anew, the prediction no longer says where it is; outside of the frame nobody sees it.
    const bool given_up = restarts && track.lost_frames > options_.restart_after_frames;
    table.set_reported(0, !given_up && !outside_frame(track.box, detections));
  }
  missed_ = track.lost_frames;
}

void SingleLargest::start(TrackTable& table, const Detections& detections) {
  missed_ = 0;
  int largest = -1;
  double area_px = 0.0;
  for (std::size_t d = 0; d < detections.items.size(); ++d) {
    const Detection& seen = detections.items[d];
    if (!table.accepts(seen) || (largest >= 0 && !(seen.area_px > area_px))) continue;
    largest = static_cast<int>(d);
    area_px = seen.area_px;
  }
  if (largest < 0) return;
  const int i = table.start(largest, detections);
  table.believe(i);
  table.set_reported(i, true);
}

}  // namespace survtrack
