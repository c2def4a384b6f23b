// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include <gtest/gtest.h>

#include <cstdint>
#include <utility>
#include <vector>

#include "box_run.hpp"

namespace survtrack {
namespace {

using Ids = std::vector<std::int64_t>;

/// Believes at once and holds on for long; each test changes what it is about.
ConfirmAndLoseOptions easy() {
  return {.confirm_matches = 1,
          .confirm_s = 0.0,
          .confirm_travel = 0.0,
          .report_lost_s = 100.0,
          .max_lost_s = 100.0,
          .birth_overlap = 1.0};
}

/// The measured position is the track's, so that distances are exact.
Config config_of(const ConfirmAndLoseOptions& lifecycle) {
  Config config;
  config.time_unit_s = 1.0;
  config.filter = MeanVelocityOptions{.window_steps = 1, .extrapolate_lost = true};
  config.measurement = BoxCenterOptions{.size_time_s = 0.5};
  config.cost = MatchMatrixOptions{.max_match = 50.0};  // px, as the frame's size is not known
  config.assignment = HungarianOptions{.confirmed_first = true};
  config.lifecycle = lifecycle;
  return config;
}

Box at(double x, double y = 50.0) { return Box::around({x, y}, 20.0, 20.0); }

TEST(ConfirmAndLose, NeedsItsMatches) {
  ConfirmAndLoseOptions options = easy();
  options.confirm_matches = 3;
  BoxRun run(config_of(options));
  for (int i = 0; i < 2; ++i) {
    const TrackingResult& result = run.frame({at(50.0)});
    EXPECT_TRUE(result.tracks.empty());
    ASSERT_EQ(result.tentative.size(), 1U);
    EXPECT_EQ(result.tentative[0].id, 0);
    EXPECT_EQ(result.tentative[0].status, TrackStatus::tentative);
    EXPECT_FALSE(result.tentative[0].reported);
  }
  const TrackingResult& third = run.frame({at(50.0)});
  EXPECT_EQ(ids_of(third), Ids{1});
  EXPECT_TRUE(third.tentative.empty());
  EXPECT_TRUE(third.tracks[0].reported);
  EXPECT_EQ(third.tracks[0].start_index, 0);
  EXPECT_EQ(third.tracks[0].matched_frames, 3);
  EXPECT_EQ(third.tracks[0].age_frames, 2);
}

TEST(ConfirmAndLose, NeedsItsTimeAtAnyFrameRate) {
  ConfirmAndLoseOptions options = easy();
  options.confirm_s = 0.5;
  for (const auto& [period_s, frames] : {std::pair{0.1, 5}, std::pair{0.04, 13}, std::pair{0.25, 2}, std::pair{1.0, 1}}) {
    BoxRun run(config_of(options), period_s);
    for (int i = 0; i < frames; ++i) EXPECT_TRUE(run.frame({at(50.0)}).tracks.empty()) << period_s << ", frame " << i;
    EXPECT_EQ(ids_of(run.frame({at(50.0)})), Ids{1}) << period_s;
  }
}

TEST(ConfirmAndLose, NeedsToTravel) {
  ConfirmAndLoseOptions options = easy();
  options.confirm_travel = 0.5;  // 10 px of an object of 20 x 20
  BoxRun run(config_of(options));
  for (const double x : {50.0, 54.0, 58.0}) EXPECT_TRUE(run.frame({at(x)}).tracks.empty());
  EXPECT_EQ(ids_of(run.frame({at(62.0)})), Ids{1});
  BoxRun still(config_of(options));
  for (int i = 0; i < 100; ++i) EXPECT_TRUE(still.frame({at(50.0 + i % 2)}).tracks.empty());
}

TEST(ConfirmAndLose, TheGreatestDistanceCountsEvenAfterTurningBack) {
  ConfirmAndLoseOptions options = easy();
  options.confirm_travel = 0.5;
  options.confirm_matches = 5;
  BoxRun run(config_of(options));
  for (const double x : {50.0, 56.0, 62.0, 56.0}) EXPECT_TRUE(run.frame({at(x)}).tracks.empty());
  EXPECT_EQ(ids_of(run.frame({at(50.0)})), Ids{1});
}

TEST(ConfirmAndLose, ATentativeTrackDiesAtItsFirstMiss) {
  ConfirmAndLoseOptions options = easy();
  options.confirm_matches = 3;
  BoxRun run(config_of(options));
  run.frame({at(50.0)});
  run.frame({at(50.0)});
  const TrackingResult& missed = run.frame({});
  ASSERT_EQ(missed.tentative.size(), 1U);
  EXPECT_EQ(missed.tentative[0].status, TrackStatus::closed);
  EXPECT_EQ(events_of(missed), "");
  const TrackingResult& again = run.frame({at(50.0)});
  ASSERT_EQ(again.tentative.size(), 1U);
  EXPECT_EQ(again.tentative[0].start_index, 3);
  EXPECT_EQ(again.tentative[0].matched_frames, 1);
}

TEST(ConfirmAndLose, IsReportedThenHeldThenClosed) {
  ConfirmAndLoseOptions options = easy();
  options.report_lost_s = 0.3;
  options.max_lost_s = 0.5;
  BoxRun run(config_of(options));
  run.frame({at(50.0)});
  for (int miss = 1; miss <= 5; ++miss) {
    const TrackingResult& result = run.frame({});
    ASSERT_EQ(ids_of(result), Ids{1}) << miss;
    EXPECT_EQ(result.tracks[0].status, TrackStatus::lost);
    EXPECT_EQ(result.tracks[0].reported, miss <= 3) << miss;
    EXPECT_EQ(result.tracks[0].end_index, 0);
    EXPECT_EQ(events_of(result), miss == 1 ? "track_lost 1" : "");
  }
  const TrackingResult& last = run.frame({});
  EXPECT_EQ(last.tracks[0].status, TrackStatus::closed);
  EXPECT_FALSE(last.tracks[0].reported);
  EXPECT_EQ(events_of(last), "track_ended 1");
  EXPECT_TRUE(run.frame({}).tracks.empty());
}

TEST(ConfirmAndLose, LostTimeIsRealTime) {
  ConfirmAndLoseOptions options = easy();
  options.max_lost_s = 0.5;
  BoxRun run(config_of(options));
  run.frame({at(50.0)});
  run.skip(5);  // nothing is known of these frames
  EXPECT_EQ(run.frame({}).tracks[0].status, TrackStatus::closed);
}

TEST(ConfirmAndLose, AFoundTrackKeepsItsNumber) {
  BoxRun run(config_of(easy()));
  for (const double x : {50.0, 54.0, 58.0}) run.frame({at(x)});
  run.frame({});
  const TrackingResult& lost = run.frame({});
  EXPECT_NEAR(lost.tracks[0].position.x, 66.0, 1e-9);  // moved on with its velocity
  const TrackingResult& found = run.frame({at(70.0)});
  EXPECT_EQ(ids_of(found), Ids{1});
  EXPECT_EQ(found.tracks[0].status, TrackStatus::confirmed);
  EXPECT_EQ(found.tracks[0].lost_frames, 0);
  EXPECT_EQ(events_of(found), "track_recovered 1");
}

TEST(ConfirmAndLose, ClosesWhatLeftTheFrame) {
  Config config = config_of(easy());
  config.cost = MatchMatrixOptions{.max_match = 0.5};  // parts of the frame now
  BoxRun run(config, 0.1, 100, 100);
  for (const double x : {75.0, 85.0, 94.0}) run.frame({at(x)});
  const TrackingResult& gone = run.frame({});  // expected at 103
  ASSERT_EQ(gone.tracks.size(), 1U);
  EXPECT_EQ(gone.tracks[0].status, TrackStatus::closed);
  EXPECT_TRUE(run.frame({}).tracks.empty());
}

TEST(ConfirmAndLose, WithoutAFrameSizeNothingLeaves) {
  BoxRun run(config_of(easy()));
  for (const double x : {20.0, 10.0, 1.0}) run.frame({at(x)});
  for (int i = 0; i < 10; ++i) EXPECT_EQ(run.frame({}).tracks[0].status, TrackStatus::lost);
  EXPECT_LT(run.result().tracks[0].position.x, 0.0);
}

TEST(ConfirmAndLose, WhatLiesInAMatchedTracksBoxStartsNone) {
  ConfirmAndLoseOptions options = easy();
  options.birth_overlap = 0.5;
  BoxRun run(config_of(options));
  run.frame({at(50.0)});
  // 6 of its 10 px of width lie in the track's box, which ends at 60.
  EXPECT_EQ(ids_of(run.frame({at(50.0), {54.0, 45.0, 10.0, 10.0}})), Ids{1});
  EXPECT_EQ(ids_of(run.frame({at(50.0), {56.0, 45.0, 10.0, 10.0}})), (Ids{1, 2}));
}

TEST(ConfirmAndLose, ALostTracksBoxHindersNoBirth) {
  ConfirmAndLoseOptions options = easy();
  options.birth_overlap = 0.5;
  Config config = config_of(options);
  config.cost = MatchMatrixOptions{.max_match = 2.0};
  BoxRun run(config);
  run.frame({at(50.0)});
  EXPECT_EQ(ids_of(run.frame({at(55.0)})), (Ids{1, 2}));
}

TEST(ConfirmAndLose, NumbersHaveNoGaps) {
  ConfirmAndLoseOptions options = easy();
  options.confirm_matches = 2;
  options.max_lost_s = 0.0;
  BoxRun run(config_of(options));
  std::int64_t next = 1;
  for (int i = 0; i < 20; ++i) {
    run.frame({at(50.0), at(150.0)});
    // One of the two is seen a second time only.
    const TrackingResult& result = run.frame({i % 3 == 0 ? at(50.0) : at(150.0)});
    ASSERT_EQ(ids_of(result), Ids{next}) << i;
    ++next;
    run.frame({});
    EXPECT_TRUE(run.frame({}).tracks.empty());
  }
}

TEST(ConfirmAndLose, BelievedTracksChooseFirstWhenAsked) {
  ConfirmAndLoseOptions options = easy();
  options.confirm_matches = 2;
  for (const bool confirmed_first : {true, false}) {
    Config config = config_of(options);
    config.assignment = HungarianOptions{.confirmed_first = confirmed_first};
    BoxRun run(config);
    run.frame({at(50.0)});
    run.frame({at(50.0)});
    run.frame({at(50.0), at(80.0)});  // a believed track and a tentative one
    const TrackingResult& result = run.frame({at(78.0)});
    EXPECT_EQ(result.tracks[0].status, confirmed_first ? TrackStatus::confirmed : TrackStatus::lost);
  }
}

}  // namespace
}  // namespace survtrack
