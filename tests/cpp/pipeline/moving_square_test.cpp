// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include <gtest/gtest.h>

#include <cstdint>
#include <set>
#include <vector>

#include "scene_run.hpp"

namespace survtrack {
namespace {

/// One track, on the square from soon after it entered to the end of the run.
void expect_one_good_track(const SyntheticScene& scene, const std::vector<FrameResult>& results) {
  constexpr double settled_s = 0.8;  // after entering
  std::set<std::int64_t> ids;
  for (const FrameResult& result : results) {
    const double t = result.time_s;
    for (const Track& track : result.tracks) ids.insert(track.id);
    EXPECT_TRUE(scene.present(t) || result.tracks.empty()) << t;
    if (t < scene.enters_s + settled_s) continue;
    ASSERT_EQ(result.tracks.size(), 1U) << t;
    const Track& track = result.tracks[0];
    EXPECT_TRUE(track.reported);
    EXPECT_EQ(track.status, TrackStatus::confirmed);
    EXPECT_GT(iou(track.box, scene.square(t)), 0.8) << t;
    EXPECT_NEAR(track.velocity_px_per_s.x, scene.speed_px_per_s, 0.12 * scene.speed_px_per_s) << t;
    EXPECT_NEAR(track.velocity_px_per_s.y, 0.0, 2.0) << t;
    EXPECT_NEAR(track.mean_color.red, 240.0, 12.0);
    EXPECT_NEAR(track.mean_color.blue, 60.0, 12.0);
  }
  EXPECT_EQ(ids, std::set<std::int64_t>{1});
}

TEST(MovingSquare, IsOneTrackAtTwoFrameRates) {
  const SyntheticScene scene;
  for (const double frames_per_s : {10.0, 25.0}) {
    Pipeline pipeline(scene_config());
    expect_one_good_track(scene, run_scene(pipeline, scene, steady_times(frames_per_s, static_cast<int>(4.5 * frames_per_s))));
  }
}

TEST(MovingSquare, IsOneTrackWithMissingAndLateFrames) {
  const SyntheticScene scene;
  std::vector<double> times_s;
  for (int i = 0; i < 90; ++i) {
    if (i % 5 == 2 || i % 7 == 3 || (i > 50 && i < 54)) continue;
    times_s.push_back(i / 20.0 + (i % 2 == 0 ? 0.0 : 0.012));
  }
  Pipeline pipeline(scene_config());
  expect_one_good_track(scene, run_scene(pipeline, scene, times_s));
}

TEST(MovingSquare, ADelayedPipelineSeesTheSame) {
  const SyntheticScene scene;
  Pipeline pipeline(delayed_config(60));
  const auto results = run_scene(pipeline, scene, steady_times(20.0, 90));
  ASSERT_EQ(results.size(), 90U);
  int good = 0, present = 0;
  for (const FrameResult& result : results) {
    if (result.time_s < 2.0) continue;
    ++present;
    for (const Track& track : result.tracks) good += iou(track.box, scene.square(result.time_s)) > 0.6 ? 1 : 0;
  }
  EXPECT_GE(good, 0.9 * present);
}

TEST(MovingSquare, GreyFramesWorkToo) {
  SyntheticScene scene;
  scene.channels = 1;
  Pipeline pipeline(scene_config());
  const auto results = run_scene(pipeline, scene, steady_times(10.0, 45));
  ASSERT_EQ(results.back().tracks.size(), 1U);
  EXPECT_GT(iou(results.back().tracks[0].box, scene.square(results.back().time_s)), 0.8);
}

TEST(MovingSquare, Narayana2007RunsEndToEnd) {
  SyntheticScene scene;
  scene.enters_s = 3.2;  // after the window of the first frame, from which the secondary background starts
  scene.speed_px_per_s = 25.0;
  Pipeline pipeline = Pipeline::from_preset("narayana2007");
  const auto results = run_scene(pipeline, scene, steady_times(25.0, 200));
  ASSERT_EQ(results.size(), 200U);
  int good = 0, present = 0;
  std::set<std::int64_t> ids;
  for (const FrameResult& result : results) {
    if (!scene.present(result.time_s)) continue;
    ++present;
    for (const Track& track : result.tracks) {
      if (!track.reported || iou(track.box, scene.square(result.time_s)) < 0.5) continue;
      ++good;
      ids.insert(track.id);
    }
  }
  EXPECT_GE(good, 0.9 * present);
  EXPECT_EQ(ids.size(), 1U);
}

}  // namespace
}  // namespace survtrack
