// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "../error_message.hpp"
#include "box_run.hpp"

namespace survtrack {
namespace {

constexpr double period_s = 0.2685;  // Nashenda 2011: 3.724 frames a second

/// Nashenda 2011, with the numbers that are a filter: R without its off-diagonal, no control input.
Config largest_config(int lost_after_frames = 0, int restart_after_frames = 0) {
  Config config;
  config.filter = KalmanDiscreteOptions{.process_variances = {10.0, 10.0, 10.0, 10.0},
                                        .measurement_covariance = {0.2877, 0.0, 1.1465},
                                        .initial_variances = {100.0, 100.0, 100.0, 100.0},
                                        .step_time = period_s,
                                        .start = FilterStart::frame_center};
  config.measurement = CentroidOptions{};
  config.cost = DistanceOptions{};
  config.assignment = LargestOptions{};
  config.lifecycle =
      SingleLargestOptions{.lost_after_frames = lost_after_frames, .restart_after_frames = restart_after_frames};
  return config;
}

BoxRun run_with(const Config& config) { return BoxRun(config, period_s, 384, 288); }

Box large(int k) { return Box::around({60.0 + 3.0 * k, 100.0}, 30.0, 40.0); }
Box small(int k) { return Box::around({300.0 - 4.0 * k, 110.0}, 20.0, 20.0); }

TEST(SingleLargest, FollowsTheLargestOnly) {
  BoxRun run = run_with(largest_config());
  EXPECT_TRUE(run.frame({}).tracks.empty());
  for (int k = 0; k < 50; ++k) {
    const TrackingResult& result = run.frame({small(k), large(k)});
    ASSERT_EQ(ids_of(result), (std::vector<std::int64_t>{1}));
    EXPECT_EQ(result.tracks[0].detection, 1);
    EXPECT_TRUE(result.tracks[0].reported);
    EXPECT_TRUE(result.tentative.empty());
    if (k > 20) {
      EXPECT_NEAR(result.tracks[0].position.x, large(k).center().x, 0.5);
      EXPECT_NEAR(result.tracks[0].velocity_px_per_s.x, 3.0 / period_s, 1.0);
    }
  }
}

TEST(SingleLargest, StartsAtTheFramesCentreAndIsCorrected) {
  BoxRun run = run_with(largest_config());
  run.frame({Box::around({367.0, 274.0}, 20.0, 20.0)});
  // P- = 100 (1 + dt^2) + 10, K = P- / (P- + R).
  const double P = 100.0 * (1.0 + period_s * period_s) + 10.0;
  EXPECT_NEAR(run.result().tracks[0].position.x, 192.0 + P / (P + 0.2877) * (367.0 - 192.0), 1e-9);
  EXPECT_NEAR(run.result().tracks[0].position.y, 144.0 + P / (P + 1.1465) * (274.0 - 144.0), 1e-9);
}

/// The listing's `continue` on a missing blob leaves that frame's state at zero, from where the filter then starts.
TEST(SingleLargest, AMissingBlobIsPredictedAndNotZero) {
  for (const double q : {0.0, 10.0, 100.0}) {
    Config config = largest_config();
    std::get<KalmanDiscreteOptions>(config.filter).process_variances = {q, q, q, q};
    BoxRun run = run_with(config);
    for (int k = 0; k < 93; ++k) run.frame({large(k)});
    for (int k = 93; k < 95; ++k) {  // 0.537 s
      run.frame({});
      const Track& track = run.result().tracks.at(0);
      EXPECT_EQ(track.status, TrackStatus::lost);
      EXPECT_TRUE(track.reported);
      EXPECT_NEAR(track.position.x, large(k).center().x, 1.0) << q;
      EXPECT_NEAR(track.position.y, 100.0, 0.5) << q;
    }
    run.frame({large(95)});
    EXPECT_EQ(events_of(run.result()), "track_recovered 1");
    EXPECT_NEAR(run.result().tracks[0].position.x, large(95).center().x, 1.0) << q;
  }
}

TEST(SingleLargest, IsPredictedForEverUnlessItIsToEnd) {
  for (const int lost_after_frames : {0, 3}) {
    BoxRun run = run_with(largest_config(lost_after_frames));
    for (int k = 0; k < 10; ++k) run.frame({large(k)});
    for (int miss = 1; miss <= 10; ++miss) {
      run.frame({});
      const bool ends = lost_after_frames > 0 && miss == 4;
      EXPECT_EQ(events_of(run.result()), miss == 1 ? "track_lost 1" : ends ? "track_ended 1" : "") << miss;
      EXPECT_EQ(run.result().tracks.size(), lost_after_frames == 0 || miss <= 4 ? 1U : 0U) << miss;
    }
    run.frame({large(20)});
    EXPECT_EQ(events_of(run.result()), lost_after_frames == 0 ? "track_recovered 1" : "track_started 2");
  }
}

TEST(SingleLargest, AfterALongOcclusionItStartsAnew) {
  Config config = largest_config(0, 5);
  std::get<KalmanDiscreteOptions>(config.filter).start = FilterStart::detection;
  for (const int misses : {5, 6}) {
    BoxRun run = run_with(config);
    for (int k = 0; k < 30; ++k) run.frame({large(k)});
    for (int k = 0; k < misses; ++k) {
      run.frame({});
      EXPECT_EQ(run.result().tracks.at(0).reported, k < 5);
    }
    run.frame({Box::around({50.0, 200.0}, 30.0, 40.0)});
    const Track& track = run.result().tracks.at(0);
    EXPECT_EQ(track.id, 1);
    if (misses > 5) {
      EXPECT_EQ(track.position, (Point{50.0, 200.0}));
      EXPECT_EQ(track.velocity_px_per_s, (Point{}));
    } else {
      EXPECT_LT(track.velocity_px_per_s.x, -20.0);  // one that goes on is pulled back
    }
  }
}

TEST(SingleLargest, TheCostMayRefuseTheLargest) {
  Config config = largest_config();
  std::get<DistanceOptions>(config.cost).max_distance_px = 50.0;
  BoxRun run = run_with(config);
  for (int k = 0; k < 20; ++k) run.frame({small(k)});
  run.frame({Box::around({60.0, 60.0}, 80.0, 80.0), small(20)});
  EXPECT_EQ(run.result().tracks[0].detection, 1);
}

TEST(SingleLargest, OfEquallyLargeOnesTheFirst) {
  BoxRun run = run_with(largest_config());
  for (int k = 0; k < 3; ++k) {
    run.frame({Box{10, 10, 20, 20}, Box{200, 10, 20, 20}});
    EXPECT_EQ(run.result().tracks[0].detection, 0);
  }
}

TEST(LargestAssignment, OlderTracksTakeFirst) {
  Config config = largest_config();
  config.lifecycle = LostCountOptions{};
  BoxRun run = run_with(config);
  run.frame({small(0), large(0)});
  run.frame({small(1), large(1)});
  EXPECT_EQ(run.result().tracks[0].detection, 1);
  EXPECT_EQ(run.result().tracks[1].detection, 0);
}

TEST(SingleLargest, ItsStartNeedsTheFramesSize) {
  Tracker tracker(largest_config());
  EXPECT_EQ(message_of<InputError>([&] { tracker.process(detections_of({large(0)}, 0.0, 0)); }),
            "frame: its size is not known, and filter.start is \"frame_center\"; expected detections with the size of their "
            "frame, or filter.start detection");
}

}  // namespace
}  // namespace survtrack
