// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "survtrack/filtering/box_bank.hpp"

#include <gtest/gtest.h>

#include "survtrack/filtering/kalman_filter.hpp"

namespace survtrack {
namespace {

KalmanBoxOptions some_options() {
  KalmanBoxOptions o;
  o.noise_unit = NoiseUnit::px;
  o.velocity_noise = 3.0;
  o.position_noise = 2.0;
  o.initial_velocity = 10.0;
  o.size_rate_noise = 0.5;
  o.size_noise = 4.0;
  o.initial_size_rate = 2.0;
  o.lost_damping_time = 0.0;
  return o;
}

/// Q of white acceleration of this density over 1, for positions i and velocities j.
void set_noise(Eigen::MatrixXd& Q, Eigen::Index i, Eigen::Index j, double density) {
  Q(i, i) = density / 3.0;
  Q(i, j) = Q(j, i) = density / 2.0;
  Q(j, j) = density;
}

TEST(BoxBank, IsOneFilterOfEightStates) {
  const KalmanBoxOptions o = some_options();
  KalmanFilter<>::Model m;
  m.F = Eigen::MatrixXd::Identity(8, 8);
  m.F.topRightCorner(4, 4) = Eigen::MatrixXd::Identity(4, 4);
  m.H = Eigen::MatrixXd::Identity(4, 8);
  m.Q = Eigen::MatrixXd::Zero(8, 8);
  for (Eigen::Index i = 0; i < 4; ++i) set_noise(m.Q, i, i + 4, i < 2 ? 9.0 : 0.25);
  m.R = Eigen::Vector4d(4.0, 4.0, 16.0, 16.0).asDiagonal();
  Eigen::VectorXd x(8), p(8);
  x << 50.0, 60.0, 20.0, 40.0, 0.0, 0.0, 0.0, 0.0;
  p << 4.0, 4.0, 16.0, 16.0, 100.0, 100.0, 4.0, 4.0;
  KalmanFilter<> filter(m, x, Eigen::MatrixXd(p.asDiagonal()));
  BoxBank bank(o);
  bank.add({50.0, 60.0}, 28.0);
  bank.start_size(0, {20.0, 40.0});
  for (int k = 1; k <= 30; ++k) {
    const Eigen::Vector4d z(50.0 + 3.0 * k, 60.0 - k, 20.0 + 0.5 * k, 40.0 + (k % 4));
    filter.predict();
    bank.predict(1.0);
    if (k % 5 != 0) {
      filter.update(z);
      bank.correct(0, {z(0), z(1)});
      bank.correct_size(0, {z(2), z(3)}, {});
    }
    ASSERT_LT((bank.state(0) - filter.x()).cwiseAbs().maxCoeff(), 1e-9) << k;
    ASSERT_LT((bank.state_covariance(0) - filter.P()).cwiseAbs().maxCoeff(), 1e-9) << k;
  }
  EXPECT_NEAR(bank.state(0)(6), 0.5, 0.1);
  EXPECT_EQ(bank.box_size(0)->width_px, bank.state(0)(2));
}

TEST(BoxBank, ASizeThatIsNotSeenStaysBetweenHalfAndTwice) {
  BoxBank bank(some_options());
  bank.add({0.0, 0.0}, 30.0);
  bank.start_size(0, {40.0, 20.0});
  for (int k = 1; k <= 20; ++k) {
    bank.predict(1.0);
    bank.correct(0, {0.0, 0.0});
    bank.correct_size(0, {40.0 - k, 20.0 + 2.0 * k}, {});
  }
  bank.predict(500.0);
  EXPECT_LT(bank.state(0)(2), 0.0);
  EXPECT_EQ(bank.box_size(0)->width_px, 10.0);
  EXPECT_EQ(bank.box_size(0)->height_px, 120.0);
}

TEST(BoxBank, WhatIsLessCertainMovesTheSizeLess) {
  BoxBank plain(some_options()), shared(some_options());
  for (BoxBank* bank : {&plain, &shared}) {
    bank->add({0.0, 0.0}, 30.0);
    bank->start_size(0, {30.0, 30.0});
    bank->predict(1.0);
    bank->correct(0, {0.0, 0.0});
  }
  plain.correct_size(0, {10.0, 30.0}, {});
  shared.correct_size(0, {10.0, 30.0}, {400.0, 0.0});
  EXPECT_LT(plain.state(0)(2), 25.0);
  EXPECT_GT(shared.state(0)(2), 28.0);
}

TEST(BoxBank, RemovingKeepsTheOthersSizes) {
  BoxBank bank(some_options());
  for (int k = 0; k < 3; ++k) {
    bank.add({10.0 * k, 0.0}, 10.0);
    bank.start_size(k, {10.0 + k, 20.0 + k});
  }
  bank.remove(1);
  EXPECT_EQ(bank.box_size(1)->width_px, 12.0);
  EXPECT_EQ(bank.box_size(1)->height_px, 22.0);
}

}  // namespace
}  // namespace survtrack
