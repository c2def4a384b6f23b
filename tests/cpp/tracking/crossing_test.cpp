// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

// Two objects that pass each other (Narayana 2007, figs. 4.10 and 4.13): the velocity factor keeps their numbers.

#include <gtest/gtest.h>

#include <cstdint>
#include <utility>

#include "box_run.hpp"
#include "counted_config.hpp"

namespace survtrack {
namespace {

constexpr int frames = 28;

/// Where the tracks with the numbers 1 and 2 end: one walks to the right, the other to the left, 8 px a frame. They pass
/// where the light changes: to the right of it all is brighter by some grey levels.
std::pair<double, double> ends(const Config& config, double brighter) {
  const auto blob = [&](double x) { return blob_at(x, 120.0, x > 152.5 ? 100.0 + brighter : 100.0); };
  BoxRun run(config, 0.1, 320, 240);
  for (int k = 0; k < frames; ++k) run.see({blob(40.0 + 8.0 * k), blob(265.0 - 8.0 * k)});
  EXPECT_EQ(ids_of(run.result()).size(), 2U);
  return {run.result().tracks.at(0).position.x, run.result().tracks.at(1).position.x};
}

const std::pair<double, double> kept{40.0 + 8.0 * (frames - 1), 265.0 - 8.0 * (frames - 1)};
const std::pair<double, double> swapped{kept.second, kept.first};

Config match_matrix(double velocity_break_point) {
  Config config = counted_config();
  config.cost = MatchMatrixOptions{.velocity_break_point = velocity_break_point};
  return config;
}

Config belief(BeliefOrder order, double velocity_break_point) {
  Config config = belief_config();
  auto& options = std::get<BeliefOptions>(config.cost);
  options.order = order;
  options.velocity_break_point = velocity_break_point;
  return config;
}

TEST(Crossing, WithoutTheVelocityFactorTheMatchMatrixSwaps) {
  // It measures from the last position: the other one has come nearer to it than its own has gone.
  EXPECT_EQ(ends(match_matrix(0.0), 0.0), swapped);
}

TEST(Crossing, WithTheVelocityFactorTheMatchMatrixKeepsThem) {
  EXPECT_EQ(ends(match_matrix(16.0), 0.0), kept);
}

TEST(Crossing, WithoutTheVelocityFactorBeliefsInTheirColoursSwap) {
  EXPECT_EQ(ends(belief(BeliefOrder::free, 0.0), 10.0), swapped);
  EXPECT_EQ(ends(belief(BeliefOrder::published, 0.0), 10.0), swapped);
}

TEST(Crossing, WithTheVelocityFactorBeliefsKeepThem) {
  EXPECT_EQ(ends(belief(BeliefOrder::free, 15.0), 10.0), kept);
  EXPECT_EQ(ends(belief(BeliefOrder::published, 15.0), 10.0), kept);
}

TEST(Crossing, BeliefsOfEqualColoursGoByThePredictedPosition) {
  EXPECT_EQ(ends(belief(BeliefOrder::free, 0.0), 0.0), kept);
}

}  // namespace
}  // namespace survtrack
