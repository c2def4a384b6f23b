// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "survtrack/filtering/kalman_filter.hpp"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>
#include <limits>

#include "../error_message.hpp"
#include "survtrack/core/errors.hpp"
#include "survtrack/filtering/chi_square.hpp"
#include "survtrack/filtering/motion_model.hpp"
#include "survtrack/filtering/white_noise.hpp"

namespace survtrack {
namespace {

using Fixed = KalmanFilter<4, 2>;

/// Constant velocity over dt, positions measured.
template <class Filter>
typename Filter::Model model(double dt, const Eigen::Matrix2d& R, const Eigen::Matrix4d& Q) {
  typename Filter::Model m;
  m.F = ConstantVelocity::transition(dt);
  m.H = Eigen::MatrixXd::Identity(2, 4);
  m.Q = Q;
  m.R = R;
  return m;
}

TEST(KalmanFilter, OneStepWorkedByHand) {
  // Per axis: P = diag(1, 4), R = 1, Q of unit density, dt = 1, z = 2 in x and 0 in y.
  Fixed filter(model<Fixed>(1.0, Eigen::Matrix2d::Identity(), ConstantVelocity::unit_noise(1.0)), Fixed::State::Zero(),
               Eigen::Vector4d(1.0, 1.0, 4.0, 4.0).asDiagonal().toDenseMatrix());
  filter.predict();
  EXPECT_NEAR(filter.P()(0, 0), 16.0 / 3.0, 1e-14);
  EXPECT_NEAR(filter.squared_mahalanobis({2.0, 0.0}), 4.0 / (19.0 / 3.0), 1e-14);
  filter.update({2.0, 0.0});
  EXPECT_NEAR(filter.x()(0), 32.0 / 19.0, 1e-14);
  EXPECT_NEAR(filter.x()(2), 27.0 / 19.0, 1e-14);
  EXPECT_NEAR(filter.P()(0, 2), 13.5 / 19.0, 1e-14);
  EXPECT_NEAR(filter.P()(2, 2), 34.25 / 19.0, 1e-14);
  EXPECT_NEAR(filter.last().y(0), 2.0, 1e-14);
  EXPECT_NEAR(filter.last().S(0, 0), 19.0 / 3.0, 1e-14);
  EXPECT_NEAR(filter.last().K(0, 0), 16.0 / 19.0, 1e-14);
  EXPECT_NEAR(filter.last().nis, 12.0 / 19.0, 1e-14);
  const double two_pi = 6.283185307179586;
  EXPECT_NEAR(filter.last().log_likelihood(), -0.5 * 12.0 / 19.0 - std::log(two_pi * 19.0 / 3.0), 1e-13);
}

TEST(KalmanFilter, FixedAndDynamicSizesAreTheSameFilter) {
  Eigen::Matrix2d R;
  R << 4.0, 1.0, 1.0, 3.0;
  const Eigen::Matrix4d Q = 0.3 * ConstantVelocity::unit_noise(0.5);
  Fixed fixed(model<Fixed>(0.5, R, Q), Fixed::State::Zero(), 9.0 * Fixed::StateMatrix::Identity());
  KalmanFilter<> dynamic(model<KalmanFilter<>>(0.5, R, Q), Eigen::VectorXd::Zero(4), 9.0 * Eigen::MatrixXd::Identity(4, 4));
  for (int k = 0; k < 200; ++k) {
    const Eigen::Vector2d z(3.0 * k + (k * 7) % 5, -k + (k * 3) % 4);
    fixed.predict();
    dynamic.predict();
    ASSERT_NEAR(fixed.squared_mahalanobis(z), dynamic.squared_mahalanobis(z), 1e-9);
    fixed.update(z);
    dynamic.update(z);
    ASSERT_TRUE(fixed.x().isApprox(dynamic.x(), 1e-12));
    ASSERT_TRUE(fixed.P().isApprox(dynamic.P(), 1e-12));
    ASSERT_EQ(fixed.P(), fixed.P().transpose());
  }
}

TEST(KalmanFilter, ControlInputMovesTheState) {
  auto m = model<Fixed>(0.5, Eigen::Matrix2d::Identity(), Eigen::Matrix4d::Zero());
  m.B = Eigen::MatrixXd::Zero(4, 1);
  m.B(0) = 0.125;
  m.B(2) = 0.5;
  Fixed filter(m, {1.0, 2.0, 10.0, 0.0}, Fixed::StateMatrix::Identity());
  filter.predict(Eigen::VectorXd::Constant(1, 8.0));
  EXPECT_EQ(filter.x(), Eigen::Vector4d(1.0 + 5.0 + 1.0, 2.0, 14.0, 0.0));
  EXPECT_THROW(filter.predict(Eigen::VectorXd::Zero(2)), InputError);
}

TEST(KalmanFilter, ResidualWrapsMeasurements) {
  // A closed path of length 10: from 9.5 to 0.5 is 1 onwards, not 9 back.
  KalmanFilter<1, 1>::Model m;
  m.F << 1.0;
  m.H << 1.0;
  m.Q << 0.0;
  m.R << 1.0;
  m.residual = [](const Eigen::VectorXd& z, const Eigen::VectorXd& predicted) {
    return Eigen::VectorXd::Constant(1, wrapped_difference(z(0) - predicted(0), 10.0)).eval();
  };
  using One = Eigen::Matrix<double, 1, 1>;
  KalmanFilter<1, 1> filter(m, One(9.5), One(1.0));
  filter.update(One(0.5));
  EXPECT_DOUBLE_EQ(filter.last().y(0), 1.0);
  EXPECT_DOUBLE_EQ(filter.x()(0), 10.0);
}

TEST(KalmanFilter, SaysWhatIsWrong) {
  const Eigen::Matrix2d I = Eigen::Matrix2d::Identity();
  const Eigen::Matrix4d Q = Eigen::Matrix4d::Zero();
  Eigen::Matrix2d R;
  R << 0.2877, 1.1909, 1.1909, 1.1465;
  const auto make = [&](const Eigen::Matrix2d& noise) { return Fixed(model<Fixed>(1.0, noise, Q), Fixed::State::Zero(), Q); };
  EXPECT_TRUE(contains(message_of<InputError>([&] { make(R); }), "R: is not positive semi-definite", "-0.548849"));
  R(0, 1) = 0.1;
  EXPECT_TRUE(contains(message_of<InputError>([&] { make(R); }), "R: is not symmetric", "1.1909"));
  Fixed filter = make(I);
  EXPECT_TRUE(contains(message_of<InputError>([&] { filter.set_P(-Eigen::Matrix4d::Identity()); }), "P: ", "is -1"));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(contains(message_of<InputError>([&] { filter.update({1.0, nan}); }), "z[1]: is nan"));
  filter.set_R(Eigen::Matrix2d::Zero());  // with P = 0: S = 0
  EXPECT_TRUE(contains(message_of<InputError>([&] { filter.update({1.0, 2.0}); }), "S: ", "singular"));
  EXPECT_EQ(filter.x(), Fixed::State::Zero());
  EXPECT_TRUE(contains(message_of<InputError>([&] { filter.set_F(1e300 * Eigen::Matrix4d::Identity()), filter.set_x(Eigen::Vector4d::Constant(1e300)), filter.predict(); }), "predict: ", "finite"));
  const auto wide = model<KalmanFilter<>>(1.0, I, Q);
  EXPECT_TRUE(contains(message_of<InputError>([&] { KalmanFilter<>(wide, Eigen::VectorXd::Zero(3), Eigen::MatrixXd::Zero(3, 3)); }),
                       "F: is 4x4; expected 3x3"));
}

TEST(WhiteNoise, TextbookForms) {
  const double dt = 0.5;
  Eigen::Matrix2d two;
  two << dt * dt * dt * dt / 4, dt * dt * dt / 2, dt * dt * dt / 2, dt * dt;
  EXPECT_TRUE(discrete_white_noise(2, dt, 3.0).isApprox(3.0 * two, 1e-15));
  EXPECT_TRUE(continuous_white_noise(2, dt, 1.0, 2, StateOrder::by_derivative).isApprox(ConstantVelocity::unit_noise(dt), 1e-15));
  EXPECT_TRUE(
      continuous_white_noise(3, dt, 1.0, 2, StateOrder::by_derivative).isApprox(ConstantAcceleration::unit_noise(dt), 1e-15));
  for (const double bad : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
    EXPECT_TRUE(contains(message_of<InputError>([&] { discrete_white_noise(2, bad); }), "dt: is "));
  }
  EXPECT_THROW(discrete_white_noise(5, 1.0), InputError);
  EXPECT_THROW(continuous_white_noise(2, 1.0, -1.0), InputError);
}

TEST(ChiSquare, TabulatedQuantiles) {
  EXPECT_NEAR(chi_square_quantile(0.95, 1), 3.841, 5e-4);
  EXPECT_NEAR(chi_square_quantile(0.95, 2), -2.0 * std::log(0.05), 1e-12);
  EXPECT_NEAR(chi_square_quantile(0.99, 4), 13.277, 5e-4);
  EXPECT_NEAR(nis_band(2, 50).first, 74.222 / 50, 1e-4);  // chi-square of 100: 74.222 and 129.561
  EXPECT_NEAR(nis_band(2, 50).second, 129.561 / 50, 1e-4);
  EXPECT_THROW(chi_square_quantile(1.0, 2), InputError);
  EXPECT_THROW(chi_square_quantile(0.5, 0), InputError);
}

}  // namespace
}  // namespace survtrack
