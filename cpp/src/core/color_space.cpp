// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "survtrack/core/color_space.hpp"

#include <algorithm>
#include <cmath>

namespace survtrack {
namespace {

ColorCoordinates hsv(const Color& c) {
  const double value = std::max({c.blue, c.green, c.red});
  const double chroma = value - std::min({c.blue, c.green, c.red});
  if (chroma <= 0.0) return {0.0, 0.0, value};
  double sixth = 0.0;
  if (value == c.red) {
    sixth = (c.green - c.blue) / chroma;
  } else if (value == c.green) {
    sixth = 2.0 + (c.blue - c.red) / chroma;
  } else {
    sixth = 4.0 + (c.red - c.green) / chroma;
  }
  return {60.0 * (sixth < 0.0 ? sixth + 6.0 : sixth), 255.0 * chroma / value, value};
}

/// IEC 61966-2-1.
double linear_of_srgb(double level) {
  const double v = std::clamp(level / 255.0, 0.0, 1.0);
  return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
}

/// CIE 15: the cube root with a linear foot.
double lab_root(double t) {
  constexpr double foot = 216.0 / 24389.0;
  return t > foot ? std::cbrt(t) : (24389.0 / 27.0 * t + 16.0) / 116.0;
}

ColorCoordinates lab(const Color& c) {
  const double r = linear_of_srgb(c.red);
  const double g = linear_of_srgb(c.green);
  const double b = linear_of_srgb(c.blue);
  const double x = lab_root((0.412453 * r + 0.357580 * g + 0.180423 * b) / 0.950456);
  const double y = lab_root(0.212671 * r + 0.715160 * g + 0.072169 * b);
  const double z = lab_root((0.019334 * r + 0.119193 * g + 0.950227 * b) / 1.088754);
  return {116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)};
}

}  // namespace

ColorCoordinates coordinates(const Color& color, ColorSpace space) {
  switch (space) {
    case ColorSpace::hsv: return hsv(color);
    case ColorSpace::lab: return lab(color);
    case ColorSpace::bgr: break;
  }
  return {color.blue, color.green, color.red};
}

ColorCoordinates color_difference(const ColorCoordinates& a, const ColorCoordinates& b, ColorSpace space) {
  ColorCoordinates d{b[0] - a[0], b[1] - a[1], b[2] - a[2]};
  if (space != ColorSpace::hsv) return d;
  if (d[0] > 180.0) d[0] -= 360.0;
  if (d[0] < -180.0) d[0] += 360.0;
  return d;
}

double color_distance(const Color& a, const Color& b) {
  return std::hypot((a.red - b.red) / 255.0, (a.green - b.green) / 255.0, (a.blue - b.blue) / 255.0);
}

}  // namespace survtrack
