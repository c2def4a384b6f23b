// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "survtrack/filtering/motion_model.hpp"

#include <gtest/gtest.h>

#include <Eigen/Core>

namespace survtrack {
namespace {

/// Entry of the x axis: derivatives i and j.
template <class Matrix>
double on_x(const Matrix& matrix, int i, int j) {
  return matrix(2 * i, 2 * j);
}

TEST(MotionModel, TransitionOfConstantVelocity) {
  const auto F = ConstantVelocity::transition(0.5);
  Eigen::Vector4d x(1.0, 2.0, 10.0, -4.0);
  EXPECT_TRUE((F * x).isApprox(Eigen::Vector4d(6.0, 0.0, 10.0, -4.0)));
}

TEST(MotionModel, TransitionOfConstantAcceleration) {
  const auto F = ConstantAcceleration::transition(2.0);
  Eigen::Matrix<double, 6, 1> x, expected;
  x << 1.0, 2.0, 3.0, 4.0, 5.0, 6.0;
  expected << 1.0 + 2.0 * 3.0 + 2.0 * 5.0, 2.0 + 2.0 * 4.0 + 2.0 * 6.0, 3.0 + 2.0 * 5.0, 4.0 + 2.0 * 6.0, 5.0, 6.0;
  EXPECT_TRUE((F * x).isApprox(expected));
}

TEST(MotionModel, NoiseOfConstantVelocityByFormula) {
  // Bar-Shalom, Li and Kirubarajan 2001, eq. 6.2.2-4.
  const double T = 0.7;
  const auto Q = ConstantVelocity::unit_noise(T);
  EXPECT_NEAR(on_x(Q, 0, 0), T * T * T / 3.0, 1e-15);
  EXPECT_NEAR(on_x(Q, 0, 1), T * T / 2.0, 1e-15);
  EXPECT_NEAR(on_x(Q, 1, 1), T, 1e-15);
}

TEST(MotionModel, NoiseOfConstantAccelerationByFormula) {
  // Bar-Shalom, Li and Kirubarajan 2001, eq. 6.2.3-4.
  const double T = 1.3;
  const double T2 = T * T, T3 = T2 * T;
  const auto Q = ConstantAcceleration::unit_noise(T);
  EXPECT_NEAR(on_x(Q, 0, 0), T3 * T2 / 20.0, 1e-15);
  EXPECT_NEAR(on_x(Q, 0, 1), T2 * T2 / 8.0, 1e-15);
  EXPECT_NEAR(on_x(Q, 0, 2), T3 / 6.0, 1e-15);
  EXPECT_NEAR(on_x(Q, 1, 1), T3 / 3.0, 1e-15);
  EXPECT_NEAR(on_x(Q, 1, 2), T2 / 2.0, 1e-15);
  EXPECT_NEAR(on_x(Q, 2, 2), T, 1e-15);
}

template <class Model>
void expect_axes_alike_and_apart(double dt) {
  const auto Q = Model::unit_noise(dt);
  const auto F = Model::transition(dt);
  EXPECT_EQ(Q, Q.transpose());
  for (int i = 0; i < Model::state_size; i += 2) {
    for (int j = 0; j < Model::state_size; j += 2) {
      EXPECT_EQ(Q(i, j), Q(i + 1, j + 1));
      EXPECT_EQ(F(i, j), F(i + 1, j + 1));
      EXPECT_EQ(Q(i, j + 1), 0.0);
      EXPECT_EQ(F(i, j + 1), 0.0);
      EXPECT_EQ(F(i + 1, j), 0.0);
    }
  }
}

TEST(MotionModel, AxesAreAlikeAndApart) {
  expect_axes_alike_and_apart<ConstantVelocity>(0.4);
  expect_axes_alike_and_apart<ConstantAcceleration>(0.4);
}

template <class Model>
void expect_two_halves_to_be_one_step(double dt) {
  const auto F = Model::transition(dt / 2.0);
  const auto Q = Model::unit_noise(dt / 2.0);
  EXPECT_TRUE((F * F).isApprox(Model::transition(dt), 1e-14));
  EXPECT_TRUE((F * Q * F.transpose() + Q).isApprox(Model::unit_noise(dt), 1e-14));
}

TEST(MotionModel, TwoHalfStepsAreOneStep) {
  for (const double dt : {1e-3, 0.04, 1.0, 17.0}) {
    expect_two_halves_to_be_one_step<ConstantVelocity>(dt);
    expect_two_halves_to_be_one_step<ConstantAcceleration>(dt);
  }
}

}  // namespace
}  // namespace survtrack
