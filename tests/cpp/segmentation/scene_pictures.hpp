// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

namespace survtrack {

/// A colourful scene without edges, another for each seed.
inline cv::Mat colorful_scene(std::uint64_t seed, const cv::Size& size = {96, 72}) {
  cv::Mat coarse(6, 8, CV_8UC3);
  cv::RNG random(seed);
  random.fill(coarse, cv::RNG::UNIFORM, 30, 220);
  cv::Mat scene;
  cv::resize(coarse, scene, size, 0, 0, cv::INTER_LINEAR);
  return scene;
}

/// The same with all levels multiplied.
inline cv::Mat lit(const cv::Mat& scene, double gain) {
  cv::Mat picture;
  scene.convertTo(picture, -1, gain);
  return picture;
}

/// The same without colour, as an infrared camera shows it, still BGR.
inline cv::Mat without_color(const cv::Mat& scene) {
  cv::Mat grey;
  cv::cvtColor(scene, grey, cv::COLOR_BGR2GRAY);
  cv::cvtColor(grey, grey, cv::COLOR_GRAY2BGR);
  return grey;
}

/// The same with noise of a few levels, another for each frame.
inline cv::Mat noisy(const cv::Mat& scene, int frame) {
  cv::Mat noise(scene.size(), scene.type());
  cv::RNG random(static_cast<std::uint64_t>(100 + frame));
  random.fill(noise, cv::RNG::UNIFORM, 0, 5);
  return scene + noise;
}

}  // namespace survtrack
