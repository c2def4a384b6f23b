// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <array>
#include <utility>

#include "survtrack/core/geometry.hpp"

namespace survtrack {

/// The three numbers that a mean colour is compared by.
enum class ColorSpace {
  bgr,  ///< blue, green, red, 0 to 255 each
  hsv,  ///< hue in degrees, saturation and value, 0 to 255 each
  lab,  ///< CIE L*a*b* of sRGB under D65: lightness 0 to 100, a and b about -110 to 110
};
constexpr auto enum_names(ColorSpace) {
  return std::array{std::pair{"bgr", ColorSpace::bgr}, std::pair{"hsv", ColorSpace::hsv},
                    std::pair{"lab", ColorSpace::lab}};
}

using ColorCoordinates = std::array<double, 3>;

/// A colour in a space; the hue of grey is 0.
ColorCoordinates coordinates(const Color& color, ColorSpace space);

/// b - a in each coordinate; hues differ by -180 to 180 degrees.
ColorCoordinates color_difference(const ColorCoordinates& a, const ColorCoordinates& b, ColorSpace space);

/// Distance of two colours whose channels count 0 to 1: 0 to 1.73 (Narayana 2007, eq. 3.6).
double color_distance(const Color& a, const Color& b);

}  // namespace survtrack
