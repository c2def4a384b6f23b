// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

// The tracker with filters along a closed path: laps, occlusions, two objects, and what is not on the path.

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "../error_message.hpp"
#include "box_run.hpp"
#include "some_paths.hpp"

namespace survtrack {
namespace {

constexpr double fps = 25.0;
const Point middle{160.0, 120.0};

Point at_angle(double radius, double angle) { return middle + Point{radius * std::cos(angle), radius * std::sin(angle)}; }

Paths ring() {
  std::vector<Point> points = circle(36, 80.0);
  for (Point& point : points) point = point + middle;
  Paths paths;
  paths.frame_width = 320;
  paths.frame_height = 240;
  paths.add("ring", Path(points, true, PathKind::curve, 20.0));
  return paths;
}

Config path_config() {
  Config config;
  config.filter = KalmanPathOptions{};
  return config;
}

BoxRun run_on_ring(const Config& config) {
  BoxRun run(config, 1.0 / fps, 320, 240);
  run.tracker().load_paths(ring());
  return run;
}

Box car(double radius, double angle) { return Box::around(at_angle(radius, angle), 16.0, 16.0); }

TEST(PathTracking, ManyLapsAreOneTrack) {
  BoxRun run = run_on_ring(path_config());
  for (int k = 0; k < 1000; ++k) {
    run.frame({car(80.0, 0.06 * k)});
    if (k < 15) continue;
    ASSERT_EQ(ids_of(run.result()), (std::vector<std::int64_t>{1})) << k;
    EXPECT_LT(distance(run.result().tracks[0].position, at_angle(80.0, 0.06 * k)), 0.3) << k;
    EXPECT_NEAR(std::hypot(run.result().tracks[0].velocity_px_per_s.x, run.result().tracks[0].velocity_px_per_s.y),
                0.06 * fps * 80.0, 3.0);
  }
}

TEST(PathTracking, TwoCarsKeepTheirIdentitiesWhereOneOvertakes) {
  BoxRun run = run_on_ring(path_config());
  for (int k = 0; k < 600; ++k) {
    run.frame({car(70.0, 0.05 * k), car(91.0, 1.0 + 0.03 * k)});
    if (k < 20) continue;
    ASSERT_EQ(ids_of(run.result()), (std::vector<std::int64_t>{1, 2})) << k;
    EXPECT_LT(distance(run.result().tracks[0].position, at_angle(70.0, 0.05 * k)), 1.0) << k;
    EXPECT_LT(distance(run.result().tracks[1].position, at_angle(91.0, 1.0 + 0.03 * k)), 1.0) << k;
  }
}

/// Root of the mean squared error of the position in px while nothing is seen.
double rms_px_while_hidden(Config config, bool paths) {
  config.lifecycle = LostCountOptions{.lost_after_frames = 1000};
  BoxRun run(config, 1.0 / fps, 320, 240);
  if (paths) run.tracker().load_paths(ring());
  double sum = 0.0;
  constexpr int seen = 60, hidden = 20;
  for (int k = 0; k < seen + hidden; ++k) {
    const double angle = 0.06 * k;
    const bool visible = k < seen;
    run.frame(visible ? std::vector<Box>{car(80.0, angle)} : std::vector<Box>{});
    if (visible) continue;
    const double off = distance(run.result().tracks.at(0).position, at_angle(80.0, angle));
    sum += off * off;
  }
  run.frame({car(80.0, 0.06 * (seen + hidden))});
  if (paths) {
    EXPECT_EQ(events_of(run.result()), "track_recovered 1");
  }
  return std::sqrt(sum / hidden);
}

TEST(PathTracking, BehindABendItKnowsTheWay) {
  const double along = rms_px_while_hidden(path_config(), true), straight = rms_px_while_hidden(Config{}, false);
  RecordProperty("along_px", std::to_string(along));
  RecordProperty("straight_px", std::to_string(straight));
  EXPECT_LT(along, 2.0);
  EXPECT_GT(straight, 20.0);
}

TEST(PathTracking, WhatIsNotOnThePathStartsNoTrackAndTakesNone) {
  for (const char* lifecycle : {"confirm_and_lose", "lost_count", "count_median", "single_largest"}) {
    Config config = path_config();
    config.set("lifecycle.model=" + std::string(lifecycle));
    config.set("assignment.model=largest");
    config.set("cost.model=distance");
    BoxRun run = run_on_ring(config);
    for (int k = 0; k < 80; ++k) {
      // A large pedestrian in the middle of the ring, and a car on it.
      run.frame({Box::around(middle, 40.0, 60.0), car(80.0, 0.06 * k)});
      ASSERT_LE(run.result().tracks.size(), 1U) << lifecycle;
      if (k > 20) {
        ASSERT_EQ(ids_of(run.result()), (std::vector<std::int64_t>{1})) << lifecycle;
        EXPECT_LT(distance(run.result().tracks[0].position, at_angle(80.0, 0.06 * k)), 1.0) << lifecycle << k;
      }
    }
    // The median of the count is that of what is on the path.
    for (int k = 0; k < 100; ++k) run.frame({Box::around(middle, 40.0, 60.0)});
    if (std::string(lifecycle) != "single_largest") {
      EXPECT_TRUE(run.result().tracks.empty()) << lifecycle;
    }
  }
}

TEST(PathTracking, PathsComeBeforeTheFirstFrame) {
  Tracker tracker(path_config());
  const std::string message = message_of<InputError>([&] { tracker.process(detections_of({}, 0.0, 0)); });
  EXPECT_TRUE(contains(message, "filter.model: \"kalman_path\" has no paths; expected load_paths()"));
  tracker.load_paths(ring());
  EXPECT_NO_THROW(tracker.process(detections_of({car(80.0, 0.0)}, 0.0, 0, 320, 240)));
  EXPECT_TRUE(contains(message_of<InputError>([&] { tracker.load_paths(ring()); }), "paths: frames were processed already"));
  EXPECT_TRUE(contains(message_of<InputError>([&] { tracker.process(detections_of({}, 1.0, 1, 640, 480)); }),
                       "frame: is 640x480 px, and the paths are drawn on frames of 320x240 px"));
  tracker.reset();
  EXPECT_NO_THROW(tracker.process(detections_of({car(80.0, 0.0)}, 0.0, 0, 320, 240)));  // they stay
  Tracker plain{Config{}};
  EXPECT_NO_THROW(plain.load_paths(ring()));  // left aside
}

}  // namespace
}  // namespace survtrack
