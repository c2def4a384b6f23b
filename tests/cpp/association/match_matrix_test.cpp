// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include <gtest/gtest.h>

#include <cmath>

#include "survtrack/association/costs.hpp"

namespace survtrack {
namespace {

TEST(MatchMatrix, WorkedByHand) {
  // Eq. 3.6: a step of (32, 18) px in a frame of 320 x 240 and 51 levels of each channel but blue.
  Track track;
  track.position = {100.0, 100.0};
  track.mean_color = {10.0, 20.0, 30.0};
  Detection detection;
  detection.position = {132.0, 118.0};
  detection.mean_color = {10.0, 71.0, 81.0};
  const double distance = std::sqrt(0.1 * 0.1 + 0.075 * 0.075);  // 0.125
  const double color = std::sqrt(0.2 * 0.2 + 0.2 * 0.2);
  EXPECT_NEAR(match_matrix_entry(track, detection, 320.0, 240.0), distance + color, 1e-15);
  EXPECT_NEAR(distance, 0.125, 1e-15);
}

TEST(MatchMatrix, FarthestAndNearest) {
  Track track;
  Detection detection;
  EXPECT_EQ(match_matrix_entry(track, detection, 320.0, 240.0), 0.0);
  detection.position = {320.0, 240.0};
  detection.mean_color = {255.0, 255.0, 255.0};
  EXPECT_NEAR(match_matrix_entry(track, detection, 320.0, 240.0), std::sqrt(2.0) + std::sqrt(3.0), 1e-15);
}

TEST(MatchMatrix, MeasuresFromTheLastPositionNotThePredictedOne) {
  Track track;
  track.predicted_position = {300.0, 200.0};
  track.velocity_px_per_s = {50.0, 50.0};
  Detection detection;
  detection.position = {32.0, 0.0};
  EXPECT_NEAR(match_matrix_entry(track, detection, 320.0, 240.0), 0.1, 1e-15);
}

}  // namespace
}  // namespace survtrack
