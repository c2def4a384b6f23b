// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <array>
#include <utility>

#include "survtrack/core/fields.hpp"

namespace survtrack {

/// What `normalized_difference` compares a frame with: r of Nashenda 2011, eq. 1 and 3.
enum class DifferenceReference {
  running,   ///< a running average of all frames before
  previous,  ///< a frame some frames back
};
constexpr auto enum_names(DifferenceReference) {
  return std::array{std::pair{"running", DifferenceReference::running},
                    std::pair{"previous", DifferenceReference::previous}};
}

/// Locally normalised difference over a Gaussian pyramid (Nashenda 2011, 3.1.3, eq. 3, after Irani, Rousso and
/// Peleg 1994), on grey levels. It estimates how far edges moved, so that strong and weak edges count alike.
struct NormalizedDifferenceOptions {
  static constexpr const char* model = "normalized_difference";
  static constexpr const char* meaning =
      "difference divided by the local gradient, over a pyramid (Nashenda 2011, eq. 3)";

  DifferenceReference reference = DifferenceReference::running;
  int frames_back = 1;
  double update_time_s = 20.0;
  int levels = 2;
  int neighbourhood_px = 3;
  double constant = 400.0;
  double high = 2.0;
  double threshold = 2.0;

  static constexpr auto fields() {
    using O = NormalizedDifferenceOptions;
    return std::make_tuple(
        field("reference", &O::reference, "", "a running average of the frames before, or one frame some frames back"),
        field("frames_back", &O::frames_back, "frames", "how far back that one is; the first frames have an empty mask",
              between(1, 1000)),
        field("update_time_s", &O::update_time_s, "s", "time constant of the running average", above_up_to(0, 1e6)),
        field("levels", &O::levels, "", "levels of the pyramid, the frame itself included; each halves the one before, down to sides of 8 px",
              between(1, 10)),
        field("neighbourhood_px", &O::neighbourhood_px, "px", "side of the square N over which is summed; 0 and 1: the pixel alone",
              odd_up_to(31)),
        field("constant", &O::constant, "grey levels^2/px^2", "c, which keeps flat places from dividing by zero: the sum of squared gradients that counts half",
              above_up_to(0, 1e9)),
        field("high", &O::high, "px", "a level's value above this is high and replaces that of the coarser level",
              between(0, 1e6)),
        field("threshold", &O::threshold, "px", "foreground has a greater value on the finest level", between(0, 1e6)));
  }
};

}  // namespace survtrack
