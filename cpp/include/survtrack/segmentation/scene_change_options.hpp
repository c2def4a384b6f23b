// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <array>
#include <utility>
#include <variant>

#include "survtrack/core/fields.hpp"

namespace survtrack {

/// Part of the samples of which some channel differs.
struct ChangedPixelsOptions {
  static constexpr const char* model = "changed_pixels";
  static constexpr const char* meaning = "part of the samples that differ in some channel";

  double difference = 25.0;
  double threshold = 0.45;

  static constexpr auto fields() {
    using O = ChangedPixelsOptions;
    return std::make_tuple(
        field("difference", &O::difference, "grey levels", "a sample changed when some channel differs by more", between(0, 255)),
        field("threshold", &O::threshold, "", "the scene changed when more of the samples did", between(0, 1)));
  }
};

/// Part of the blocks whose mean or standard deviation differs.
struct BlocksOptions {
  static constexpr const char* model = "blocks";
  static constexpr const char* meaning = "part of the blocks whose mean or variance differs";

  int blocks_a_side = 8;
  double mean_difference = 15.0;
  double deviation_difference = 15.0;
  double threshold = 0.6;

  static constexpr auto fields() {
    using O = BlocksOptions;
    return std::make_tuple(
        field("blocks_a_side", &O::blocks_a_side, "", "the frame is cut into this many columns and rows of blocks", between(1, 64)),
        field("mean_difference", &O::mean_difference, "grey levels", "a block changed when its mean differs by more", between(0, 255)),
        field("deviation_difference", &O::deviation_difference, "grey levels",
              "or when its standard deviation, the root of its variance, does", between(0, 255)),
        field("threshold", &O::threshold, "", "the scene changed when more of the blocks did", between(0, 1)));
  }
};

/// What two colour histograms do not have in common (Swain and Ballard 1991).
struct HistogramOptions {
  static constexpr const char* model = "histogram";
  static constexpr const char* meaning = "1 less the intersection of the colour histograms (Swain and Ballard 1991)";

  int bins = 8;
  double threshold = 0.45;

  static constexpr auto fields() {
    using O = HistogramOptions;
    return std::make_tuple(
        field("bins", &O::bins, "", "bins of each channel; all their combinations are counted", between(2, 32)),
        field("threshold", &O::threshold, "", "the scene changed when the histograms have less than 1 less this in common",
              between(0, 1)));
  }
};

/// Distance of two distributions of grey levels (Kolmogorov and Smirnov).
struct KolmogorovSmirnovOptions {
  static constexpr const char* model = "kolmogorov_smirnov";
  static constexpr const char* meaning = "greatest difference of the cumulative distributions of grey levels";

  double threshold = 0.3;

  static constexpr auto fields() {
    using O = KolmogorovSmirnovOptions;
    return std::make_tuple(field("threshold", &O::threshold, "", "the scene changed when the distributions differ by more", between(0, 1)));
  }
};

using SceneMeasureOptions = std::variant<ChangedPixelsOptions, BlocksOptions, HistogramOptions, KolmogorovSmirnovOptions>;

/// What is done when the scene changed.
enum class SceneAction {
  restart,  ///< the background starts anew from this frame, whose mask is empty
  relearn,  ///< the same, and masks stay empty while it learns
  report,   ///< the event alone
};
constexpr auto enum_names(SceneAction) {
  return std::array{std::pair{"restart", SceneAction::restart}, std::pair{"relearn", SceneAction::relearn},
                    std::pair{"report", SceneAction::report}};
}

/// Nothing watches the scene as a whole.
struct NoSceneChangeOptions {
  static constexpr const char* model = "none";
  static constexpr const char* meaning = "nothing watches the scene as a whole; a background model may do so itself";
  static constexpr auto fields() { return std::make_tuple(); }
};

/// Watches for cuts, lamps, infrared, black frames and slow changes of light, on samples of the frame.
struct GuardOptions {
  static constexpr const char* model = "guard";
  static constexpr const char* meaning = "watches for cuts, lamps, infrared, black frames and gradual changes";

  SceneAction action = SceneAction::restart;
  SceneMeasureOptions measure = ChangedPixelsOptions{};
  int frames_back = 5;
  double memory_s = 300.0;
  int samples = 2048;
  int low_pass_px = 3;
  double relearn_s = 2.0;
  double same_scene_correlation = 0.55;
  double color_level = 6.0;
  double color_part = 0.25;
  int black_level = 24;
  double black_part = 0.95;

  static constexpr auto fields() {
    using O = GuardOptions;
    return std::make_tuple(
        field("action", &O::action, "", "the background starts anew; the same with empty masks while it learns; or only the event"),
        field("measure", &O::measure, "", "how two pictures of the scene are compared"),
        field("frames_back", &O::frames_back, "frames", "a change within this many frames is a cut or a lamp, a slower one is gradual",
              between(1, 1000)),
        field("memory_s", &O::memory_s, "s", "time constant of the long-term reference, a mean of what was seen",
              above_up_to(0, 1e9)),
        field("samples", &O::samples, "", "pixels of the frame that are looked at, at most, on a grid", between(16, 1e6)),
        field("low_pass_px", &O::low_pass_px, "px", "side of the square whose mean is a sample; 0 and 1: the pixel alone", odd_up_to(31)),
        field("relearn_s", &O::relearn_s, "s", "how long masks stay empty with action relearn", between(0, 3600)),
        field("same_scene_correlation", &O::same_scene_correlation, "", "a sudden change that leaves at least this correlation of grey levels is one of brightness, else a cut",
              between(-1, 1)),
        field("color_level", &O::color_level, "grey levels", "colour can be lost, or come back, when the mean of largest less smallest channel is this large with it",
              above_up_to(0, 255)),
        field("color_part", &O::color_part, "", "colour is lost when less than this part of it is left", between(0, 1)),
        field("black_level", &O::black_level, "grey levels", "a sample is black when no channel is above this", between(0, 255)),
        field("black_part", &O::black_part, "", "a frame is black when at least this part of its samples is, and the reference is not",
              above_up_to(0, 1)));
  }
};

using SceneChangeOptions = std::variant<NoSceneChangeOptions, GuardOptions>;

}  // namespace survtrack
