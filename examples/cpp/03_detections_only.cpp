// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

// The detector alone, with another background model: frames in, detections out, for any other tracker.

#include <iostream>
#include <survtrack/survtrack.hpp>

int main() {
  survtrack::Config config;
  config.set("segmenter.model=moving_average");
  config.set("segmenter.window=centred");  // looks ahead: detections come later, each with its own index
  config.set("segmenter.window_frames=20");
  survtrack::Detector detector(config);

  std::size_t found = 0;
  const auto show = [&](const survtrack::Detections& detections) {
    for (const survtrack::Detection& detection : detections.items) {
      ++found;
      std::cout << "frame " << detections.index << ": " << detection.area_px << " px at (" << detection.position.x
                << ", " << detection.position.y << ")\n";
    }
  };
  for (int k = 0; k < 50; ++k) {
    cv::Mat frame(120, 160, CV_8UC1, cv::Scalar(90));
    frame(cv::Rect(2 * k, 40, 20, 30)).setTo(200);
    if (const auto detections = detector.process(frame, k / 25.0)) show(*detections);
  }
  for (const survtrack::Detections& detections : detector.finish()) show(detections);
  return found > 0 ? 0 : 1;
}
