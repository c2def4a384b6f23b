// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <array>
#include <utility>
#include <variant>

#include "survtrack/core/fields.hpp"
#include "survtrack/segmentation/horn_schunck_options.hpp"
#include "survtrack/segmentation/normalized_difference_options.hpp"
#include "survtrack/segmentation/static_reference_options.hpp"

namespace survtrack {

/// Where the averaging window of `moving_average` lies.
enum class Window {
  centred,  ///< N/2 frames before and after the frame: needs a look-ahead, for files
  causal,   ///< the last N frames: no delay, for live streams
};
constexpr auto enum_names(Window) {
  return std::array{std::pair{"centred", Window::centred}, std::pair{"causal", Window::causal}};
}

/// Average background and secondary background (Narayana 2007, 3.1 and 3.1.2), on grey levels.
struct MovingAverageOptions {
  static constexpr const char* model = "moving_average";
  static constexpr const char* meaning =
      "mean of a window of frames, and a secondary background against tails (Narayana 2007, 3.1)";

  Window window = Window::centred;
  int window_frames = 150;
  double threshold = 10.0;
  bool secondary_background = true;
  double secondary_threshold = 15.0;

  static constexpr auto fields() {
    using O = MovingAverageOptions;
    return std::make_tuple(
        field("window", &O::window, "", "centred on the frame (delays by half the window) or causal"),
        field("window_frames", &O::window_frames, "frames", "length N of the window (eq. 3.1)", between(1, 10000)),
        field("threshold", &O::threshold, "grey levels", "T1: foreground differs by more (eq. 3.2)", between(0, 255)),
        field("secondary_background", &O::secondary_background, "",
              "also compare with the level last seen as background (eq. 3.4)"),
        field("secondary_threshold", &O::secondary_threshold, "grey levels", "T2 of that comparison (eq. 3.4)",
              between(0, 255)));
  }
};

/// The default model: a running average that learns from background only, with a tolerance that follows each
/// pixel's own noise. A foreign colour that stays becomes background; shadows are not foreground.
struct SelectiveOptions {
  static constexpr const char* model = "selective";
  static constexpr const char* meaning = "selective running average with a tolerance of its own for each pixel";
  static constexpr bool reads_regions = true;  ///< parts of a frame can be read

  double threshold = 20.0;
  double noise_gain = 3.0;
  double update_time_s = 4.0;
  double absorb_time_s = 20.0;
  bool remove_shadows = true;
  double shadow_darkest = 0.7;
  double shadow_color_tolerance = 8.0;
  double scene_change_fraction = 0.6;

  static constexpr auto fields() {
    using O = SelectiveOptions;
    return std::make_tuple(
        field("threshold", &O::threshold, "grey levels",
              "smallest tolerance: foreground differs by more in some channel", between(0, 255)),
        field("noise_gain", &O::noise_gain, "", "tolerance in mean absolute deviations of the pixel", between(0, 16)),
        field("update_time_s", &O::update_time_s, "s", "time constant of background and deviation",
              above_up_to(0, 1e6)),
        field("absorb_time_s", &O::absorb_time_s, "s", "foreground of a steady colour becomes background after this",
              above_up_to(0, 60)),
        field("remove_shadows", &O::remove_shadows, "",
              "what is darker but of the background's colour is no foreground; colour frames only"),
        field("shadow_darkest", &O::shadow_darkest, "", "a shadow keeps at least this part of the brightness",
              between(0, 1)),
        field("shadow_color_tolerance", &O::shadow_color_tolerance, "grey levels",
              "a shadow's channels differ by no more from the darkened background", between(0, 255)),
        field("scene_change_fraction", &O::scene_change_fraction, "",
              "when more of the frame than this differs from the background, the scene changed and the background starts anew",
              above_up_to(0, 1)));
  }
};

/// OpenCV's adaptive Gaussian mixture (Zivkovic 2004), for comparison.
struct Mog2Options {
  static constexpr const char* model = "mog2";
  static constexpr const char* meaning = "OpenCV's Gaussian mixture MOG2, for comparison";

  int history_frames = 500;
  double variance_threshold = 16.0;
  bool detect_shadows = true;

  static constexpr auto fields() {
    using O = Mog2Options;
    return std::make_tuple(
        field("history_frames", &O::history_frames, "frames", "length of the history", between(1, 1e6)),
        field("variance_threshold", &O::variance_threshold, "", "squared Mahalanobis distance of background",
              above_up_to(0, 1e6)),
        field("detect_shadows", &O::detect_shadows, "", "shadows are found and not counted as foreground"));
  }
};

/// OpenCV's K nearest neighbours (Zivkovic and van der Heijden 2006), for comparison.
struct KnnOptions {
  static constexpr const char* model = "knn";
  static constexpr const char* meaning = "OpenCV's K nearest neighbours, for comparison";

  int history_frames = 500;
  double squared_distance_threshold = 400.0;
  bool detect_shadows = true;

  static constexpr auto fields() {
    using O = KnnOptions;
    return std::make_tuple(
        field("history_frames", &O::history_frames, "frames", "length of the history", between(1, 1e6)),
        field("squared_distance_threshold", &O::squared_distance_threshold, "grey levels^2",
              "a sample nearer than this is a neighbour", above_up_to(0, 1e6)),
        field("detect_shadows", &O::detect_shadows, "", "shadows are found and not counted as foreground"));
  }
};

using SegmenterOptions =
    std::variant<SelectiveOptions, MovingAverageOptions, HornSchunckOptions, Mog2Options, KnnOptions,
                 StaticReferenceOptions, NormalizedDifferenceOptions>;

}  // namespace survtrack
