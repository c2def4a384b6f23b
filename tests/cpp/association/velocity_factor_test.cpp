// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "survtrack/association/velocity_factor.hpp"

#include <gtest/gtest.h>

namespace survtrack {
namespace {

constexpr double break_point = 12.0;

TEST(VelocityFactor, OfABeliefFallsFrom2To02) {
  // Narayana 2007, fig. 8.6.
  EXPECT_DOUBLE_EQ(falling_velocity_factor(0.0, break_point), 2.0);
  EXPECT_DOUBLE_EQ(falling_velocity_factor(6.0, break_point), 1.1);
  EXPECT_DOUBLE_EQ(falling_velocity_factor(12.0, break_point), 0.2);
}

TEST(VelocityFactor, OfAMatchMatrixRisesFrom05To5) {
  // Fig. 4.12.
  EXPECT_DOUBLE_EQ(velocity_factor(0.0, break_point), 0.5);
  EXPECT_DOUBLE_EQ(velocity_factor(6.0, break_point), 1.0 / 1.1);
  EXPECT_DOUBLE_EQ(velocity_factor(12.0, break_point), 5.0);
}

TEST(VelocityFactor, IsLinearBeforeTheBreakPoint) {
  for (double difference = 0.0; difference < break_point; difference += 0.5) {
    EXPECT_NEAR(falling_velocity_factor(difference, break_point), 2.0 - 0.15 * difference, 1e-15);
    EXPECT_NEAR(velocity_factor(difference, break_point) * falling_velocity_factor(difference, break_point), 1.0, 1e-15);
  }
}

TEST(VelocityFactor, IsConstantBeyondTheBreakPoint) {
  for (const double difference : {12.0, 12.5, 100.0, 1e300}) {
    EXPECT_DOUBLE_EQ(falling_velocity_factor(difference, break_point), 0.2);
    EXPECT_DOUBLE_EQ(velocity_factor(difference, break_point), 5.0);
  }
}

TEST(VelocityFactor, TheBreakPointIsAScale) {
  for (const double difference : {0.0, 1.0, 3.0, 50.0}) {
    EXPECT_DOUBLE_EQ(velocity_factor(difference, 7.0), velocity_factor(2.0 * difference, 14.0));
  }
}

}  // namespace
}  // namespace survtrack
