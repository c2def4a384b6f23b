// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <array>
#include <utility>

#include "survtrack/core/fields.hpp"

namespace survtrack {

/// Where the background of `static_reference` comes from.
enum class ReferenceSource {
  mean,     ///< mean of the first frames
  median,   ///< median of the first frames: what moves through them leaves no trace
  picture,  ///< a picture that is given before the first frame
};
constexpr auto enum_names(ReferenceSource) {
  return std::array{std::pair{"mean", ReferenceSource::mean}, std::pair{"median", ReferenceSource::median},
                    std::pair{"picture", ReferenceSource::picture}};
}

/// A background that is taken once and does not change (Nashenda 2011, 3.1.3 and 4.3). While the first frames are
/// collected nothing is foreground; nothing is learned afterwards, unless the scene changes.
struct StaticReferenceOptions {
  static constexpr const char* model = "static_reference";
  static constexpr const char* meaning = "a background taken once: mean or median of the first frames, or a picture";
  static constexpr bool reads_regions = true;  ///< parts of a frame can be read

  ReferenceSource source = ReferenceSource::mean;
  int frames = 5;
  double threshold_blue = 37.0;
  double threshold_green = 37.0;
  double threshold_red = 37.0;
  double threshold_grey = 37.0;

  static constexpr auto fields() {
    using O = StaticReferenceOptions;
    return std::make_tuple(
        field("source", &O::source, "", "mean or median of the first frames, or a picture given before the first frame"),
        field("frames", &O::frames, "frames",
              "so many first frames are collected, with an empty mask; of a picture: after a change of the scene",
              between(1, 1000)),
        field("threshold_blue", &O::threshold_blue, "grey levels",
              "T: foreground differs by more in this channel or in another (eq. 2); colour frames", between(0, 255)),
        field("threshold_green", &O::threshold_green, "grey levels", "the same for green", between(0, 255)),
        field("threshold_red", &O::threshold_red, "grey levels", "the same for red", between(0, 255)),
        field("threshold_grey", &O::threshold_grey, "grey levels", "T of grey frames, for which the other three do not count",
              between(0, 255)));
  }
};

}  // namespace survtrack
