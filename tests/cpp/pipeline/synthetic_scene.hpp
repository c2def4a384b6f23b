// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cmath>
#include <cstdint>
#include <opencv2/core.hpp>
#include <random>

#include "survtrack/pipeline/config.hpp"

namespace survtrack {

/// A textured wall under noise, before which a bright square enters and moves to the right. Made by hand from
/// times, so that frame rates and missing frames can be tried; the same time gives the same frame.
struct SyntheticScene {
  int width = 160;
  int height = 120;
  double enters_s = 1.0;          ///< empty before, so that the background is known
  double speed_px_per_s = 30.0;
  int side_px = 20;
  int noise = 2;                  ///< grey levels, both ways
  int channels = 3;

  Box square(double time_s) const {
    const double x = std::round(10.0 + speed_px_per_s * (time_s - enters_s));
    return {x, 50.0, static_cast<double>(side_px), static_cast<double>(side_px)};
  }

  bool present(double time_s) const { return time_s >= enters_s; }

  cv::Mat frame(double time_s) const {
    cv::Mat image(height, width, CV_8UC(channels));
    std::minstd_rand wall(5);
    std::minstd_rand grain(static_cast<std::uint32_t>(1000.0 * time_s) + 17U);
    for (int y = 0; y < height; ++y) {
      auto* const row = image.ptr<std::uint8_t>(y);
      for (int i = 0; i < width * channels; ++i) {
        const int level = 80 + static_cast<int>(wall() % 40);
        row[i] = static_cast<std::uint8_t>(level + static_cast<int>(grain() % static_cast<unsigned>(2 * noise + 1)) - noise);
      }
    }
    if (!present(time_s)) return image;
    const Box box = square(time_s);
    const cv::Rect place(static_cast<int>(box.x), static_cast<int>(box.y), side_px, side_px);
    const cv::Rect seen = place & cv::Rect(0, 0, width, height);
    if (!seen.empty()) image(seen).setTo(channels == 1 ? cv::Scalar(230) : cv::Scalar(60, 220, 240));
    return image;
  }
};

/// A config whose numbers all stand here: tests do not depend on the defaults.
inline Config scene_config() {
  Config config;
  config.time_unit_s = 1.0;
  config.segmenter = SelectiveOptions{.threshold = 20.0,
                                      .noise_gain = 3.0,
                                      .update_time_s = 4.0,
                                      .absorb_time_s = 20.0,
                                      .remove_shadows = false,
                                      .scene_change_fraction = 0.6};
  config.cleanup = {.median_px = 3, .open_px = 0, .close_px = 0};
  config.blobs = {.min_area_px = 30.0,
                  .min_area_fraction = 0.0,
                  .merge = FragmentMergeOptions{.min_fragment_fraction = 0.0, .gap = 0.2},
                  .share_blobs = true,
                  .share_cover = 0.5,
                  .share_lost_s = 1.0,
                  .min_relative_height = 0.4};
  config.filter = KalmanCvOptions{.noise_unit = NoiseUnit::object_size,
                                  .velocity_noise = 0.3,
                                  .position_noise = 0.05,
                                  .initial_velocity = 1.0,
                                  .lost_damping_time = 2.0};
  config.measurement = BoxCenterOptions{.size_time_s = 0.5};
  config.cost = GaussianCostOptions{.gate = 16.0};
  config.assignment = HungarianOptions{.confirmed_first = true};
  config.lifecycle = ConfirmAndLoseOptions{.confirm_matches = 3,
                                           .confirm_s = 0.25,
                                           .confirm_travel = 0.2,
                                           .report_lost_s = 0.5,
                                           .max_lost_s = 2.0,
                                           .birth_overlap = 0.5};
  return config;
}

/// The same with an average background over a centred window, whose results come `window_frames` / 2 late.
inline Config delayed_config(int window_frames) {
  Config config = scene_config();
  config.segmenter = MovingAverageOptions{.window = Window::centred,
                                          .window_frames = window_frames,
                                          .threshold = 15.0,
                                          .secondary_background = true,
                                          .secondary_threshold = 20.0};
  return config;
}

}  // namespace survtrack
