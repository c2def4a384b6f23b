// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "survtrack/tracking/path_bank.hpp"

#include <algorithm>
#include <cmath>

#include "survtrack/core/errors.hpp"
#include "survtrack/filtering/discrete_step.hpp"

namespace survtrack {
namespace {

constexpr double farthest_px = 1e8;  // Path takes no numbers beyond 1e9
constexpr double fastest = 1e12;
/// A variance beyond this many times those beside it says no more than that nothing is measured, and costs digits.
constexpr double largest_ratio = 1e6;
constexpr double least_part = 1e-9;

Point within(const Point& p) {
  return {std::clamp(p.x, -farthest_px, farthest_px), std::clamp(p.y, -farthest_px, farthest_px)};
}

/// The point of the path, its ends included, that belongs to a place by it.
Point foot(const Path& path, const PathPosition& place) {
  return path.to_image({path.closed() ? place.s_px : std::clamp(place.s_px, 0.0, path.length_px()), 0.0});
}

Eigen::Matrix2d matrix_of(const Symmetric2& s) {
  Eigen::Matrix2d m;
  m << s.xx, s.xy, s.xy, s.yy;
  return m;
}

Symmetric2 symmetric_of(const Eigen::Matrix2d& m) { return {m(0, 0), m(0, 1), m(1, 1)}; }

}  // namespace

PathBank::PathBank(const KalmanPathOptions& options) : options_(options) {
  check_fields(options, "filter");
  const double area = options.unit_px * options.unit_px;
  for (double& variance : options_.process_variances) variance *= area;
  for (double& variance : options_.measurement_variances) variance *= area;
  for (double& variance : options_.initial_variances) variance *= area;
  for (double& velocity : options_.initial_velocity) velocity *= options.unit_px;
}

void PathBank::set_paths(const Paths& paths) {
  if (paths.items().empty()) throw InputError("paths: has none; expected at least one path");
  if (size() > 0) throw InputError("paths: tracks are on those before; expected paths before the first frame, or after reset()");
  paths_ = paths;
  endless_.clear();
  for (const NamedPath& item : paths.items()) endless_.emplace_back(item.path.points(), item.path.closed(), item.path.kind());
}

void PathBank::check_frame_size(int width, int height) const {
  if (paths_.items().empty()) {
    throw InputError("filter.model: \"kalman_path\" has no paths; expected load_paths() before the first frame, or "
                     "--path FILE on the command line");
  }
  const bool known = paths_.frame_width > 0 && paths_.frame_height > 0 && width > 0 && height > 0;
  if (!known || (width == paths_.frame_width && height == paths_.frame_height)) return;
  throw InputError("frame: is " + std::to_string(width) + "x" + std::to_string(height) +
                   " px, and the paths are drawn on frames of " + std::to_string(paths_.frame_width) + "x" +
                   std::to_string(paths_.frame_height) + " px; expected the same size");
}

/// -1: none that is near enough. Of equal ones the first.
int PathBank::nearest_path(const Point& position) const {
  if (!(std::abs(position.x) <= farthest_px && std::abs(position.y) <= farthest_px)) return -1;
  int nearest = -1;
  double least = 0.0;
  for (std::size_t i = 0; i < paths_.items().size(); ++i) {
    const Path& path = paths_.items()[i].path;
    const PathPosition place = path.to_path(position);
    if (std::isnan(place.s_px)) continue;
    const Point off = position - foot(path, place);
    const double distance = std::hypot(off.x, off.y);
    if (nearest >= 0 && distance >= least) continue;
    nearest = static_cast<int>(i);
    least = distance;
  }
  return nearest;
}

int PathBank::add(const Point& position, double) {
  const int path = nearest_path(position);
  if (path < 0) throw InputError("position: is too far off every path; expected one within max_distance_px of a path");
  slots_.push_back({static_cast<std::size_t>(path), {}});
  const int slot = bank_.add(Bank::State::Zero(), Bank::Covariance::Zero());
  start(slot, position);
  return slot;
}

/// The object may be on another path now.
void PathBank::restart(int slot, const Point& position, double) {
  const int path = nearest_path(position);
  if (path >= 0) slots_[static_cast<std::size_t>(slot)].path = static_cast<std::size_t>(path);
  start(slot, position);
}

void PathBank::start(int slot, const Point& position) {
  const PathPosition place = endless_[at(slot).path].to_path(within(position));
  bank_.x(slot) << place.s_px, place.t_px, options_.initial_velocity[0], options_.initial_velocity[1];
  bank_.P(slot) = Eigen::Vector4d(options_.initial_variances.data()).asDiagonal();
  slots_[static_cast<std::size_t>(slot)].before = place;
}

void PathBank::remove(int slot) {
  bank_.remove(slot);
  slots_.erase(slots_.begin() + slot);
}

void PathBank::clear() {
  bank_.clear();
  slots_.clear();
}

void PathBank::predict(double dt) {
  const DiscreteStep step = discrete_step(options_.process_variances, {}, options_.step_time, dt);
  for (int slot = 0; slot < bank_.size(); ++slot) {
    slots_[static_cast<std::size_t>(slot)].before = place(slot);
    bank_.predict(slot, step.F, step.Q);
    settle(slot);
  }
}

/// Once round a closed path is the same place. Who is predicted for ever stays where a path has places.
void PathBank::settle(int slot) {
  auto x = bank_.x(slot);
  x.head<2>() = x.head<2>().cwiseMax(-farthest_px).cwiseMin(farthest_px).eval();
  x.tail<2>() = x.tail<2>().cwiseMax(-fastest).cwiseMin(fastest).eval();
  if (path_of(slot).closed()) x(0) = path_of(slot).wrap(x(0));
}

Eigen::Vector2d PathBank::difference(int slot, const Point& measured) const {
  const Path& path = endless_[at(slot).path];
  const PathPosition seen = path.to_path(within(measured)), expected = place(slot);
  return {path.residual(seen.s_px, expected.s_px), seen.t_px - expected.t_px};
}

Eigen::Matrix2d PathBank::directions(int slot) const {
  const PathPosition now = place(slot);
  const Path& path = path_of(slot);
  const Point along = path.tangent(now.s_px), across = path.normal(now.s_px);
  const double stretch = path.stretch(now);
  Eigen::Matrix2d J;
  J << stretch * along.x, across.x, stretch * along.y, across.y;
  return J;
}

Eigen::Matrix2d PathBank::R(int slot, const Symmetric2& extra_px2) const {
  Eigen::Matrix2d R = Eigen::Vector2d(options_.measurement_variances.data()).asDiagonal();
  if (extra_px2 == Symmetric2{}) return R;
  const Eigen::Matrix2d J = directions(slot);
  const Eigen::Matrix2d S = bank_.innovation_covariance(slot, H_, R);
  const double least = std::max(S.determinant() / S.trace(), 0.0) * std::min(1.0, J.col(0).squaredNorm());
  const double most = largest_ratio * least, largest = std::max(extra_px2.xx, extra_px2.yy);
  const Eigen::Matrix2d back = J.inverse();
  const Eigen::Matrix2d turned = back * matrix_of(extra_px2) * back.transpose();
  return R + 0.5 * std::min(1.0, most / largest) * (turned + turned.transpose());
}

void PathBank::correct(int slot, const Point& measured, const Symmetric2& extra_px2) {
  const Eigen::Vector2d z = bank_.x(slot).head<2>() + difference(slot, measured);
  bank_.correct(slot, z, H_, R(slot, extra_px2));
  settle(slot);
}

Estimate PathBank::estimate(int slot) const {
  const Eigen::Matrix2d J = directions(slot);
  const Eigen::Vector2d velocity = J * bank_.x(slot).tail<2>();
  const auto turned = [&J](const Eigen::Matrix2d& block) -> Eigen::Matrix2d { return J * block * J.transpose(); };
  const auto P = bank_.P(slot);
  const Eigen::Matrix2d C = turned(P.topRightCorner<2, 2>());
  const auto& Q = options_.process_variances;
  const Eigen::Matrix2d noise = turned(Eigen::Vector2d(Q[2], Q[3]).asDiagonal()) / options_.step_time;
  return {path_of(slot).to_image(place(slot)),
          {velocity(0), velocity(1)},
          symmetric_of(turned(P.topLeftCorner<2, 2>())),
          symmetric_of(turned(P.bottomRightCorner<2, 2>())),
          {C(0, 0), C(0, 1), C(1, 0), C(1, 1)},
          symmetric_of(noise)};
}

Point PathBank::innovation(int slot, const Point& measured) const {
  const Eigen::Vector2d off = directions(slot) * difference(slot, measured);
  return {off(0), off(1)};
}

Symmetric2 PathBank::innovation_covariance_px2(int slot, const Symmetric2& extra_px2) const {
  const Eigen::Matrix2d J = directions(slot);
  Eigen::Matrix2d S = bank_.innovation_covariance(slot, H_, R(slot, extra_px2));
  // Turned, what is smaller than this would be lost in the rounding of the larger.
  S.diagonal() = S.diagonal().cwiseMax(least_part * S.diagonal().maxCoeff()).eval();
  S = (J * S * J.transpose()).eval();
  return {S(0, 0), S(0, 1), S(1, 1)};
}

std::optional<PathState> PathBank::path_state(int slot) const {
  const auto x = bank_.x(slot);
  const auto P = bank_.P(slot);
  return PathState{&path_of(slot), at(slot).before, {x(0), x(1)}, {x(2), x(3)}, {P(0, 0), P(0, 1), P(1, 1)}};
}

}  // namespace survtrack
