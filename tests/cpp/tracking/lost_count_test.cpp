// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include <gtest/gtest.h>

#include <cstdint>
#include <set>
#include <vector>

#include "box_run.hpp"

namespace survtrack {
namespace {

using Ids = std::vector<std::int64_t>;

/// The base of Narayana 2007; `max_match` keeps far boxes apart.
Config base(int lost_after_frames = 5) {
  Config config;
  config.time_unit_s = 0.1;
  config.filter = MeanVelocityOptions{.window_steps = 5, .extrapolate_lost = false};
  config.measurement = CentroidOptions{};
  config.cost = MatchMatrixOptions{.max_match = 0.5};
  config.assignment = OldestFirstOptions{};
  config.lifecycle = LostCountOptions{.lost_after_frames = lost_after_frames};
  return config;
}

const Box left{10.0, 10.0, 20.0, 20.0};
const Box right{80.0, 10.0, 20.0, 20.0};

BoxRun run_with(const Config& config) { return BoxRun(config, 0.1, 120, 90); }

TEST(LostCount, ATrackABlobAtOnce) {
  BoxRun run = run_with(base());
  const TrackingResult& first = run.frame({left, right});
  EXPECT_EQ(ids_of(first), (Ids{1, 2}));
  EXPECT_TRUE(first.tentative.empty());
  for (const Track& track : first.tracks) {
    EXPECT_EQ(track.status, TrackStatus::confirmed);
    EXPECT_TRUE(track.reported);
  }
  EXPECT_EQ(events_of(first), "track_started 1, track_started 2");
}

TEST(LostCount, ClosesOnTheSixthMissInARow) {
  BoxRun run = run_with(base(5));
  run.frame({left, right});
  for (int miss = 1; miss <= 5; ++miss) {
    const TrackingResult& result = run.frame({left});
    ASSERT_EQ(ids_of(result), (Ids{1, 2})) << miss;
    EXPECT_EQ(result.tracks[1].status, TrackStatus::lost);
    EXPECT_EQ(result.tracks[1].lost_frames, miss);
    EXPECT_FALSE(result.tracks[1].reported);
    EXPECT_EQ(events_of(result), miss == 1 ? "track_lost 2" : "");
  }
  const TrackingResult& sixth = run.frame({left});
  ASSERT_EQ(ids_of(sixth), (Ids{1, 2}));
  EXPECT_EQ(sixth.tracks[1].status, TrackStatus::closed);
  EXPECT_EQ(sixth.tracks[1].lost_frames, 6);
  EXPECT_EQ(events_of(sixth), "track_ended 2");
  EXPECT_EQ(ids_of(run.frame({left})), (Ids{1}));
}

TEST(LostCount, AMatchStartsTheCountAnew) {
  BoxRun run = run_with(base(2));
  run.frame({left});
  for (int i = 0; i < 4; ++i) {
    run.frame({});
    run.frame({});
    const TrackingResult& again = run.frame({left});
    ASSERT_EQ(ids_of(again), (Ids{1}));
    EXPECT_EQ(again.tracks[0].status, TrackStatus::confirmed);
    EXPECT_EQ(events_of(again), "track_recovered 1");
  }
}

TEST(LostCount, ZeroClosesAtTheFirstMiss) {
  BoxRun run = run_with(base(0));
  run.frame({left});
  const TrackingResult& result = run.frame({});
  ASSERT_EQ(result.tracks.size(), 1U);
  EXPECT_EQ(result.tracks[0].status, TrackStatus::closed);
}

TEST(LostCount, NumbersAreNeverReused) {
  BoxRun run = run_with(base(0));
  std::set<std::int64_t> seen;
  for (std::int64_t i = 1; i <= 6; ++i) {
    const TrackingResult& result = run.frame({i % 2 == 0 ? left : right});
    EXPECT_EQ(result.tracks.back().id, i);
    EXPECT_EQ(result.tracks.back().start_index, 2 * (i - 1));
    seen.insert(result.tracks.back().id);
    run.frame({});
  }
  EXPECT_EQ(seen.size(), 6U);
}

TEST(LostCount, ALostTrackStaysFrozenWithItsVelocity) {
  BoxRun run = run_with(base());
  for (const double x : {10.0, 12.0, 14.0, 16.0}) run.frame({{x, 10.0, 20.0, 20.0}});
  const Track seen = run.result().tracks[0];
  EXPECT_NEAR(seen.velocity_px_per_s.x, 20.0, 1e-9);  // 2 px a frame of 0.1 s
  for (int miss = 0; miss < 3; ++miss) {
    const Track lost = run.frame({}).tracks[0];
    EXPECT_EQ(lost.position, seen.position);
    EXPECT_EQ(lost.box, seen.box);
    EXPECT_EQ(lost.velocity_px_per_s, seen.velocity_px_per_s);
    EXPECT_EQ(lost.end_index, seen.end_index);
  }
}

TEST(LostCount, TheOldestTrackTakesTheBlobThatSuitsTwo) {
  BoxRun run = run_with(base());
  run.frame({left, right});
  // Nearer to track 2, and within reach of track 1, which comes first.
  const TrackingResult& result = run.frame({{46.0, 10.0, 20.0, 20.0}});
  ASSERT_EQ(ids_of(result), (Ids{1, 2}));
  EXPECT_EQ(result.tracks[0].status, TrackStatus::confirmed);
  EXPECT_EQ(result.tracks[1].status, TrackStatus::lost);
}

TEST(LostCount, TheCentroidIsThePositionAndTheBlobsBoxTheBox) {
  Tracker tracker(base());
  Detections detections = detections_of({{10.0, 10.0, 20.0, 40.0}}, 0.0, 0);
  detections.items[0].position = {13.0, 35.0};
  const TrackingResult result = tracker.process(detections);
  EXPECT_EQ(result.tracks[0].position, (Point{13.0, 35.0}));
  EXPECT_EQ(result.tracks[0].box, (Box{10.0, 10.0, 20.0, 40.0}));
}

}  // namespace
}  // namespace survtrack
