// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <variant>

#include "survtrack/core/fields.hpp"

namespace survtrack {

/// Costs are what `cost` says.
struct NoAppearanceOptions {
  static constexpr const char* model = "none";
  static constexpr const char* meaning = "nothing beside the cost";
  static constexpr auto fields() { return std::make_tuple(); }
};

/// A term of the cost beside the model's own: tracks keep a colour histogram, which detections intersect (Swain and
/// Ballard 1991; Nashenda 2011, 2.3).
struct ColorHistogramOptions {
  static constexpr const char* model = "color_histogram";
  static constexpr const char* meaning = "intersection with the track's colour histogram (Swain and Ballard 1991)";

  double weight = 4.0;
  double refresh_rate = 0.1;
  double min_intersection = 0.0;

  static constexpr auto fields() {
    using O = ColorHistogramOptions;
    return std::make_tuple(
        field("weight", &O::weight, "", "what a pair without a colour in common costs more, in the cost's own unit", between(0, 1e6)),
        field("refresh_rate", &O::refresh_rate, "", "how far the track's histogram moves to that of its detection; 0: it stays the first",
              between(0, 1)),
        field("min_intersection", &O::min_intersection, "", "pairs that intersect less are refused", between(0, 1)));
  }
};

using AppearanceOptions = std::variant<NoAppearanceOptions, ColorHistogramOptions>;

}  // namespace survtrack
