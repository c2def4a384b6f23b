// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

// The tracker's filter with given covariances, with the numbers of two works as they are printed.

#include "survtrack/filtering/discrete_bank.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>

#include "survtrack/filtering/discrete_step.hpp"
#include "survtrack/filtering/kalman_filter.hpp"
#include "survtrack/filtering/motion_model.hpp"

namespace survtrack {
namespace {

constexpr double printed = 0.5e-4 + 1e-9;  // four decimals
constexpr double period_s = 0.2685;

/// Nashenda 2011, 5.1, with a time unit of 1 s; the printed R is no covariance.
KalmanDiscreteOptions nashenda(double q) {
  KalmanDiscreteOptions o;
  o.process_variances = {q, q, q, q};
  o.measurement_covariance = {0.2877, 1.1909, 1.1465};
  o.initial_variances = {100.0, 100.0, 100.0, 100.0};
  o.control_input = {0.0, 0.0, 0.0, 8.0};
  o.step_time = period_s;
  o.start = FilterStart::frame_center;
  o.covariances = Covariances::as_published;
  return o;
}

DiscreteBank bank_of(const KalmanDiscreteOptions& options) {
  DiscreteBank bank(options);
  bank.set_frame_size(384, 288);
  return bank;
}

TEST(DiscreteBank, Nashenda2011AsPrinted) {
  DiscreteBank bank = bank_of(nashenda(10.0));
  bank.add({367.0, 274.0}, 30.0);  // the first update
  for (int k = 1; k < 121; ++k) {
    bank.predict(period_s);
    if (k == 120) break;
    bank.correct(0, {367.0, 274.0});
  }
  Eigen::Matrix4d P_minus, P;
  P_minus << 13.3580, 1.6698, 11.6210, 1.1871, 1.6698, 14.5621, 1.1871, 12.4771, 11.6210, 1.1871, 52.7167, 0.9202,
      1.1871 /* misprinted 11.1871 */, 12.4771, 0.9202, 53.3803;
  P << 0.1970, 1.0987, 0.1515, 0.9401, 1.0987, 0.9893, 0.9401, 0.8294, 0.1515, 0.9401, 42.7167, 0.9202, 0.9401, 0.8294,
      0.9202, 43.3803;
  EXPECT_LT((bank.state_covariance(0) - P_minus).cwiseAbs().maxCoeff(), printed);
  const Symmetric2 S = bank.innovation_covariance_px2(0);
  EXPECT_NEAR(S.xx, 13.3580 + 0.2877, printed);
  EXPECT_NEAR(S.xy, 1.6698 + 1.1909, printed);
  bank.correct(0, {367.0, 274.0});
  EXPECT_LT((bank.state_covariance(0) - P).cwiseAbs().maxCoeff(), printed);
}

TEST(DiscreteBank, OfQ50AsPrinted) {
  DiscreteBank bank = bank_of(nashenda(50.0));
  bank.add({367.0, 274.0}, 30.0);
  for (int k = 1; k < 121; ++k) {
    bank.predict(period_s);
    if (k < 120) bank.correct(0, {367.0, 274.0});
  }
  const Eigen::MatrixXd P = bank.state_covariance(0);
  EXPECT_NEAR(P(0, 0), 65.7521, printed);
  EXPECT_NEAR(P(0, 2), 57.4486, printed);
  EXPECT_NEAR(P(3, 3), 263.8365, printed);
}

/// The control input and the start at the frame's centre too: state by state the general filter's.
TEST(DiscreteBank, IsTheGeneralFilterWithTheSameMatrices) {
  using Filter = KalmanFilter<4, 2>;
  Filter::Model m;
  m.F = ConstantVelocity::transition(period_s);
  m.H = Eigen::MatrixXd::Identity(2, 4);
  m.Q = 1.0 * Eigen::Matrix4d::Identity();
  m.R << 0.2877, 1.1909, 1.1909, 1.1465;
  m.B = Eigen::Vector4d(0.0, 0.0, 0.0, 8.0);
  Filter filter(m, {192.0, 144.0, 0.0, 0.0}, 100.0 * Eigen::Matrix4d::Identity(), Covariances::as_published);
  DiscreteBank bank = bank_of(nashenda(1.0));
  for (int k = 0; k < 40; ++k) {
    const Point measured{100.0 + 3.0 * k, 200.0 - k + (k % 3)};
    filter.predict(Eigen::VectorXd::Ones(1));
    filter.update({measured.x, measured.y});
    if (k == 0) {
      bank.add(measured, 30.0);
    } else {
      bank.predict(period_s);
      bank.correct(0, measured);
    }
    ASSERT_LT((bank.state(0) - filter.x()).cwiseAbs().maxCoeff(), 1e-6) << k;
    ASSERT_LT((bank.state_covariance(0) - filter.P()).cwiseAbs().maxCoeff(), 1e-6) << k;
  }
}

TEST(DiscreteBank, OMalley2000AsPrinted) {
  KalmanDiscreteOptions o;
  o.process_variances = {0.01, 0.1, 0.01, 0.1};
  o.measurement_covariance = {0.0001, 0.0, 2.0};
  o.initial_variances = {1.0, 1.0, 1.0, 1.0};
  o.step_time = 1.0 / 15.0;
  DiscreteBank bank(o);
  bank.add({2.0, 1.83}, 30.0);
  for (int k = 0; k < 500; ++k) {
    bank.predict(1.0 / 15.0);
    if (k < 499) bank.correct(0, {2.0, 1.83});
  }
  const double variance = bank.estimate(0).covariance_px2.xx;
  EXPECT_NEAR(3.0 * std::sqrt(variance), 0.31, 0.005);
  EXPECT_NEAR(variance / bank.innovation_covariance_px2(0).xx, 0.99, 0.005);  // the gain in S
}

TEST(DiscreteStep, OnTimeIsTheStepAsGiven) {
  const DiscreteStep step = discrete_step({1.0, 2.0, 3.0, 4.0}, {5.0, 6.0, 7.0, 8.0}, 0.5, 0.5);
  EXPECT_EQ(step.Q, Eigen::Matrix4d(Eigen::Vector4d(1.0, 2.0, 3.0, 4.0).asDiagonal()));
  EXPECT_EQ(step.Bu, Eigen::Vector4d(5.0, 6.0, 7.0, 8.0));
  EXPECT_EQ(step.F(0, 2), 0.5);
  EXPECT_EQ(step.F(1, 3), 0.5);
}

TEST(DiscreteStep, AfterMissingFramesItIsAsManySteps) {
  const std::array<double, 4> q{1.0, 2.0, 3.0, 4.0}, u{0.5, -0.25, 7.0, 8.0};
  const DiscreteStep one = discrete_step(q, u, 0.3, 0.3);
  Eigen::Matrix4d P = Eigen::Vector4d(9.0, 8.0, 7.0, 6.0).asDiagonal();
  const Eigen::Matrix4d P0 = P;
  const Eigen::Vector4d x0(1.0, 2.0, 3.0, 4.0);
  Eigen::Vector4d x = x0;
  for (int n = 1; n <= 6; ++n) {
    x = (one.F * x + one.Bu).eval();
    P = (one.F * P * one.F.transpose() + one.Q).eval();
    const DiscreteStep all = discrete_step(q, u, 0.3, 0.3 * n);
    EXPECT_TRUE((all.F * x0 + all.Bu).isApprox(x, 1e-12)) << n;
    EXPECT_TRUE((all.F * P0 * all.F.transpose() + all.Q).isApprox(P, 1e-12)) << n;
  }
}

TEST(DiscreteStep, AShorterStepAddsLessInProportion) {
  const DiscreteStep step = discrete_step({1.0, 2.0, 4.0, 8.0}, {1.0, 1.0, 1.0, 1.0}, 1.0, 0.25);
  EXPECT_EQ(step.Q, Eigen::Matrix4d(Eigen::Vector4d(0.25, 0.5, 1.0, 2.0).asDiagonal()));
  EXPECT_EQ(step.Bu, Eigen::Vector4d::Constant(0.25));
  // 1.4 steps are one that is longer, 1.6 two that are shorter: no Q is lost between.
  for (const double dt : {1.4, 1.6, 7.3}) EXPECT_NEAR(discrete_step({1.0, 1.0, 0.0, 0.0}, {}, 1.0, dt).Q(0, 0), dt, 1e-12);
}

TEST(DiscreteBank, OneThatDivergesStartsAnew) {
  KalmanDiscreteOptions o;
  o.covariances = Covariances::as_published;
  o.process_variances = o.initial_variances = {};
  o.measurement_covariance = {};  // S is zero
  DiscreteBank bank(o);
  bank.add({3.0, 4.0}, 10.0);
  for (int k = 0; k < 5; ++k) {
    bank.predict(1.0);
    bank.correct(0, {5.0 + k, 8.0});
    ASSERT_TRUE(bank.state(0).allFinite() && bank.state_covariance(0).allFinite());
    EXPECT_EQ(bank.estimate(0).position, (Point{5.0 + k, 8.0}));
  }
}

TEST(DiscreteBank, TheFramesCentreHasToBeKnown) {
  const DiscreteBank centre(nashenda(1.0)), detection(KalmanDiscreteOptions{});
  EXPECT_THROW(centre.check_frame_size(0, 0), InputError);
  EXPECT_NO_THROW(centre.check_frame_size(384, 288));
  EXPECT_NO_THROW(detection.check_frame_size(0, 0));
}

}  // namespace
}  // namespace survtrack
