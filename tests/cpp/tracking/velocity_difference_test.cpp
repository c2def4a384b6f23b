// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

// Between a track's velocity and the one that a match would imply (Narayana 2007, 4.2), as costs show it.

#include <gtest/gtest.h>

#include <vector>

#include "box_run.hpp"
#include "counted_config.hpp"

namespace survtrack {
namespace {

/// What the velocity factor, of a break-point of 10 px a frame, makes of the cost of one blob after the others.
/// Empty frames are those without a blob.
double factor_of(const std::vector<std::vector<Detection>>& frames, Config config = counted_config()) {
  config.outputs.cost_matrix = true;
  config.cost = MatchMatrixOptions{.velocity_break_point = 0.0};
  BoxRun plain(config, 0.1, 320, 240);
  config.cost = MatchMatrixOptions{.velocity_break_point = 10.0};
  BoxRun scaled(config, 0.1, 320, 240);
  for (const auto& frame : frames) {
    plain.see(frame);
    scaled.see(frame);
  }
  return scaled.result().costs(0, 0) / plain.result().costs(0, 0);
}

TEST(VelocityDifference, ATrackWithoutAVelocityHasNone) {
  EXPECT_DOUBLE_EQ(factor_of({{blob_at(50, 50)}, {blob_at(90, 50)}}), 1.0);
}

TEST(VelocityDifference, OfAnEqualStepIsNothing) {
  EXPECT_NEAR(factor_of({{blob_at(50, 50)}, {blob_at(54, 53)}, {blob_at(58, 56)}}), 0.5, 1e-9);
}

TEST(VelocityDifference, IsTheLengthOfTheDifference) {
  // Steps (4, 0) and (7, 4): 5 px a frame apart, half of the break-point.
  EXPECT_NEAR(factor_of({{blob_at(50, 50)}, {blob_at(54, 50)}, {blob_at(61, 54)}}), 1.0 / 1.1, 1e-9);
  EXPECT_NEAR(factor_of({{blob_at(50, 50)}, {blob_at(54, 50)}, {blob_at(48, 50)}}), 5.0, 1e-9);
}

TEST(VelocityDifference, CountsTheFramesElapsed) {
  // 15 px in three frames are 5 a frame, 1 more than before.
  EXPECT_NEAR(factor_of({{blob_at(50, 50)}, {blob_at(54, 50)}, {}, {}, {blob_at(69, 50)}}), 1.0 / 1.82, 1e-9);
}

TEST(VelocityDifference, IsOfWhatTheTrackMeasures) {
  // The centre of the box, though the centroid lies elsewhere.
  Config config = counted_config();
  config.measurement = BoxCenterOptions{};
  const auto top_heavy = [](double x) {
    Detection blob = blob_at(x, 50);
    blob.position.y -= 5.0;
    return std::vector<Detection>{blob};
  };
  EXPECT_NEAR(factor_of({top_heavy(50), top_heavy(54), top_heavy(58)}, config), 0.5, 1e-9);
}

}  // namespace
}  // namespace survtrack
