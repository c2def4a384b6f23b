// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "survtrack/tracking/scale_learner.hpp"

#include <gtest/gtest.h>

namespace survtrack {
namespace {

constexpr double frame_height = 480.0;

double true_height(double bottom) { return 10.0 + 0.25 * bottom; }

/// An object whose lower edge is at `bottom`.
Box object(double bottom, double height) { return {100.0, bottom - height, 0.4 * height, height}; }

void show(ScaleLearner& learner, int objects) {
  for (int i = 0; i < objects; ++i) {
    const double bottom = 150.0 + (i * 37) % 300;
    learner.add(object(bottom, true_height(bottom)), frame_height);
  }
}

TEST(ScaleLearner, FindsTheLawOfHeights) {
  ScaleLearner learner;
  EXPECT_FALSE(learner.scale().known);
  show(learner, 400);
  ASSERT_TRUE(learner.scale().known);
  for (const double bottom : {150.0, 300.0, 450.0}) {
    EXPECT_NEAR(learner.scale().height_px(bottom), true_height(bottom), 0.2 * true_height(bottom));
  }
}

TEST(ScaleLearner, AFewObjectsAreNoLaw) {
  ScaleLearner learner;
  show(learner, 20);
  EXPECT_FALSE(learner.scale().known);
}

TEST(ScaleLearner, WithoutSpreadInRowsTheHeightIsAConstant) {
  ScaleLearner learner;
  for (int i = 0; i < 400; ++i) learner.add(object(300.0, 60.0), frame_height);
  EXPECT_NEAR(learner.scale().height_px(300.0), 60.0, 0.1);
  EXPECT_NEAR(learner.scale().height_px(310.0), 60.0, 1.0);
}

TEST(ScaleLearner, HeightsThatFollowNoLawAreNotKnown) {
  ScaleLearner learner;
  for (int i = 0; i < 600; ++i) {
    const double bottom = 250.0 + (i * 37) % 200;
    learner.add(object(bottom, i % 2 == 0 ? 20.0 : 200.0), frame_height);
  }
  EXPECT_FALSE(learner.scale().known);
}

TEST(ScaleLearner, ClearForgets) {
  ScaleLearner learner;
  show(learner, 400);
  learner.clear();
  EXPECT_FALSE(learner.scale().known);
  show(learner, 20);
  EXPECT_FALSE(learner.scale().known);
}

}  // namespace
}  // namespace survtrack
