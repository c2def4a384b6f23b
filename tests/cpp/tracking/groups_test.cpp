// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "box_run.hpp"
#include "monitor_config.hpp"

namespace survtrack {
namespace {

constexpr double side = 20.0;

Config group_config(double max_s = 10.0) {
  Config config;
  config.time_unit_s = 0.1;
  config.filter = KalmanCvOptions{.noise_unit = NoiseUnit::px, .velocity_noise = 0.5, .position_noise = 1.0,
                                  .initial_velocity = 5.0, .lost_damping_time = 0.0};
  config.measurement = CentroidOptions{};
  config.cost = DistanceOptions{.max_distance_px = 40.0};
  config.lifecycle = LostCountOptions{.lost_after_frames = 3};
  config.groups = SharedBlobOptions{.max_s = max_s};
  return config;
}

Detection seen(const Box& box, const Color& color = {}) {
  Detection detection = detection_of_box(box);
  detection.mean_color = color;
  return detection;
}

Box around_both(const Box& a, const Box& b) {
  const double x = std::min(a.x, b.x), y = std::min(a.y, b.y);
  return {x, y, std::max(a.right(), b.right()) - x, std::max(a.bottom(), b.bottom()) - y};
}

/// One frame of two squares at these places: one blob where they touch, of their mean colour.
std::vector<Detection> two(double x, double other_x, const Color& color = {}, const Color& other_color = {}) {
  const Box a = Box::around({x, 100.0}, side, side);
  const Box b = Box::around({other_x, 104.0}, side, side);
  if (intersection_px(a, b) <= 0.0) return {seen(a, color), seen(b, other_color)};
  return {seen(around_both(a, b), {(color.blue + other_color.blue) / 2.0, (color.green + other_color.green) / 2.0,
                                   (color.red + other_color.red) / 2.0})};
}

std::string told(const TrackingResult& result) {
  std::string text;
  for (const Event& event : result.events) {
    if (event.kind == EventKind::merged || event.kind == EventKind::split) text += event.text + "; ";
  }
  return text;
}

const Track& track(const TrackingResult& result, std::int64_t id) {
  for (const Track& one : result.tracks) {
    if (one.id == id) return one;
  }
  throw std::runtime_error("no track " + std::to_string(id));
}

TEST(Groups, TwoThatPassEachOtherKeepTheirIdentities) {
  BoxRun run(group_config(), 0.1, 384, 288);
  std::string events;
  bool shared = false;
  TrackingResult last;
  for (int frame = 0; frame < 50; ++frame) {
    const double x = 60.0 + 4.0 * frame, other_x = 260.0 - 4.0 * frame;
    last = run.see(two(x, other_x));
    events += told(last);
    ASSERT_EQ(last.tracks.size(), 2U) << "frame " << frame;
    // Nobody is further off than half a blob, together or apart.
    EXPECT_NEAR(track(last, 1).position.x, x, side) << "frame " << frame;
    EXPECT_NEAR(track(last, 2).position.x, other_x, side) << "frame " << frame;
    if (track(last, 1).group == 0) continue;
    shared = true;
    EXPECT_EQ(track(last, 1).group, 1);
    EXPECT_EQ(track(last, 2).group, 1);
    EXPECT_EQ(track(last, 2).status, TrackStatus::confirmed);
    EXPECT_EQ(track(last, 1).detection, 0);
    EXPECT_EQ(track(last, 2).detection, 0);
  }
  EXPECT_TRUE(shared);
  EXPECT_EQ(events, "tracks 1 and 2 merged; tracks 1 and 2 parted; ");
  EXPECT_EQ(track(last, 1).group, 0);
}

TEST(Groups, WithoutThemOneOfTheTwoIsLost) {
  const auto lost_frames = [](const GroupOptions& groups) {
    Config config = group_config();
    config.groups = groups;
    BoxRun run(config, 0.1, 384, 288);
    int lost = 0;
    for (int frame = 0; frame < 50; ++frame) {
      for (const Track& one : run.see(two(60.0 + 4.0 * frame, 260.0 - 4.0 * frame)).tracks) {
        lost += one.status == TrackStatus::lost;
      }
    }
    return lost;
  };
  EXPECT_EQ(lost_frames(NoGroupsOptions{}), 5);  // as many frames as they are one blob
  EXPECT_EQ(lost_frames(SharedBlobOptions{}), 0);
}

// They meet, stand together and go back: where each went is known by nothing but its colour.
TEST(Groups, ColorTellsWhoIsWhoWhenTheyTurnBack) {
  const Color red{20.0, 20.0, 200.0}, blue{200.0, 20.0, 20.0};
  const auto final_colors = [&](double color_deviation) {
    Config config = group_config();
    std::get<SharedBlobOptions>(config.groups).color_deviation = color_deviation;
    BoxRun run(config, 0.1, 384, 288);
    TrackingResult last;
    for (int frame = 0; frame < 80; ++frame) {
      const int way = frame < 25 ? frame : frame < 55 ? 25 : 80 - frame;
      last = run.see(two(60.0 + 4.0 * way, 260.0 - 4.0 * way, red, blue));
    }
    return std::vector<double>{track(last, 1).mean_color.red, track(last, 2).mean_color.red};
  };
  EXPECT_EQ(final_colors(0.1), (std::vector<double>{200.0, 20.0}));
}

TEST(Groups, AThirdJoinsAndLeaves) {
  BoxRun run(group_config(), 0.1, 384, 288);
  std::string events;
  const auto standing = [](double x) { return Box::around({x, 100.0}, side, side); };
  for (int frame = 0; frame < 60; ++frame) {
    // Two meet in the middle and stay, a third passes through.
    const double way = std::min(3.0 * frame, 45.0);
    const Box a = standing(100.0 + way), b = standing(206.0 - way), c = standing(20.0 + 5.0 * frame);
    const bool both = intersection_px(a, b) > 0.0;
    std::vector<Box> blobs{a, b};
    if (both) blobs = {around_both(a, b)};
    if (intersection_px(blobs.front(), c) > 0.0) {
      blobs.front() = around_both(blobs.front(), c);
    } else {
      blobs.push_back(c);
    }
    std::vector<Detection> detections;
    for (const Box& blob : blobs) detections.push_back(seen(blob));
    const TrackingResult result = run.see(detections);
    events += told(result);
    EXPECT_EQ(result.tracks.size(), 3U) << "frame " << frame;
  }
  EXPECT_EQ(events, "tracks 1 and 2 merged; tracks 1 and 2 and 3 merged; tracks 1 and 2 and 3 parted; ");
}

TEST(Groups, WhoeverIsNotSeenForTooLongIsLost) {
  BoxRun run(group_config(1.0), 0.1, 384, 288);
  int left = -1;
  for (int frame = 0; frame < 60; ++frame) {
    const double way = std::min(4.0 * frame, 100.0);
    const TrackingResult result = run.see(two(60.0 + way, 260.0 - way));
    if (left < 0 && result.tracks.size() == 1) left = frame;
  }
  // They touch in frame 23; one second, and three frames of being lost, later one ends.
  EXPECT_GE(left, 23 + 10 + 3);
  EXPECT_LE(left, 23 + 10 + 6);
}

// Four frames a second and fewer: a step is longer than join_s.
TEST(Groups, AreFoundAtLowFrameRates) {
  BoxRun run(group_config(), 0.5, 384, 288);
  std::string events;
  for (int frame = 0; frame < 50; ++frame) events += told(run.see(two(60.0 + 4.0 * frame, 260.0 - 4.0 * frame)));
  EXPECT_EQ(events, "tracks 1 and 2 merged; tracks 1 and 2 parted; ");
}

TEST(Groups, OnlyThoseThatWereJustSeenJoin) {
  Config config = group_config();
  config.lifecycle = LostCountOptions{.lost_after_frames = 50};
  BoxRun run(config, 0.1, 384, 288);
  const Box stood = Box::around({200.0, 106.0}, side, side);
  for (int frame = 0; frame < 5; ++frame) run.frame({Box::around({60.0 + 4.0 * frame, 100.0}, side, side), stood});
  // What stood disappears; half a second later the other one walks over its place.
  for (int frame = 5; frame < 50; ++frame) {
    const TrackingResult result = run.frame({Box::around({60.0 + 4.0 * frame, 100.0}, side, side)});
    EXPECT_EQ(told(result), "");
  }
}

// A blob that vanishes as a whole takes its group with it, and says nothing of who parted.
TEST(Groups, TheBlobOfAGroupMayVanish) {
  BoxRun run(group_config(), 0.1, 384, 288);
  for (int frame = 0; frame < 24; ++frame) run.see(two(60.0 + 4.0 * frame, 260.0 - 4.0 * frame));
  std::string events;
  TrackingResult last;
  for (int frame = 0; frame < 6; ++frame) {
    last = run.see({});
    events += told(last);
  }
  EXPECT_EQ(events, "");
  EXPECT_TRUE(last.tracks.empty());
}

TEST(Groups, OfTheContactMonitorsContactsEachCountsInAGroup) {
  Config config = monitor_config(5);
  config.groups = SharedBlobOptions{};
  BoxRun run(config, 0.1, 384, 288);
  std::string events;
  for (int frame = 0; frame < 50; ++frame) {
    const TrackingResult result = run.see(two(60.0 + 4.0 * frame, 260.0 - 4.0 * frame));
    events += told(result);
    EXPECT_EQ(result.tracks.size(), 2U) << "frame " << frame;
  }
  EXPECT_EQ(events, "tracks 1 and 2 merged; tracks 1 and 2 parted; ");
}

TEST(Groups, AResetForgetsThem) {
  Tracker tracker(group_config());
  const auto result_of = [&](int frame) {
    Detections detections;
    detections.index = frame;
    detections.time_s = 0.1 * frame;
    detections.frame_width = 384;
    detections.frame_height = 288;
    detections.items = two(60.0 + 4.0 * frame, 260.0 - 4.0 * frame);
    return told(tracker.process(detections));
  };
  std::string first, second;
  for (int frame = 0; frame < 25; ++frame) first += result_of(frame);
  tracker.reset();
  for (int frame = 0; frame < 25; ++frame) second += result_of(frame);
  EXPECT_EQ(first, "tracks 1 and 2 merged; ");
  EXPECT_EQ(second, first);
}

}  // namespace
}  // namespace survtrack
