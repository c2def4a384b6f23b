// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "survtrack/filtering/discrete_bank.hpp"

#include <cmath>
#include <sstream>

#include "filtering/estimate_of.hpp"
#include "survtrack/core/errors.hpp"
#include "survtrack/filtering/discrete_step.hpp"

namespace survtrack {
namespace {

constexpr double most = 1e100;  // its square, as in a determinant, is still a double

}  // namespace

void check_measurement_covariance(const KalmanDiscreteOptions& options, const std::string& path) {
  if (options.covariances == Covariances::as_published) return;
  const auto& [xx, xy, yy] = options.measurement_covariance;
  // Two axes that say the same but for rounding measure one of them exactly.
  constexpr double least_share = 1e-6;
  const bool definite = xx >= 1e-12 && yy >= 1e-12 && (xy / xx) * (xy / yy) <= 1.0 - least_share;
  if (definite) return;
  const double mean = 0.5 * (xx + yy), smallest = mean - std::hypot(0.5 * (xx - yy), xy);
  std::ostringstream text;
  text << path << ".measurement_covariance: [[" << xx << ", " << xy << "], [" << xy << ", " << yy
       << "]] is not allowed, its smallest eigenvalue is " << smallest
       << "; expected a covariance with both above 0, or " << path << ".covariances as_published";
  throw ConfigError(text.str());
}

DiscreteBank::DiscreteBank(const KalmanDiscreteOptions& options) : options_(options) {}

int DiscreteBank::add(const Point& position, double object_size_px) {
  const int slot = bank_.add(Bank::State::Zero(), Bank::Covariance::Zero());
  restart(slot, position, object_size_px);
  return slot;
}

void DiscreteBank::restart(int slot, const Point& position, double) {
  if (options_.start == FilterStart::detection) {
    start_at(slot, position);
    return;
  }
  start_at(slot, frame_center_);
  move(slot, discrete_step(options_.process_variances, options_.control_input, options_.step_time, options_.step_time));
  correct(slot, position);
}

void DiscreteBank::start_at(int slot, const Point& position) {
  bank_.x(slot) << position.x, position.y, 0.0, 0.0;
  bank_.P(slot) = Eigen::Vector4d(options_.initial_variances.data()).asDiagonal();
}

bool DiscreteBank::in_range(int slot) const {
  // What is not a number is not below.
  return (bank_.x(slot).array().abs() < most).all() && (bank_.P(slot).array().abs() < most).all();
}

void DiscreteBank::predict(double dt) {
  const DiscreteStep step = discrete_step(options_.process_variances, options_.control_input, options_.step_time, dt);
  for (int slot = 0; slot < bank_.size(); ++slot) move(slot, step);
}

void DiscreteBank::move(int slot, const DiscreteStep& step) {
  const Point before{bank_.x(slot)(0), bank_.x(slot)(1)};
  bank_.predict(slot, step.F, step.Q);
  bank_.x(slot) += step.Bu;
  if (!in_range(slot)) start_at(slot, before);
}

void DiscreteBank::correct(int slot, const Point& measured, const Symmetric2& extra_px2) {
  bank_.correct(slot, Eigen::Vector2d(measured.x, measured.y), H_, R(extra_px2));
  if (!in_range(slot)) start_at(slot, measured);
}

void DiscreteBank::check_frame_size(int width, int height) const {
  if (options_.start != FilterStart::frame_center || (width > 0 && height > 0)) return;
  throw InputError("frame: its size is not known, and filter.start is \"frame_center\"; expected detections with the size "
                   "of their frame, or filter.start detection");
}

void DiscreteBank::set_frame_size(int width, int height) { frame_center_ = {0.5 * width, 0.5 * height}; }

Estimate DiscreteBank::estimate(int slot) const {
  const auto& Q = options_.process_variances;
  return estimate_of(bank_.x(slot), bank_.P(slot), {Q[2] / options_.step_time, 0.0, Q[3] / options_.step_time});
}

Symmetric2 DiscreteBank::innovation_covariance_px2(int slot, const Symmetric2& extra_px2) const {
  const Eigen::Matrix2d S = bank_.innovation_covariance(slot, H_, R(extra_px2));
  return {S(0, 0), S(0, 1), S(1, 1)};
}

Eigen::Matrix2d DiscreteBank::R(const Symmetric2& extra_px2) const {
  const auto& [xx, xy, yy] = options_.measurement_covariance;
  Eigen::Matrix2d R;
  R << xx + extra_px2.xx, xy + extra_px2.xy, xy + extra_px2.xy, yy + extra_px2.yy;
  return R;
}

}  // namespace survtrack
