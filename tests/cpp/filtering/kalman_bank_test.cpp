// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "survtrack/filtering/kalman_bank.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <random>

#include "survtrack/filtering/motion_model.hpp"

namespace survtrack {
namespace {

using Bank = KalmanBank<4, 2>;

Bank::MeasurementMatrix position_of_state() {
  Bank::MeasurementMatrix H = Bank::MeasurementMatrix::Zero();
  H(0, 0) = H(1, 1) = 1.0;
  return H;
}

TEST(KalmanBank, OneStepWorkedByHand) {
  // Per axis: P = diag(1, 4), R = 1, Q of unit density, dt = 1, z = 2 in x and 0 in y.
  Bank bank;
  bank.add(Bank::State::Zero(), Eigen::Vector4d(1.0, 1.0, 4.0, 4.0).asDiagonal());
  bank.predict(0, ConstantVelocity::transition(1.0), ConstantVelocity::unit_noise(1.0));
  EXPECT_NEAR(bank.P(0)(0, 0), 16.0 / 3.0, 1e-14);
  EXPECT_NEAR(bank.P(0)(0, 2), 4.5, 1e-14);
  EXPECT_NEAR(bank.P(0)(2, 2), 5.0, 1e-14);
  const auto R = Eigen::Matrix2d::Identity();
  EXPECT_NEAR(bank.innovation_covariance(0, position_of_state(), R)(0, 0), 19.0 / 3.0, 1e-14);
  bank.correct(0, {2.0, 0.0}, position_of_state(), R);
  EXPECT_NEAR(bank.x(0)(0), 32.0 / 19.0, 1e-14);
  EXPECT_NEAR(bank.x(0)(1), 0.0, 1e-14);
  EXPECT_NEAR(bank.x(0)(2), 27.0 / 19.0, 1e-14);
  EXPECT_NEAR(bank.P(0)(0, 0), 16.0 / 19.0, 1e-14);
  EXPECT_NEAR(bank.P(0)(0, 2), 13.5 / 19.0, 1e-14);
  EXPECT_NEAR(bank.P(0)(2, 2), 34.25 / 19.0, 1e-14);
  EXPECT_NEAR(bank.P(0)(0, 1), 0.0, 1e-14);
}

/// The textbook's filter in plain matrices, P = P - K S K'.
struct PlainFilter {
  Eigen::VectorXd x;
  Eigen::MatrixXd P;

  void predict(const Eigen::MatrixXd& F, const Eigen::MatrixXd& Q) {
    x = F * x;
    P = F * P * F.transpose() + Q;
  }
  void correct(const Eigen::VectorXd& z, const Eigen::MatrixXd& H, const Eigen::MatrixXd& R) {
    const Eigen::MatrixXd S = H * P * H.transpose() + R;
    const Eigen::MatrixXd K = S.ldlt().solve(H * P).transpose();
    x += K * (z - H * x);
    P -= K * S * K.transpose();
  }
};

TEST(KalmanBank, AgreesWithAPlainFilterOverARandomRun) {
  std::mt19937 random(3);
  std::normal_distribution<double> noise(0.0, 2.0);
  std::uniform_real_distribution<double> step(0.01, 2.0);
  Bank bank;
  PlainFilter plain{Eigen::Vector4d(5.0, -3.0, 0.0, 0.0), Eigen::Vector4d(4.0, 4.0, 9.0, 9.0).asDiagonal()};
  bank.add(plain.x, plain.P);
  const Bank::MeasurementMatrix H = position_of_state();
  Eigen::Matrix2d R;
  R << 4.0, 1.0, 1.0, 3.0;
  double time = 0.0;
  for (int i = 0; i < 500; ++i) {
    const double dt = step(random);
    time += dt;
    const auto F = ConstantVelocity::transition(dt);
    const ConstantVelocity::Matrix Q = 0.3 * ConstantVelocity::unit_noise(dt);
    bank.predict(0, F, Q);
    plain.predict(F, Q);
    if (i % 4 == 3) continue;  // a missing measurement
    const Eigen::Vector2d z(5.0 + 3.0 * time + noise(random), -3.0 - time + noise(random));
    bank.correct(0, z, H, R);
    plain.correct(z, H, R);
    ASSERT_TRUE(bank.x(0).isApprox(plain.x, 1e-10)) << "step " << i;
    ASSERT_TRUE(bank.P(0).isApprox(plain.P, 1e-9)) << "step " << i;
  }
}

TEST(KalmanBank, PredictTwiceHalfIsOnceTheWhole) {
  Bank::Covariance P;
  P << 4.0, 0.5, 1.0, 0.2, 0.5, 3.0, 0.1, 0.8, 1.0, 0.1, 2.0, 0.3, 0.2, 0.8, 0.3, 1.5;
  const Bank::State x(100.0, 50.0, -7.0, 3.0);
  Bank whole, halves;
  whole.add(x, P);
  halves.add(x, P);
  for (const double dt : {0.04, 0.7, 3.0}) {
    whole.predict(0, ConstantVelocity::transition(dt), 2.5 * ConstantVelocity::unit_noise(dt));
    for (int half = 0; half < 2; ++half) {
      halves.predict(0, ConstantVelocity::transition(dt / 2), 2.5 * ConstantVelocity::unit_noise(dt / 2));
    }
    EXPECT_TRUE(halves.x(0).isApprox(whole.x(0), 1e-12));
    EXPECT_TRUE(halves.P(0).isApprox(whole.P(0), 1e-12));
  }
}

TEST(KalmanBank, SlotsKeepTheirOrderAfterARemoval) {
  Bank bank;
  for (int i = 0; i < 4; ++i) {
    EXPECT_EQ(bank.add(Bank::State::Constant(i), (i + 1.0) * Bank::Covariance::Identity()), i);
  }
  bank.remove(1);
  ASSERT_EQ(bank.size(), 3);
  for (const auto& [slot, was] : {std::pair{0, 0}, std::pair{1, 2}, std::pair{2, 3}}) {
    EXPECT_EQ(bank.x(slot)(3), was);
    EXPECT_EQ(bank.P(slot)(3, 3), was + 1.0);
  }
  bank.remove(2);
  bank.remove(0);
  ASSERT_EQ(bank.size(), 1);
  EXPECT_EQ(bank.x(0)(0), 2.0);
  bank.clear();
  EXPECT_EQ(bank.size(), 0);
}

}  // namespace
}  // namespace survtrack
