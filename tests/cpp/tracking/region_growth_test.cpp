// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include <gtest/gtest.h>

#include "box_run.hpp"

namespace survtrack {
namespace {

Config growth_config(int max_objects = 100) {
  Config config;
  config.filter = KalmanCvOptions{.noise_unit = NoiseUnit::px, .velocity_noise = 20.0, .position_noise = 1.0,
                                  .initial_velocity = 50.0, .lost_damping_time = 0.0};
  config.cost = DistanceOptions{.max_distance_px = 30.0};
  config.lifecycle = RegionGrowthOptions{.lost_after_frames = 4, .max_objects = max_objects};
  return config;
}

Detections frame_of(int index, const std::vector<Box>& boxes, const std::vector<Region>& regions) {
  Detections detections = detections_of(boxes, 0.1 * index, index, 200, 100);
  detections.regions = regions;
  return detections;
}

Box car(double x) { return {x, 40.0, 20.0, 10.0}; }
const std::vector<Region> zone = {{{0.0, 30.0, 30.0, 30.0}, RegionKind::acquisition, 0}};

TEST(RegionGrowth, StartsInAnAcquisitionRegionOnly) {
  Tracker tracker(growth_config());
  EXPECT_TRUE(tracker.process(frame_of(0, {car(90)}, zone)).tracks.empty());
  const TrackingResult found = tracker.process(frame_of(1, {car(20), car(95)}, zone));
  ASSERT_EQ(found.tracks.size(), 1U);
  EXPECT_TRUE(found.tracks[0].reported) << "from the first frame on";
  EXPECT_EQ(found.tracks[0].box, car(20));
  // It is followed beyond.
  for (int i = 2; i < 8; ++i) {
    const TrackingResult result = tracker.process(frame_of(i, {car(20 + 5 * (i - 1)), car(120)}, zone));
    EXPECT_EQ(ids_of(result), (std::vector<std::int64_t>{1})) << i;
  }
}

TEST(RegionGrowth, StartsAnywhereWhenNoRegionIsSetApart) {
  BoxRun run(growth_config(), 0.1, 200, 100);
  EXPECT_EQ(ids_of(run.frame({car(90), car(20)})), (std::vector<std::int64_t>{1, 2}));
}

TEST(RegionGrowth, IsAtItsPredictionUpToALimit) {
  BoxRun run(growth_config(), 0.1, 200, 100);
  for (int i = 0; i < 10; ++i) run.frame({car(10 + 4 * i)});
  double variance_px2 = run.result().tracks[0].position_covariance_px2.xx;
  for (int lost = 1; lost <= 4; ++lost) {
    run.frame({});
    ASSERT_EQ(run.result().tracks.size(), 1U) << lost;
    const Track& track = run.result().tracks[0];
    EXPECT_EQ(track.status, TrackStatus::lost);
    EXPECT_TRUE(track.reported) << "no missing frame in the replay";
    EXPECT_NEAR(track.position.x, 10.0 + 4.0 * (9 + lost) + 10.0, 1.5);
    EXPECT_GT(track.position_covariance_px2.xx, variance_px2) << "and with it the region";
    variance_px2 = track.position_covariance_px2.xx;
  }
  run.frame({});
  EXPECT_EQ(run.result().tracks[0].status, TrackStatus::closed);
  EXPECT_TRUE(run.frame({}).tracks.empty());
}

TEST(RegionGrowth, EndsOutsideOfTheFrameAndTakesPiecesForNobody) {
  BoxRun run(growth_config(), 0.1, 200, 100);
  for (int i = 0; i < 8; ++i) run.frame({car(150 + 5 * i), {152.0 + 5 * i, 42.0, 6.0, 6.0}});
  EXPECT_EQ(ids_of(run.result()), (std::vector<std::int64_t>{1, 2})) << "two in the first frame, none later";
  run.frame({});
  run.frame({});
  run.frame({});
  EXPECT_TRUE(run.frame({}).tracks.empty());
}

TEST(RegionGrowth, FollowsNoMoreThanItMay) {
  BoxRun run(growth_config(1), 0.1, 200, 100);
  EXPECT_EQ(ids_of(run.frame({car(90), car(20)})), (std::vector<std::int64_t>{1}));
  for (int i = 0; i < 6; ++i) run.frame({car(20)});
  EXPECT_EQ(ids_of(run.frame({car(20)})), (std::vector<std::int64_t>{2})) << "the next when the first is lost";
}

}  // namespace
}  // namespace survtrack
