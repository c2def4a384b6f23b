// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "box_run.hpp"

namespace survtrack {
namespace {

Config config_of_two_matches() {
  Config config;
  config.time_unit_s = 1.0;
  config.filter = KalmanCvOptions{.noise_unit = NoiseUnit::px,
                                  .velocity_noise = 10.0,
                                  .position_noise = 2.0,
                                  .initial_velocity = 50.0,
                                  .lost_damping_time = 0.0};
  config.measurement = BoxCenterOptions{.size_time_s = 0.5};
  config.cost = GaussianCostOptions{.gate = 20.0};
  config.assignment = HungarianOptions{.confirmed_first = true};
  config.lifecycle = ConfirmAndLoseOptions{.confirm_matches = 2,
                                           .confirm_s = 0.0,
                                           .confirm_travel = 0.0,
                                           .report_lost_s = 0.2,
                                           .max_lost_s = 0.3,
                                           .birth_overlap = 0.5};
  return config;
}

const Box here{40.0, 40.0, 20.0, 20.0};
const Box there{140.0, 40.0, 20.0, 20.0};

TEST(Events, EachInItsFrame) {
  const std::vector<std::pair<std::vector<Box>, std::string>> story = {
      {{here}, ""},
      {{here}, "track_started 1"},
      {{here, there}, ""},
      {{here, there}, "track_started 2"},
      {{there}, "track_lost 1"},
      {{there}, ""},
      {{here, there}, "track_recovered 1"},
      {{here}, "track_lost 2"},
      {{here}, ""},
      {{here}, ""},
      {{here}, "track_ended 2"},
      {{here}, ""},
  };
  BoxRun run(config_of_two_matches());
  for (std::size_t i = 0; i < story.size(); ++i) {
    const TrackingResult& result = run.frame(story[i].first);
    EXPECT_EQ(events_of(result), story[i].second) << "frame " << i;
    for (const Event& event : result.events) {
      EXPECT_EQ(event.index, static_cast<std::int64_t>(i));
      EXPECT_EQ(event.time_s, result.time_s);
    }
  }
}

TEST(Events, SayWhoAndWhere) {
  BoxRun run(config_of_two_matches());
  run.frame({here});
  const TrackingResult& result = run.frame({here});
  ASSERT_EQ(result.events.size(), 1U);
  const Event& event = result.events[0];
  EXPECT_EQ(event.box, result.tracks[0].box);
  EXPECT_EQ(event.position, result.tracks[0].position);
  EXPECT_EQ(event.position_covariance_px2, result.tracks[0].position_covariance_px2);
  EXPECT_GT(event.position_covariance_px2.xx, 0.0);
  EXPECT_EQ(event.text, "track 1 started");
}

TEST(Events, TheDetectorsComeFirst) {
  Tracker tracker(config_of_two_matches());
  tracker.process(detections_of({here}, 0.0, 0));
  Detections detections = detections_of({here}, 0.1, 1);
  detections.events.emplace_back().kind = EventKind::scene_changed;
  EXPECT_EQ(events_of(tracker.process(detections)), "scene_changed 0, track_started 1");
}

TEST(Events, ATrackThatEndsWhileLeavingIsLostFirst) {
  BoxRun run(config_of_two_matches(), 0.1, 100, 100);
  for (const double x : {60.0, 70.0, 78.0, 86.0}) run.frame({{x, 40.0, 20.0, 20.0}});
  EXPECT_EQ(events_of(run.frame({})), "track_lost 1, track_ended 1");
}

}  // namespace
}  // namespace survtrack
