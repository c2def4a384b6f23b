// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "../error_message.hpp"
#include "../tracking/box_run.hpp"
#include "fingerprint.hpp"
#include "synthetic_scene.hpp"

namespace survtrack {
namespace {

std::vector<Box> two_boxes(int frame) {
  return {{10.0 + 2.0 * frame, 20.0, 20.0, 30.0}, {200.0 - 3.0 * frame, 80.0, 25.0, 25.0}};
}

Detections frame_of(int frame) { return detections_of(two_boxes(frame), 0.1 * frame, frame); }

TEST(TrackerOnBoxes, FollowsThemWithoutAFrameSize) {
  Tracker tracker(scene_config());
  TrackingResult result;
  for (int frame = 0; frame < 30; ++frame) result = tracker.process(frame_of(frame));
  ASSERT_EQ(ids_of(result), (std::vector<std::int64_t>{1, 2}));
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_GT(iou(result.tracks[i].box, two_boxes(29)[i]), 0.9);
    EXPECT_EQ(result.tracks[i].detection, static_cast<int>(i));
    EXPECT_NEAR(result.tracks[i].velocity_px_per_s.x, i == 0 ? 20.0 : -30.0, 1.5);
  }
}

TEST(TrackerOnBoxes, BadOnesAreRefusedByNameAndTheRunGoesOn) {
  const double nan = std::nan("");
  const auto box = [](const Box& b) { return [b](Detection& d) { d.box = b; }; };
  const std::vector<std::pair<std::function<void(Detection&)>, std::string>> spoilers = {
      {box({nan, 1.0, 2.0, 2.0}), "detections[1].box: (nan"},
      {box({1.0, nan, 2.0, 2.0}), "detections[1].box: "},
      {box({1.0, 1.0, nan, 2.0}), "detections[1].box: "},
      {box({1.0, 1.0, 2.0, nan}), "detections[1].box: "},
      {box({HUGE_VAL, 1.0, 2.0, 2.0}), "detections[1].box: (inf"},
      {box({1.0, -HUGE_VAL, 2.0, 2.0}), "detections[1].box: "},
      {box({1.0, 1.0, 0.0, 2.0}), "detections[1].box: "},
      {box({1.0, 1.0, 2.0, -5.0}), "detections[1].box: "},
      {box({1.0, 1.0, -2.0, -5.0}), "detections[1].box: "},
      {box({1e30, 1.0, 2.0, 5.0}), "detections[1].box: "},
      {box({1.0, 1.0, 1e30, 5.0}), "detections[1].box: "},
      {[=](Detection& d) { d.position.x = nan; }, "detections[1]."},
      {[=](Detection& d) { d.mean_color.green = nan; }, "detections[1].mean_color: "},
  };
  Tracker disturbed(scene_config()), quiet(scene_config());
  for (int frame = 0; frame < 20; ++frame) {
    for (const auto& [spoil, message] : spoilers) {
      Detections bad = frame_of(frame);
      spoil(bad.items[1]);
      EXPECT_TRUE(contains(message_of<InputError>([&] { disturbed.process(bad); }), message));
    }
    EXPECT_EQ(fingerprint(disturbed.process(frame_of(frame))), fingerprint(quiet.process(frame_of(frame))));
  }
}

TEST(TrackerOnBoxes, TimesMustIncrease) {
  Tracker tracker(scene_config());
  tracker.process(frame_of(3));
  EXPECT_TRUE(contains(message_of<InputError>([&] { tracker.process(frame_of(3)); }), "time_s: ", "does not come after"));
  EXPECT_THROW(tracker.process(frame_of(1)), InputError);
  EXPECT_THROW(tracker.predict(std::nan("")), InputError);
  EXPECT_NO_THROW(tracker.process(frame_of(4)));
  tracker.reset();
  EXPECT_NO_THROW(tracker.process(frame_of(1)));
}

TEST(TrackerOnBoxes, OneUpdateAfterEachPredict) {
  Tracker tracker(scene_config());
  TrackingResult result;
  EXPECT_TRUE(contains(message_of<InputError>([&] { tracker.update(frame_of(0), result); }), "detections.time_s: ", "predict()"));
  tracker.predict(0.1);
  EXPECT_TRUE(contains(message_of<InputError>([&] { tracker.update(frame_of(2), result); }), "detections.time_s: 0.2"));
  EXPECT_NO_THROW(tracker.update(frame_of(1), result));
  EXPECT_THROW(tracker.update(frame_of(1), result), InputError);
}

TEST(TrackerOnBoxes, ExpectationSaysWhereTracksWillBe) {
  Tracker tracker(scene_config());
  TrackingResult result;
  for (int frame = 0; frame < 20; ++frame) result = tracker.process(frame_of(frame));
  const Expectation& expectation = tracker.predict(2.0);
  EXPECT_EQ(expectation.time_s, 2.0);
  ASSERT_EQ(expectation.tracks.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    const PredictedTrack& track = expectation.tracks[i];
    EXPECT_TRUE(track.confirmed);
    EXPECT_EQ(track.id, static_cast<std::int64_t>(i) + 1);
    EXPECT_GT(iou(track.box, two_boxes(20)[i]), 0.85);
    EXPECT_GT(track.innovation_covariance_px2.xx, 0.0);
    EXPECT_NEAR(track.lost_s, 0.1, 1e-12);  // since frame 19
    EXPECT_EQ(track.velocity_px_per_s, result.tracks[i].velocity_px_per_s);
  }
}

TEST(TrackerOnBoxes, LearnsTheScaleOfASceneWhoseSizeIsKnown) {
  for (const int frame_height : {300, 0}) {
    Tracker tracker(scene_config());
    for (int i = 0; i < 250; ++i) {
      const std::vector<Box> boxes = {{20.0 + i, 160.0, 20.0, 40.0}, {20.0 + i, 40.0, 10.0, 20.0}};
      tracker.process(detections_of(boxes, 0.1 * i, i, frame_height == 0 ? 0 : 400, frame_height));
    }
    const SceneScale scale = tracker.predict(25.0).scale;
    ASSERT_EQ(scale.known, frame_height != 0);
    if (!scale.known) continue;
    EXPECT_NEAR(scale.height_px(200.0), 40.0, 4.0);
    EXPECT_NEAR(scale.height_px(60.0), 20.0, 4.0);
  }
}

TEST(TrackerOnBoxes, ResetStartsAnew) {
  Tracker tracker(scene_config()), fresh(scene_config());
  for (int frame = 0; frame < 15; ++frame) tracker.process(frame_of(frame));
  tracker.reset();
  for (int frame = 0; frame < 15; ++frame) {
    EXPECT_EQ(fingerprint(tracker.process(frame_of(frame))), fingerprint(fresh.process(frame_of(frame))));
  }
}

TEST(TrackerOnBoxes, FiveHundredOverTenFrames) {
  const auto grid = [](int frame) {
    std::vector<Box> boxes;
    for (int i = 0; i < 500; ++i) {
      boxes.push_back({60.0 * (i % 25) + 2.0 * frame, 60.0 * (i / 25) + 1.0 * frame, 20.0, 20.0});
    }
    return boxes;
  };
  Tracker tracker(scene_config());
  TrackingResult result;
  for (int frame = 0; frame < 10; ++frame) result = tracker.process(detections_of(grid(frame), 0.1 * frame, frame));
  ASSERT_EQ(result.tracks.size(), 500U);
  for (std::size_t i = 0; i < 500; ++i) {
    EXPECT_EQ(result.tracks[i].id, static_cast<std::int64_t>(i) + 1);
    EXPECT_EQ(result.tracks[i].detection, static_cast<int>(i));
    EXPECT_EQ(result.tracks[i].matched_frames, 10);
  }
}

TEST(TrackerOnBoxes, AWholeMatrixOfCostsHasALimit) {
  Config config = scene_config();
  config.outputs.cost_matrix = true;
  Tracker tracker(config);
  const TrackingResult first = tracker.process(frame_of(0));
  EXPECT_EQ(first.costs.rows(), 0);
  const TrackingResult second = tracker.process(frame_of(1));
  EXPECT_EQ(second.costs.rows(), 2);
  EXPECT_EQ(second.costs.columns(), 2);
  EXPECT_EQ(second.costs(0, 0), second.matches.candidates.at(0).cost);
  const std::vector<Box> many(500'001, Box{0.0, 0.0, 10.0, 10.0});
  EXPECT_TRUE(contains(message_of<InputError>([&] { tracker.process(detections_of(many, 0.2, 2)); }),
                       "outputs.cost_matrix: 2 tracks by 500001 detections"));
  EXPECT_NO_THROW(tracker.process(frame_of(2)));
}

}  // namespace
}  // namespace survtrack
