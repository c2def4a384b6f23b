// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "survtrack/filtering/box_bank.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace survtrack {
namespace {

constexpr double least_part = 0.5, most_part = 2.0;  // of the side last measured

double side(double believed, double measured) {
  return std::clamp(believed, least_part * measured, most_part * measured);
}

KalmanCvOptions center_options(const KalmanBoxOptions& o) {
  KalmanCvOptions cv;
  cv.noise_unit = o.noise_unit;
  cv.velocity_noise = o.velocity_noise;
  cv.position_noise = o.position_noise;
  cv.initial_velocity = o.initial_velocity;
  cv.lost_damping_time = o.lost_damping_time;
  return cv;
}

KalmanCvOptions size_options(const KalmanBoxOptions& o) {
  KalmanCvOptions cv = center_options(o);
  cv.velocity_noise = o.size_rate_noise;
  cv.position_noise = o.size_noise;
  cv.initial_velocity = o.initial_size_rate;
  return cv;
}

std::size_t at(int slot) { return static_cast<std::size_t>(slot); }

}  // namespace

BoxBank::BoxBank(const KalmanBoxOptions& options)
    : center_(make_filter_bank(center_options(options))), size_(make_filter_bank(size_options(options))) {}

int BoxBank::add(const Point& position, double object_size_px) {
  size_->add({object_size_px, object_size_px}, object_size_px);
  measured_.push_back({object_size_px, object_size_px});
  return center_->add(position, object_size_px);
}

void BoxBank::restart(int slot, const Point& position, double object_size_px) {
  center_->restart(slot, position, object_size_px);
  start_size(slot, {object_size_px, object_size_px});
}

void BoxBank::remove(int slot) {
  center_->remove(slot);
  size_->remove(slot);
  measured_.erase(measured_.begin() + slot);
}

void BoxBank::clear() {
  center_->clear();
  size_->clear();
  measured_.clear();
}

void BoxBank::predict(double dt) {
  center_->predict(dt);
  size_->predict(dt);
}

void BoxBank::set_object_size(int slot, double object_size_px) {
  center_->set_object_size(slot, object_size_px);
  size_->set_object_size(slot, object_size_px);
}

void BoxBank::start_size(int slot, const BoxSize& measured) {
  size_->restart(slot, {measured.width_px, measured.height_px}, std::sqrt(measured.width_px * measured.height_px));
  measured_[at(slot)] = measured;
}

void BoxBank::correct_size(int slot, const BoxSize& measured, const BoxSize& extra_px2) {
  size_->correct(slot, {measured.width_px, measured.height_px}, {extra_px2.width_px, 0.0, extra_px2.height_px});
  measured_[at(slot)] = measured;
}

std::optional<BoxSize> BoxBank::box_size(int slot) const {
  const Point believed = size_->estimate(slot).position;
  const BoxSize& measured = measured_[at(slot)];
  return BoxSize{side(believed.x, measured.width_px), side(believed.y, measured.height_px)};
}

Eigen::VectorXd BoxBank::state(int slot) const {
  const Eigen::VectorXd center = center_->state(slot), size = size_->state(slot);
  Eigen::VectorXd x(8);
  x << center.head(2), size.head(2), center.tail(2), size.tail(2);
  return x;
}

Eigen::MatrixXd BoxBank::state_covariance(int slot) const {
  const Eigen::MatrixXd center = center_->state_covariance(slot), size = size_->state_covariance(slot);
  Eigen::MatrixXd P = Eigen::MatrixXd::Zero(8, 8);
  for (Eigen::Index i = 0; i < 2; ++i) {
    for (Eigen::Index j = 0; j < 2; ++j) {
      P.block<2, 2>(4 * i, 4 * j) = center.block<2, 2>(2 * i, 2 * j);
      P.block<2, 2>(4 * i + 2, 4 * j + 2) = size.block<2, 2>(2 * i, 2 * j);
    }
  }
  return P;
}

}  // namespace survtrack
