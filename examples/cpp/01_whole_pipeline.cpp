// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

// The whole pipeline: frames in, tracks and events out. A grey square crosses a still scene.

#include <iostream>
#include <survtrack/survtrack.hpp>

namespace {

cv::Mat frame_at(int k) {
  cv::Mat frame(120, 160, CV_8UC3, cv::Scalar(90, 100, 110));
  if (k >= 25) frame(cv::Rect(4 * (k - 25), 50, 16, 30)).setTo(cv::Scalar(200, 60, 40));
  return frame;
}

}  // namespace

int main() {
  survtrack::Pipeline pipeline;  // the default preset
  survtrack::FrameResult result;  // its memory is used again for each frame
  int reported = 0;
  for (int k = 0; k < 60; ++k) {
    const double time_s = k / 25.0;
    if (!pipeline.process(frame_at(k), time_s, result)) continue;  // never: this preset has no delay
    for (const survtrack::Event& event : result.events) std::cout << event.time_s << " s: " << event.text << '\n';
    for (const survtrack::Track& track : result.tracks) {
      if (!track.reported) continue;
      ++reported;
      std::cout << "frame " << result.index << ": track " << track.id << " at (" << track.position.x << ", "
                << track.position.y << ") px, " << track.velocity_px_per_s.x << " px/s\n";
    }
  }
  return reported > 0 ? 0 : 1;
}
