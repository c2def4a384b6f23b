// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <variant>

#include "survtrack/core/fields.hpp"

namespace survtrack {

/// Of tracks that merge into one blob one has it, the others are lost.
struct NoGroupsOptions {
  static constexpr const char* model = "none";
  static constexpr const char* meaning = "of tracks that merge into one blob one has it, the others are lost";
  static constexpr auto fields() { return std::make_tuple(); }
};

/// Tracks that merge into one blob are a group: all of them stay, somewhere in the blob, until it divides.
struct SharedBlobOptions {
  static constexpr const char* model = "shared_blob";
  static constexpr const char* meaning = "tracks that merge into one blob are a group until it divides";

  double min_cover = 0.5;
  double join_s = 0.2;
  double max_s = 10.0;
  double color_deviation = 0.1;

  static constexpr auto fields() {
    using O = SharedBlobOptions;
    return std::make_tuple(
        field("min_cover", &O::min_cover, "",
              "a track without a detection joins the one in whose detection more than this part of its predicted box lies",
              between(0, 1)),
        field("join_s", &O::join_s, "s", "only a track that was seen so shortly before, or in the frame before, joins", between(0, 1e6)),
        field("max_s", &O::max_s, "s", "a track that is not seen by itself for longer is lost", between(0, 1e6)),
        field("color_deviation", &O::color_deviation, "",
              "when the blob divides: standard deviation of a track's mean colour, of 0 to 1.73 (Narayana 2007, eq. 3.6); "
              "0: colour does not count",
              between(0, 1e6)));
  }
};

using GroupOptions = std::variant<NoGroupsOptions, SharedBlobOptions>;

/// Who comes back is someone new.
struct NoReentryOptions {
  static constexpr const char* model = "none";
  static constexpr const char* meaning = "who comes back is someone new";
  static constexpr auto fields() { return std::make_tuple(); }
};

/// A track that ended can go on where it ended, some time after: who looks the same there gets its identity. Of the
/// weights w = exp(-(d^2 / s_d^2 + c^2 / s_c^2) / 2 - t / T) of all ended tracks (d: distance in sizes of the larger,
/// c: difference of the mean colours, t: time away), the confidence in one is its part of their sum and `newcomer_weight`.
struct RememberOptions {
  static constexpr const char* model = "remember";
  static constexpr const char* meaning = "who comes back where a track ended, and looks the same, is that track";

  double max_away_s = 60.0;
  double away_time_s = 30.0;
  double place_deviation = 1.5;
  double color_deviation = 0.05;
  double newcomer_weight = 0.2;
  double min_confidence = 0.6;

  static constexpr auto fields() {
    using O = RememberOptions;
    return std::make_tuple(
        field("max_away_s", &O::max_away_s, "s", "a track that ended longer ago is forgotten", between(0, 1e6)),
        field("away_time_s", &O::away_time_s, "s", "T: the weight of a track falls by 1/e in this time", above_up_to(0, 1e6)),
        field("place_deviation", &O::place_deviation, "object sizes",
              "s_d: standard deviation of the place, about the one where the track was seen last or would be by its velocity",
              above_up_to(0, 1e6)),
        field("color_deviation", &O::color_deviation, "",
              "s_c: standard deviation of a track's mean colour, of 0 to 1.73 (Narayana 2007, eq. 3.6); 0: colour does not count",
              between(0, 1e6)),
        field("newcomer_weight", &O::newcomer_weight, "", "weight of being someone new", above_up_to(0, 1e6)),
        field("min_confidence", &O::min_confidence, "", "an identity is given again from this confidence on", between(0, 1)));
  }
};

using ReentryOptions = std::variant<NoReentryOptions, RememberOptions>;

}  // namespace survtrack
