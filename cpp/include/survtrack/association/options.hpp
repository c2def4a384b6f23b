// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <array>
#include <utility>
#include <variant>

#include "survtrack/core/color_space.hpp"
#include "survtrack/core/fields.hpp"

namespace survtrack {

/// Cost of a pair: the match matrix (Narayana 2007, 3.5.1 and eq. 3.6).
struct MatchMatrixOptions {
  static constexpr const char* model = "match_matrix";
  static constexpr const char* meaning =
      "distance in the frame plus distance in colour, from the last position (Narayana 2007, eq. 3.6)";

  double max_match = 0.0;
  double velocity_break_point = 0.0;

  static constexpr auto fields() {
    using O = MatchMatrixOptions;
    return std::make_tuple(
        field("max_match", &O::max_match, "", "pairs of a larger value are refused; 0: none is", between(0, 1e6)),
        field("velocity_break_point", &O::velocity_break_point, "px/unit",
              "difference in velocity from which the velocity factor is 5 (4.2); 0: no such factor", between(0, 1e6)));
  }
};

/// How the velocity factor enters a belief.
enum class BeliefOrder {
  free,       ///< the factor multiplies the odds; the order of the blobs does not matter
  published,  ///< the factor multiplies the probability, blob after blob
};
constexpr auto enum_names(BeliefOrder) {
  return std::array{std::pair{"free", BeliefOrder::free}, std::pair{"published", BeliefOrder::published}};
}

/// Bayesian correspondence (Narayana 2007, 8): the probability that a track is each of the blobs, or lost.
/// A pair costs 1 - belief; it is refused when "lost" is no less probable.
struct BeliefOptions {
  static constexpr const char* model = "belief";
  static constexpr const char* meaning =
      "probability that a track is each of the blobs, or lost, from colour, position, velocity (Narayana 2007, 8)";

  BeliefOrder order = BeliefOrder::free;
  double velocity_break_point = 0.0;
  double color_weight = 30.0;
  double position_weight = 30.0;
  double size_weight = 0.0;
  ColorSpace color_space = ColorSpace::bgr;
  int learn_after = 200;

  static constexpr auto fields() {
    using O = BeliefOptions;
    return std::make_tuple(
        field("order", &O::order, "", "whether the order of the blobs matters, as published, or not"),
        field("velocity_break_point", &O::velocity_break_point, "px/unit",
              "difference in velocity from which the velocity factor is 0.2 (8.3.4); 0: no such factor", between(0, 1e6)),
        field("color_weight", &O::color_weight, "",
              "Cf: the densities of colour have the peak Cf / 30; 0: colour is not looked at", between(0, 3000)),
        field("position_weight", &O::position_weight, "",
              "Pf: the densities of position have the peak Pf / 30; 0: position is not looked at", between(0, 3000)),
        field("size_weight", &O::size_weight, "", "the same for the logarithm of the size; 0: size is not looked at",
              between(0, 3000)),
        field("color_space", &O::color_space, "", "what colours are compared in"),
        field("learn_after", &O::learn_after, "matches",
              "the densities are learned from matches, and used from so many on; 0: those of the beginning stay",
              between(0, 1e6)));
  }
};

/// Cost of a pair: minus twice the log likelihood of the innovation under the filter's own covariance, but for
/// a constant (Bar-Shalom, Li and Kirubarajan 2001, 5.4).
struct GaussianCostOptions {
  static constexpr const char* model = "gaussian";
  static constexpr const char* meaning = "log likelihood of the innovation, from the predicted position";

  double gate = 9.21;

  static constexpr auto fields() {
    using O = GaussianCostOptions;
    return std::make_tuple(
        field("gate", &O::gate, "", "largest squared Mahalanobis distance; 9.21 holds 99 % of the true pairs", above_up_to(0, 1e6)));
  }
};

/// Cost of a pair: the distance from the predicted position (Semko 2007, IV.C.2).
struct DistanceOptions {
  static constexpr const char* model = "distance";
  static constexpr const char* meaning = "distance from the predicted position (Semko 2007)";

  double max_distance_px = 0.0;

  static constexpr auto fields() {
    using O = DistanceOptions;
    return std::make_tuple(field("max_distance_px", &O::max_distance_px, "px",
                                 "pairs further apart are refused; 0: none is", between(0, 1e6)));
  }
};

using CostOptions = std::variant<GaussianCostOptions, MatchMatrixOptions, BeliefOptions, DistanceOptions>;

/// Tracks in order of age, each takes its best detection still free (Narayana 2007, 3.5.4).
struct OldestFirstOptions {
  static constexpr const char* model = "oldest_first";
  static constexpr const char* meaning = "tracks in order of age, each takes its best (Narayana 2007, 3.5.4)";
  static constexpr auto fields() { return std::make_tuple(); }
};

/// Optimal one-to-one assignment (Kuhn 1955).
struct HungarianOptions {
  static constexpr const char* model = "hungarian";
  static constexpr const char* meaning = "optimal one-to-one assignment (Kuhn 1955)";

  bool confirmed_first = true;

  static constexpr auto fields() {
    using O = HungarianOptions;
    return std::make_tuple(field("confirmed_first", &O::confirmed_first, "",
                                 "tentative tracks get only what believed ones leave"));
  }
};

/// The contact monitor's published order (Semko 2007, IV.C.2): as long as there are as many detections as tracks, the
/// first track gets the topmost one, and so on; otherwise the nearest, one to one.
struct RowOrderOptions {
  static constexpr const char* model = "row_order";
  static constexpr const char* meaning =
      "as many detections as tracks: from top to bottom, in order of age; else the optimal one (Semko 2007)";
  static constexpr auto fields() { return std::make_tuple(); }
};

/// Where one object is followed (Nashenda 2011, 4): the largest detection is its measurement, wherever it is.
struct LargestOptions {
  static constexpr const char* model = "largest";
  static constexpr const char* meaning =
      "tracks in order of age, each takes the largest detection that its cost does not refuse (Nashenda 2011)";
  static constexpr auto fields() { return std::make_tuple(); }
};

using AssignmentOptions = std::variant<HungarianOptions, OldestFirstOptions, RowOrderOptions, LargestOptions>;

}  // namespace survtrack
