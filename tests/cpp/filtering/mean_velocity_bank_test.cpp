// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "survtrack/filtering/mean_velocity_bank.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace survtrack {
namespace {

void step(MeanVelocityBank& bank, double dt, const Point& measured) {
  bank.predict(dt);
  bank.correct(0, measured);
}

/// Seen at x = 0, 1, 3, 6, 10, 15, 21, a time unit apart.
MeanVelocityBank after_seven_places(const MeanVelocityOptions& options) {
  MeanVelocityBank bank(options);
  bank.add({0.0, 40.0}, 10.0);
  for (const double x : {1.0, 3.0, 6.0, 10.0, 15.0, 21.0}) step(bank, 1.0, {x, 40.0});
  return bank;
}

TEST(MeanVelocity, IsTheMeanOfTheLastFiveSteps) {
  const MeanVelocityBank bank = after_seven_places({.window_steps = 5});
  EXPECT_EQ(bank.estimate(0).velocity, (Point{4.0, 0.0}));  // 2 + 3 + 4 + 5 + 6 over 5
  EXPECT_EQ(bank.estimate(0).position, (Point{21.0, 40.0}));
}

TEST(MeanVelocity, TakesWhatThereIsAtFirst) {
  MeanVelocityBank bank({.window_steps = 5});
  bank.add({0.0, 0.0}, 10.0);
  EXPECT_EQ(bank.estimate(0).velocity, Point{});
  bank.predict(1.0);
  EXPECT_EQ(bank.predicted_position(0), Point{});
  bank.correct(0, {2.0, 6.0});
  EXPECT_EQ(bank.estimate(0).velocity, (Point{2.0, 6.0}));
  step(bank, 1.0, {6.0, 6.0});
  EXPECT_EQ(bank.estimate(0).velocity, (Point{3.0, 3.0}));
}

TEST(MeanVelocity, WindowOfOneIsTheLastStep) {
  EXPECT_EQ(after_seven_places({.window_steps = 1}).estimate(0).velocity, (Point{6.0, 0.0}));
}

TEST(MeanVelocity, PredictsPositionPlusVelocity) {
  MeanVelocityBank bank = after_seven_places({.window_steps = 5});
  bank.predict(1.0);
  EXPECT_EQ(bank.predicted_position(0), (Point{25.0, 40.0}));
  EXPECT_EQ(bank.estimate(0).position, (Point{21.0, 40.0}));
}

TEST(MeanVelocity, ALostTrackStaysFrozen) {
  MeanVelocityBank bank = after_seven_places({.window_steps = 5});
  for (int missed = 0; missed < 4; ++missed) {
    bank.predict(1.0);
    EXPECT_EQ(bank.estimate(0).position, (Point{21.0, 40.0}));
    EXPECT_EQ(bank.estimate(0).velocity, (Point{4.0, 0.0}));
    EXPECT_EQ(bank.predicted_position(0), (Point{25.0, 40.0}));
  }
}

TEST(MeanVelocity, ALostTrackMovesOnWhenAsked) {
  MeanVelocityBank bank = after_seven_places({.window_steps = 5, .extrapolate_lost = true});
  for (int missed = 1; missed <= 4; ++missed) {
    bank.predict(1.0);
    EXPECT_EQ(bank.estimate(0).position, (Point{21.0 + 4.0 * missed, 40.0}));
    EXPECT_EQ(bank.predicted_position(0), bank.estimate(0).position);
  }
}

TEST(MeanVelocity, AMissingFrameIsAStepOfTwoUnits) {
  MeanVelocityBank bank({.window_steps = 5});
  bank.add({0.0, 0.0}, 10.0);
  step(bank, 1.0, {3.0, 0.0});
  bank.predict(2.0);
  EXPECT_EQ(bank.predicted_position(0), (Point{9.0, 0.0}));
  bank.correct(0, {9.0, 0.0});
  EXPECT_EQ(bank.estimate(0).velocity, (Point{3.0, 0.0}));
}

TEST(MeanVelocity, TheStepOverLostFramesCountsTheirTime) {
  for (const bool extrapolate : {false, true}) {
    MeanVelocityBank bank({.window_steps = 5, .extrapolate_lost = extrapolate});
    bank.add({0.0, 0.0}, 10.0);
    step(bank, 1.0, {3.0, 0.0});
    bank.predict(1.0);
    bank.predict(1.0);
    bank.predict(1.0);
    bank.correct(0, {12.0, 0.0});
    EXPECT_EQ(bank.estimate(0).velocity, (Point{3.0, 0.0}));
    bank.predict(1.0);
    EXPECT_EQ(bank.predicted_position(0), (Point{15.0, 0.0}));
  }
}

TEST(MeanVelocity, HasNoCovariance) {
  MeanVelocityBank bank({.window_steps = 5});
  bank.add({0.0, 0.0}, 10.0);
  EXPECT_EQ(bank.estimate(0).covariance_px2, Symmetric2{});
  EXPECT_EQ(bank.state_covariance(0).size(), 0);
}

}  // namespace
}  // namespace survtrack
