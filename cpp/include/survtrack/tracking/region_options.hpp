// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <array>
#include <utility>
#include <variant>

#include "survtrack/core/fields.hpp"

namespace survtrack {

/// Every frame is read whole.
struct NoRegionsOptions {
  static constexpr const char* model = "none";
  static constexpr const char* meaning = "every frame is read whole";
  static constexpr auto fields() { return std::make_tuple(); }
};

/// Where newcomers are looked for.
enum class Acquisition {
  border,  ///< in a band along the frame's border
  zones,   ///< in the zones given to load_zones()
  strip,   ///< nowhere else but in the strip that is refreshed
};
constexpr auto enum_names(Acquisition) {
  return std::array{std::pair{"border", Acquisition::border}, std::pair{"zones", Acquisition::zones},
                    std::pair{"strip", Acquisition::strip}};
}

/// Only the parts of a frame are read where a track is expected or a newcomer may appear (O'Malley 2000).
struct PredictedRegionsOptions {
  static constexpr const char* model = "predicted";
  static constexpr const char* meaning = "only where tracks are expected, and newcomers (O'Malley 2000)";

  double sigmas_along = 3.0;
  double sigmas_across = 3.0;
  bool forward_only = false;
  bool whole_object = true;
  double margin = 0.2;
  double growth = 1.5;
  Acquisition acquisition = Acquisition::strip;
  double border = 0.05;
  int refresh_frames = 10;
  double whole_above = 0.9;

  static constexpr auto fields() {
    using O = PredictedRegionsOptions;
    return std::make_tuple(
        field("sigmas_along", &O::sigmas_along, "standard deviations",
              "reach of a region beyond the predicted position, along the way of the track", between(0, 100)),
        field("sigmas_across", &O::sigmas_across, "standard deviations", "the same across it, to both sides", between(0, 100)),
        field("forward_only", &O::forward_only, "",
              "along its way a region begins where the track was, not before the prediction (O'Malley 2000)"),
        field("whole_object", &O::whole_object, "",
              "a region holds the whole box wherever in it the position is; if not, each side is the box's longer one at least "
              "(O'Malley 2000)"),
        field("margin", &O::margin, "longer sides of the box", "added on every side", between(0, 100)),
        field("growth", &O::growth, "longer sides of the box/s", "added on every side for each second that a track is lost",
              between(0, 100)),
        field("acquisition", &O::acquisition, "", "where newcomers are looked for"),
        field("border", &O::border, "frame heights", "width of the band along the border, with acquisition border",
              above_up_to(0, 1)),
        field("refresh_frames", &O::refresh_frames, "frames",
              "a strip a frame is read in turn, so that each place is seen once in so many; 0: none is",
              between(0, 100000)),
        field("whole_above", &O::whole_above, "",
              "a frame is read whole where its regions would cost more than this part of what the whole frame costs: a pixel "
              "each, and 64 more for every piece of a row, as selective takes",
              between(0, 100)));
  }
};

using RegionOptions = std::variant<NoRegionsOptions, PredictedRegionsOptions>;

}  // namespace survtrack
