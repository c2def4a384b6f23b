// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <array>
#include <utility>

#include "survtrack/core/fields.hpp"

namespace survtrack {

/// How the brightness is derived in Horn and Schunck's optical flow.
enum class Derivatives {
  hs1981,  ///< means over the cube of 2 x 2 pixels x 2 frames of which the pixel is the top left, as published
  sobel,   ///< Sobel's kernels on the mean of both frames, the difference of the frames at the pixel
};
constexpr auto enum_names(Derivatives) {
  return std::array{std::pair{"hs1981", Derivatives::hs1981}, std::pair{"sobel", Derivatives::sobel}};
}

// Below the least, squares of grey levels are lost in the rounding of floats.
constexpr Bounds smoothness_bounds = between(1e-4, 1e3);
constexpr Bounds sweeps_bounds = between(1, 1e5);
constexpr Bounds tolerance_bounds = between(0, 1e6);

/// What moves between a frame and the one some frames before: optical flow of Horn and Schunck 1981. Nothing is
/// learned and there is no background picture; in the first `frames_back` frames nothing is foreground.
struct HornSchunckOptions {
  static constexpr const char* model = "horn_schunck";
  static constexpr const char* meaning = "optical flow (Horn and Schunck 1981): what moved since some frames before";

  int frames_back = 10;
  double smoothness = 0.5;
  int sweeps = 10;
  double tolerance = 0.0;
  Derivatives derivatives = Derivatives::hs1981;
  double magnitude_threshold = 0.03;

  static constexpr auto fields() {
    using O = HornSchunckOptions;
    return std::make_tuple(
        field("frames_back", &O::frames_back, "frames",
              "N: the flow is that since the N-th frame before; the first N frames have none and an empty mask",
              between(1, 1000)),
        field("smoothness", &O::smoothness, "", "a: weight of a smooth field, for grey levels in 0 to 1",
              smoothness_bounds),
        field("sweeps", &O::sweeps, "", "iterations, at most", sweeps_bounds),
        field("tolerance", &O::tolerance, "px", "no more sweeps when one changes nothing by as much; 0: never",
              tolerance_bounds),
        field("derivatives", &O::derivatives, "", "cubes of 2 x 2 x 2 as published, or Sobel's kernels"),
        field("magnitude_threshold", &O::magnitude_threshold, "px", "foreground moves by more between the two frames",
              between(0, 1e6)));
  }
};

}  // namespace survtrack
