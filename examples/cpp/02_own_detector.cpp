// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

// The tracker alone, on the boxes of your own detector: two objects that pass each other.

#include <iostream>
#include <survtrack/survtrack.hpp>

int main() {
  survtrack::Config config = survtrack::preset("survtrack");
  config.set("lifecycle.confirm_travel=0");  // believe also what stands still
  survtrack::Tracker tracker(config);

  std::size_t tracks = 0;
  for (int k = 0; k < 40; ++k) {
    survtrack::Detections detections;
    detections.index = k;
    detections.time_s = k / 10.0;
    for (const survtrack::Box& box : {survtrack::Box{5.0 * k, 40, 20, 50}, survtrack::Box{200.0 - 5.0 * k, 120, 20, 50}}) {
      detections.items.push_back(survtrack::detection_of_box(box));
    }
    const survtrack::TrackingResult result = tracker.process(detections);
    tracks = result.tracks.size();
    for (const survtrack::Track& track : result.tracks) {
      std::cout << result.time_s << " s: track " << track.id << " has detection " << track.detection << '\n';
    }
  }
  return tracks == 2 ? 0 : 1;
}
