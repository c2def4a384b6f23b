// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0
// Follows a bright square that crosses a grey scene; prints the library's version, the reported
// track's id and where it was last seen.
#include <iostream>

#include <survtrack/core/version.hpp>
#include <survtrack/pipeline/pipeline.hpp>

int main() {
  constexpr int width = 160, height = 120, side = 16, frames = 90;
  const cv::Mat scene(height, width, CV_8UC3, cv::Scalar::all(90));
  survtrack::Pipeline pipeline = survtrack::Pipeline::from_preset("survtrack");

  survtrack::FrameResult result;
  std::int64_t id = 0;
  survtrack::Point position;
  for (int k = 0; k < frames; ++k) {
    cv::Mat frame = scene.clone();
    if (k >= 40) frame(cv::Rect(2 * (k - 40), 50, side, side)).setTo(cv::Scalar::all(220));
    if (!pipeline.process(frame, k / 10.0, result)) continue;
    for (const survtrack::Track& track : result.tracks) {
      if (!track.reported) continue;
      id = track.id;
      position = track.position;
    }
  }
  std::cout << survtrack::version() << ' ' << id << ' ' << position.x << ' ' << position.y << '\n';
}
