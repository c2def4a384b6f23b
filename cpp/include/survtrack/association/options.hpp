// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <variant>

#include "survtrack/core/fields.hpp"

namespace survtrack {

/// Cost of a pair: the match matrix (Narayana 2007, 3.5.1 and eq. 3.6).
struct MatchMatrixOptions {
  static constexpr const char* model = "match_matrix";
  static constexpr const char* meaning =
      "distance in the frame plus distance in colour, from the last position (Narayana 2007, eq. 3.6)";

  double max_match = 0.0;

  static constexpr auto fields() {
    using O = MatchMatrixOptions;
    return std::make_tuple(field("max_match", &O::max_match, "", "pairs of a larger value are refused; 0: none is",
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

using CostOptions = std::variant<GaussianCostOptions, MatchMatrixOptions>;

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

using AssignmentOptions = std::variant<HungarianOptions, OldestFirstOptions>;

}  // namespace survtrack
