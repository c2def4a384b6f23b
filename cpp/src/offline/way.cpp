// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "offline/way.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace survtrack {
namespace {

constexpr double trembling = 0.2;  // object sizes
constexpr double degrees = 57.295779513082320877;
constexpr double cosine_slack = 1e-12;  // a sum of rounded cosines; 1e-12 is less than 0.0001 degrees

double length_of(const Point& p) { return std::sqrt(p.x * p.x + p.y * p.y); }

double dot(const Point& a, const Point& b) { return a.x * b.x + a.y * b.y; }

/// Mean cosine of the angles between corresponding directions.
double mean_cosine(const Way& a, const Way& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.directions.size(); ++i) sum += dot(a.directions[i], b.directions[i]);
  return std::clamp(sum / static_cast<double>(a.directions.size()), -1.0, 1.0);
}

}  // namespace

Polyline::Polyline(std::vector<Point> corners) : corners_(std::move(corners)) {
  double length = 0.0;
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    if (i > 0) length += length_of(corners_[i] - corners_[i - 1]);
    lengths_.push_back(length);
  }
}

std::pair<std::size_t, double> Polyline::piece_at(double length_px) const {
  const auto beyond = std::upper_bound(lengths_.begin(), lengths_.end(), length_px);
  const auto next = static_cast<std::size_t>(beyond - lengths_.begin());
  return {next, (length_px - lengths_[next - 1]) / (lengths_[next] - lengths_[next - 1])};
}

Point Polyline::at(double length_px) const {
  if (length_px >= lengths_.back()) return corners_.back();
  if (length_px <= 0.0) return corners_.front();
  const auto [next, part] = piece_at(length_px);
  return corners_[next - 1] + part * (corners_[next] - corners_[next - 1]);
}

double Polyline::value_at(double length_px, const std::vector<double>& at_corners) const {
  if (length_px >= lengths_.back()) return at_corners.back();
  if (length_px <= 0.0) return at_corners.front();
  const auto [next, part] = piece_at(length_px);
  return at_corners[next - 1] + part * (at_corners[next] - at_corners[next - 1]);
}

double Polyline::nearest(const Point& point) const {
  double least = length_of(point - corners_.front()), place = 0.0;
  for (std::size_t i = 1; i < corners_.size(); ++i) {
    const Point piece = corners_[i] - corners_[i - 1];
    const double piece_px = lengths_[i] - lengths_[i - 1];
    const double square = dot(piece, piece);
    const double part = square > 0.0 ? std::clamp(dot(point - corners_[i - 1], piece) / square, 0.0, 1.0) : 0.0;
    const double distance = length_of(point - (corners_[i - 1] + part * piece));
    if (distance < least) {
      least = distance;
      place = lengths_[i - 1] + part * piece_px;
    }
  }
  return place;
}

Way way_along(const Polyline& line, double from_px, double to_px, int count, double size_px) {
  Way way;
  way.size_px = size_px;
  for (int i = 0; i < count; ++i) {
    // So that the last is the end to the bit.
    const double part = static_cast<double>(i) / (count - 1);
    way.points.push_back(line.at(i + 1 == count ? to_px : from_px + part * (to_px - from_px)));
  }
  for (const Point& point : way.points) way.middle = way.middle + (1.0 / count) * point;
  for (std::size_t i = 1; i < way.points.size(); ++i) {
    const Point step = way.points[i] - way.points[i - 1];
    const double px = length_of(step);
    way.directions.push_back(px > 0.0 ? Point{step.x / px, step.y / px} : Point{});
  }
  return way;
}

Way way_along(const Polyline& line, int count, double size_px) {
  return way_along(line, 0.0, line.length_px(), count, size_px);
}

std::vector<TrackPoint> steps_of(const RecordedTrack& track, double size_px) {
  std::vector<TrackPoint> steps = {track.points.front()};
  for (const TrackPoint& point : track.points) {
    if (length_of(point.position - steps.back().position) >= trembling * size_px) steps.push_back(point);
  }
  if (steps.back().index != track.points.back().index) steps.push_back(track.points.back());
  return steps;
}

double distance_between(const Way& a, const Way& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.points.size(); ++i) sum += length_of(a.points[i] - b.points[i]);
  return sum / (static_cast<double>(a.points.size()) * 0.5 * (a.size_px + b.size_px));
}

double angle_between_deg(const Way& a, const Way& b) { return degrees * std::acos(mean_cosine(a, b)); }

bool same_way(const Way& a, const Way& b, const PatternOptions& options) {
  const double most = static_cast<double>(a.points.size()) * limit_px(a.size_px, b.size_px, options);
  double sum = 0.0;
  for (std::size_t i = 0; i < a.points.size(); ++i) {
    sum += length_of(a.points[i] - b.points[i]);
    if (sum > most) return false;
  }
  return mean_cosine(a, b) >= std::cos(options.max_angle_deg / degrees) - cosine_slack;
}

}  // namespace survtrack
