// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "filtering/turn_motion.hpp"

#include <cmath>

#include "survtrack/filtering/motion_model.hpp"

namespace survtrack {
namespace {

using Complex = std::complex<double>;

/// (e^z - 1) / z and its derivative.
struct Mean {
  Complex value, slope;
};

Mean mean_of_exponential(const Complex& z) {
  if (std::norm(z) >= 0.25) {
    const Complex e = std::exp(z), value = (e - 1.0) / z;
    return {value, (e - value) / z};
  }
  // Near 0 the differences have no digits left: the sums of z^k / (k + 1)! and of their derivatives, by Horner.
  Mean sum{1.0 / 20922789888000.0, 0.0};  // 1 / 16!
  double factorial = 20922789888000.0;
  for (int k = 14; k >= 0; --k) {
    factorial /= k + 2;
    sum.slope = sum.slope * z + sum.value;
    sum.value = sum.value * z + 1.0 / factorial;
  }
  return sum;
}

/// The 2x2 matrix that multiplies complex numbers, written as vectors, by c.
Eigen::Matrix2d product_matrix(const Complex& c) {
  Eigen::Matrix2d matrix;
  matrix << c.real(), -c.imag(), c.imag(), c.real();
  return matrix;
}

}  // namespace

Eigen::Matrix2d TurnNoise::R(double length, const Symmetric2& extra_px2) const {
  const double deviation = position * length, variance = deviation * deviation;
  Eigen::Matrix2d R;
  R << variance + extra_px2.xx, extra_px2.xy, extra_px2.xy, variance + extra_px2.yy;
  return R;
}

TurnMotion::TurnMotion(const TurnNoise& noise, double dt, bool lost)
    : dt_(dt),
      decay_(lost && noise.lost_damping_time > 0.0 ? 1.0 / noise.lost_damping_time : 0.0),
      mean_turn_(-std::expm1(-dt / noise.turn_time) * noise.turn_time / dt),
      turn_kept_(std::exp(-dt / noise.turn_time)),
      turn_variance_(-std::expm1(-2.0 * dt / noise.turn_time) * noise.turn_rate * noise.turn_rate),
      velocity_density_(noise.velocity * noise.velocity) {}

TurnMotion::State TurnMotion::moved(const State& x) const {
  const Complex z = exponent(x(4)), v(x(2), x(3));
  const Complex way = v * dt_ * mean_of_exponential(z).value, turned = v * std::exp(z);
  State next;
  next << x(0) + way.real(), x(1) + way.imag(), turned.real(), turned.imag(), turn_kept_ * x(4);
  return next;
}

TurnMotion::LinearMatrix TurnMotion::transition(double turn_rate) const {
  const Complex z = exponent(turn_rate);
  LinearMatrix F = LinearMatrix::Identity();
  F.block<2, 2>(0, 2) = product_matrix(dt_ * mean_of_exponential(z).value);
  F.block<2, 2>(2, 2) = product_matrix(std::exp(z));
  return F;
}

TurnMotion::Matrix TurnMotion::jacobian(const State& x) const {
  const Complex z = exponent(x(4)), v(x(2), x(3)), e = std::exp(z), z_by_turn(0.0, mean_turn_ * dt_);
  const Mean mean = mean_of_exponential(z);
  const Complex way = v * dt_ * mean.slope * z_by_turn, turned = v * e * z_by_turn;
  Matrix F = Matrix::Identity();
  F.block<2, 2>(0, 2) = product_matrix(dt_ * mean.value);
  F.block<2, 2>(2, 2) = product_matrix(e);
  F.col(4) << way.real(), way.imag(), turned.real(), turned.imag(), turn_kept_;
  return F;
}

TurnMotion::Matrix TurnMotion::noise(double length) const {
  Matrix Q = Matrix::Zero();
  Q.topLeftCorner<4, 4>() = velocity_density_ * length * length * ConstantVelocity::unit_noise(dt_);
  Q(4, 4) = turn_variance_;
  return Q;
}

TurnMotion::State turn_start(const Point& position) {
  TurnMotion::State x = TurnMotion::State::Zero();
  x.head<2>() << position.x, position.y;
  return x;
}

TurnMotion::Matrix turn_start_covariance(const TurnNoise& noise, double length) {
  const double p = noise.position * length, v = noise.initial_velocity * length, w = noise.turn_rate;
  TurnMotion::State deviation;
  deviation << p, p, v, v, w;
  return deviation.array().square().matrix().asDiagonal();
}

}  // namespace survtrack
