// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "survtrack/tracking/path.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <utility>

#include "survtrack/core/errors.hpp"
#include "tracking/path_shape.hpp"

namespace survtrack {
namespace {

constexpr std::size_t chunk = 256;  // points whose nearest chords are found in one go, on the stack
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double least_divisor = 0.01;
constexpr double largest_stretch = 100.0;

Point left_to_right(const Point& tangent) { return {-tangent.y, tangent.x}; }

void check(const char* name, std::size_t i, double first, double second) {
  if (std::abs(first) <= Path::most_position_px && std::abs(second) <= Path::most_position_px) return;
  std::ostringstream text;
  text << name << "[" << i << "]: is (" << first << ", " << second << "); expected finite numbers within +-1e9";
  throw InputError(text.str());
}

PathPosition place_by(const PathShape& shape, const Point& p, const NearestChord& chord) {
  const PathSpot spot = shape.nearest(p, chord);
  const PathFrame frame = shape.frame_at(spot);
  const Point off = p - frame.origin;
  const double distance = norm(off);
  if (distance > shape.max_distance_px) return {nan, nan};
  const double along = dot(frame.tangent, off), across = cross(frame.tangent, off);
  if (frame.corner) return {shape.s_of(spot), std::copysign(distance, across)};
  if (shape.closed || spot.side == 0 || (spot.side < 0 && spot.piece > 0)) return {shape.s_of(spot), across};
  return {shape.s_of(spot) + along, across};  // beyond an end
}

Point point_by(const PathShape& shape, const PathPosition& place) {
  const PathFrame frame = shape.frame_at(shape.spot_at(place.s_px));
  const double beyond = shape.closed ? 0.0 : place.s_px - std::clamp(place.s_px, 0.0, shape.length_px);
  return frame.origin + beyond * frame.tangent + place.t_px * left_to_right(frame.tangent);
}

}  // namespace

const char* to_string(PathKind kind) { return kind == PathKind::line ? "line" : "curve"; }

Path::Path(std::vector<Point> points, bool closed, PathKind kind, double max_distance_px)
    : shape_(std::make_shared<const PathShape>(std::move(points), closed, kind, max_distance_px)) {}

const std::vector<Point>& Path::points() const { return shape_->points; }
bool Path::closed() const { return shape_->closed; }
PathKind Path::kind() const { return shape_->kind; }
double Path::max_distance_px() const { return shape_->max_distance_px; }
double Path::length_px() const { return shape_->length_px; }

void Path::to_path(const Point* points, std::size_t count, PathPosition* places) const {
  for (std::size_t i = 0; i < count; ++i) check("points", i, points[i].x, points[i].y);
  std::array<NearestChord, chunk> chords;
  for (std::size_t first = 0; first < count; first += chunk) {
    const std::size_t size = std::min(chunk, count - first);
    find_nearest_chords(shape_->chords, points + first, size, chords.data());
    for (std::size_t i = 0; i < size; ++i) places[first + i] = place_by(*shape_, points[first + i], chords[i]);
  }
}

PathPosition Path::to_path(const Point& point) const {
  PathPosition place;
  to_path(&point, 1, &place);
  return place;
}

void Path::to_image(const PathPosition* places, std::size_t count, Point* points) const {
  for (std::size_t i = 0; i < count; ++i) check("places", i, places[i].s_px, places[i].t_px);
  for (std::size_t i = 0; i < count; ++i) points[i] = point_by(*shape_, places[i]);
}

Point Path::to_image(const PathPosition& place) const {
  Point point;
  to_image(&place, 1, &point);
  return point;
}

PathPosition Path::velocity(const Point& point, const Point& velocity_px_per_s) const {
  check("point", 0, point.x, point.y);
  check("velocity_px_per_s", 0, velocity_px_per_s.x, velocity_px_per_s.y);
  NearestChord chord;
  find_nearest_chords(shape_->chords, &point, 1, &chord);
  const PathSpot spot = shape_->nearest(point, chord);
  const PathFrame frame = shape_->frame_at(spot);
  const Point off = point - frame.origin;
  if (norm(off) > shape_->max_distance_px) return {nan, nan};
  const double divisor = 1.0 - shape_->curvature(spot) * cross(frame.tangent, off);
  return {dot(frame.tangent, velocity_px_per_s) / std::max(divisor, least_divisor),
          cross(frame.tangent, velocity_px_per_s)};
}

double Path::stretch(const PathPosition& place) const {
  check("place", 0, place.s_px, place.t_px);
  const bool beyond = !closed() && (place.s_px < 0.0 || place.s_px > length_px());  // there it goes straight on
  const double curvature = beyond ? 0.0 : shape_->curvature(shape_->spot_at(place.s_px));
  return std::clamp(1.0 - curvature * place.t_px, least_divisor, largest_stretch);
}

Point Path::tangent(double s_px) const {
  check("s_px", 0, s_px, 0.0);
  return shape_->frame_at(shape_->spot_at(s_px)).tangent;
}

Point Path::normal(double s_px) const { return left_to_right(tangent(s_px)); }

double Path::wrap(double s_px) const {
  check("s_px", 0, s_px, 0.0);
  return shape_->wrap(s_px);
}

double Path::residual(double measured_s_px, double predicted_s_px) const {
  check("s_px", 0, measured_s_px, predicted_s_px);
  const double difference = measured_s_px - predicted_s_px, half = 0.5 * shape_->length_px;
  return shape_->closed ? shape_->wrap(difference + half) - half : difference;
}

bool operator==(const Path& a, const Path& b) {
  return a.points() == b.points() && a.closed() == b.closed() && a.kind() == b.kind() &&
         a.max_distance_px() == b.max_distance_px();
}

}  // namespace survtrack
