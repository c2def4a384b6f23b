// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "tracking/path_cubic.hpp"

#include <array>

namespace survtrack {
namespace {

struct Node {
  double place, weight;
};

/// Gauss-Legendre quadrature of five points on -1 to 1: (0, +-sqrt(5 -+ 2 sqrt(10/7)) / 3).
constexpr std::array<Node, 5> nodes{{{-0.90617984593866399, 0.23692688505618909},
                                     {-0.53846931010568309, 0.47862867049936647},
                                     {0.0, 0.56888888888888889},
                                     {0.53846931010568309, 0.47862867049936647},
                                     {0.90617984593866399, 0.23692688505618909}}};

/// The rate at `here` with which a centripetal spline goes from `before` on to `after`, in units of the root of px: the
/// rate of the parabola through the three, whose parameters are apart by the roots of their distances.
Point rate_through(const Point& before, const Point& here, const Point& after) {
  const double first = std::sqrt(norm(here - before)), second = std::sqrt(norm(after - here));
  const Point in = (1.0 / first) * (here - before), out = (1.0 / second) * (after - here);
  return (1.0 / (first + second)) * (second * in + first * out);
}

}  // namespace

double PathCubic::length_px(double from, double to) const {
  const double half = 0.5 * (to - from), middle = 0.5 * (to + from);
  double sum = 0.0;
  for (const Node& node : nodes) sum += node.weight * norm(rate(middle + half * node.place));
  return half * sum;
}

std::vector<PathCubic> cubics_through(const std::vector<Point>& points, bool closed, PathKind kind) {
  const std::size_t count = points.size(), legs = closed ? count : count - 1;
  std::vector<PathCubic> cubics;
  cubics.reserve(legs);
  for (std::size_t i = 0; i < legs; ++i) {
    const Point p = points[i], q = points[(i + 1) % count], leg = q - p;
    if (kind == PathKind::line) {
      cubics.push_back({p, leg, {}, {}});
      continue;
    }
    // Beyond an open end the first or last leg goes on as long again.
    const Point before = i > 0 || closed ? points[(i + count - 1) % count] : p - leg;
    const Point after = i + 2 < count || closed ? points[(i + 2) % count] : q + leg;
    const double knots = std::sqrt(norm(leg));  // the parameter's own unit on this leg
    const Point in = knots * rate_through(before, p, q), out = knots * rate_through(p, q, after);
    cubics.push_back({p, in, 3.0 * leg - 2.0 * in - out, in + out - 2.0 * leg});
  }
  return cubics;
}

}  // namespace survtrack
