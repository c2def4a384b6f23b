// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "tracking/path_shape.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "tracking/path_checks.hpp"

namespace survtrack {
namespace {

constexpr double fine_px = 0.02;  // chords of a curve are no farther from it, while most_pieces allows
constexpr double most_pieces = 1000;
constexpr int most_steps = 100;  // halving alone needs 53

/// Pieces of a cubic whose chords keep to fine_px: over a step h of the parameter it is at most h^2/8 times the largest
/// second derivative from its chord, and that is linear.
double pieces_of(const PathCubic& cubic) {
  const double bend = std::max(norm(cubic.bend(0.0)), norm(cubic.bend(1.0)));
  return std::clamp(std::ceil(std::sqrt(bend / (8.0 * fine_px))), 1.0, most_pieces);
}

/// Where a function that is below 0 at `low` and above at `high` is 0, by Newton's steps that keep between them.
/// `function(u)` returns its value and its derivative.
template <class Function>
double zero_between(double low, double high, double u, Function&& function) {
  for (int step = 0; step < most_steps; ++step) {
    const auto [value, derivative] = function(u);
    if (value == 0.0) return u;
    (value < 0.0 ? low : high) = u;
    double next = u - value / derivative;
    if (!(derivative > 0.0 && next > low && next < high)) next = 0.5 * (low + high);
    if (std::abs(next - u) <= 4.0 * std::numeric_limits<double>::epsilon()) return next;
    u = next;
  }
  return u;
}

}  // namespace

PathShape::PathShape(std::vector<Point> given, bool is_closed, PathKind given_kind, double most_distance_px)
    : points(std::move(given)), closed(is_closed), kind(given_kind), max_distance_px(most_distance_px) {
  check_path_points(points, closed, max_distance_px);
  legs = cubics_through(points, closed, kind);
  for (std::size_t leg = 0; leg < legs.size(); ++leg) {
    const PathCubic& cubic = legs[leg];
    const double count = kind == PathKind::line ? 1.0 : pieces_of(cubic);
    const double bend = std::max(norm(cubic.bend(0.0)), norm(cubic.bend(1.0)));
    bulge_px = std::max(bulge_px, bend / (8.0 * count * count));
    for (double k = 0.0; k < count; ++k) {
      const double begin = k / count, end = (k + 1.0) / count;
      const double piece_px = kind == PathKind::line ? norm(cubic.b) : cubic.length_px(begin, end);
      pieces.push_back({leg, begin, end, length_px, piece_px});
      chords.add(cubic.at(begin), k + 1.0 < count ? cubic.at(end) : points[(leg + 1) % points.size()]);
      length_px += piece_px;
    }
  }
  chords.finish();
  check_path_crossings(*this);
}

double PathShape::wrap(double s_px) const {
  if (!closed) return s_px;
  double wrapped = std::fmod(s_px, length_px);
  if (wrapped < 0.0) wrapped += length_px;
  return wrapped < length_px ? wrapped : 0.0;  // a hair below 0 rounds to the length
}

PathSpot PathShape::nearest(const Point& p, const NearestChord& chord) const {
  if (kind == PathKind::line) return settled(nearest_on(chord.chord, p), p);
  // The nearest piece is none whose chord is farther than the nearest chord and both bulges.
  const double reach = std::sqrt(chord.distance_px2) + 2.0 * bulge_px + 1e-9;
  const double reach_px2 = reach * reach;
  PathSpot best;
  double best_px2 = std::numeric_limits<double>::infinity();
  for (std::size_t block = 0; block < chords.blocks(); ++block) {
    if (chords.least_px2(block, p) > reach_px2) continue;
    const std::size_t last = std::min(chords.count, (block + 1) * PathChords::lanes);
    for (std::size_t i = block * PathChords::lanes; i < last; ++i) {
      if (chords.distance_px2(i, p) > reach_px2) continue;
      const PathSpot spot = nearest_on(i, p);
      const Point off = p - cubic(i).at(spot.u);
      if (dot(off, off) < best_px2) {
        best = spot;
        best_px2 = dot(off, off);
      }
    }
  }
  return settled(best, p);
}

/// The nearest point of one piece: an end when the distance only grows or falls along it.
PathSpot PathShape::nearest_on(std::size_t i, const Point& p) const {
  const PathPiece& piece = pieces[i];
  const PathCubic& c = cubic(i);
  // Half the derivative of the squared distance.
  const auto slope = [&](double u) { return dot(c.at(u) - p, c.rate(u)); };
  if (slope(piece.begin) >= 0.0) return {i, piece.begin, -1};
  if (slope(piece.end) <= 0.0) return {i, piece.end, 1};
  const Point step = chords.step(i);
  const double t = std::clamp(dot(p - chords.start(i), step) * chords.inverse_px2[i], 0.0, 1.0);
  const double start = piece.begin + t * (piece.end - piece.begin);
  const double u = zero_between(piece.begin, piece.end, start, [&](double v) {
    const Point rate = c.rate(v), off = c.at(v) - p;
    return std::pair{dot(off, rate), dot(rate, rate) + dot(off, c.bend(v))};
  });
  return {i, u, 0};
}

/// From the end of a piece into the next one, where that is nearer: squared distances alone cannot tell what is less
/// than the root of the rounding apart.
PathSpot PathShape::settled(PathSpot spot, const Point& p) const {
  for (std::size_t walked = 0; spot.side != 0 && walked < pieces.size(); ++walked) {
    if (spot.side > 0 ? !has_after(spot.piece) : !has_before(spot.piece)) break;
    const PathSpot next = nearest_on(spot.side > 0 ? after(spot.piece) : before(spot.piece), p);
    if (next.side == -spot.side) {
      if (spot.side > 0) spot = next;
      break;
    }
    spot = next;
  }
  return spot;
}

PathSpot PathShape::spot_at(double s_px) const {
  const double s = wrap(s_px);
  if (!closed && s <= 0.0) return {0, pieces.front().begin, -1};
  if (!closed && s >= length_px) return {pieces.size() - 1, pieces.back().end, 1};
  const auto later = std::upper_bound(pieces.begin(), pieces.end(), s,
                                      [](double value, const PathPiece& piece) { return value < piece.s_px; });
  const auto i = static_cast<std::size_t>(later - pieces.begin()) - 1;
  const PathPiece& piece = pieces[i];
  const double along = s - piece.s_px;
  if (along == 0.0) return {i, piece.begin, -1};
  const double start = piece.begin + (piece.end - piece.begin) * std::min(along / piece.length_px, 1.0);
  if (kind == PathKind::line) return {i, start, 0};
  const PathCubic& c = cubic(i);
  const double u = zero_between(piece.begin, piece.end, start, [&](double v) {
    return std::pair{c.length_px(piece.begin, v) - along, norm(c.rate(v))};
  });
  return {i, u, 0};
}

double PathShape::s_of(const PathSpot& spot) const {
  const PathPiece& piece = pieces[spot.piece];
  if (spot.side < 0) return piece.s_px;
  if (spot.side > 0) return length_px;
  const bool is_line = kind == PathKind::line;
  const double along = is_line ? spot.u * piece.length_px : cubic(spot.piece).length_px(piece.begin, spot.u);
  return wrap(piece.s_px + along);
}

PathFrame PathShape::frame_at(const PathSpot& spot) const {
  const PathCubic& c = cubic(spot.piece);
  const Point tangent = unit(c.rate(spot.u));
  if (kind == PathKind::curve || spot.side >= 0 || !has_before(spot.piece)) return {c.at(spot.u), tangent, false};
  return {c.at(spot.u), unit(unit(cubic(before(spot.piece)).rate(1.0)) + tangent), true};
}

double PathShape::curvature(const PathSpot& spot) const {
  const bool end = !closed && (spot.side > 0 || (spot.side < 0 && spot.piece == 0));
  if (kind == PathKind::line || end) return 0.0;
  const PathCubic& c = cubic(spot.piece);
  const Point rate = c.rate(spot.u);
  const double speed = norm(rate);
  return cross(rate, c.bend(spot.u)) / (speed * speed * speed);
}

}  // namespace survtrack
