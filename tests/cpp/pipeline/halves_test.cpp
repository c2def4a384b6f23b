// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include <gtest/gtest.h>

#include <opencv2/core.hpp>
#include <vector>

#include "../error_message.hpp"
#include "scene_run.hpp"

namespace survtrack {
namespace {

const SyntheticScene scene{.width = 96, .height = 80};

class Halves : public testing::TestWithParam<Config> {};

TEST_P(Halves, ComposedByHandAreThePipeline) {
  const std::vector<double> times_s = steady_times(10.0, 40);
  Pipeline pipeline(GetParam());
  const std::vector<FrameResult> expected = run_scene(pipeline, scene, times_s);
  Detector detector(GetParam());
  Tracker tracker(GetParam());
  EXPECT_EQ(detector.delay_frames(), pipeline.delay_frames());
  std::size_t next = 0;
  const auto step = [&] {
    const TimedFrame frame = detector.next();
    Detections detections;
    TrackingResult result;
    detector.detect(tracker.predict(frame.time_s), detections);
    tracker.update(detections, result);
    ASSERT_EQ(fingerprint(result), fingerprint(static_cast<const TrackingResult&>(expected.at(next)))) << next;
    ASSERT_EQ(fingerprint(detections), fingerprint(expected[next].detections)) << next;
    ++next;
  };
  for (const double time_s : times_s) {
    if (detector.push(scene.frame(time_s), time_s)) step();
  }
  detector.end_of_source();
  while (detector.due()) step();
  EXPECT_EQ(next, times_s.size());
}

TEST_P(Halves, TheDetectorAloneGivesEveryFrame) {
  Detector detector(GetParam());
  std::vector<Detections> all;
  for (int i = 0; i < 40; ++i) {
    if (auto detections = detector.process(scene.frame(0.1 * i), 0.1 * i, 2 * i)) all.push_back(std::move(*detections));
  }
  for (Detections& detections : detector.finish()) all.push_back(std::move(detections));
  ASSERT_EQ(all.size(), 40U);
  for (int i = 0; i < 40; ++i) {
    const Detections& detections = all[static_cast<std::size_t>(i)];
    EXPECT_EQ(detections.index, 2 * i);
    EXPECT_EQ(detections.time_s, 0.1 * i);
    EXPECT_EQ(detections.frame_width, 96);
    EXPECT_EQ(detections.frame_height, 80);
    EXPECT_EQ(detections.mask.size(), cv::Size(96, 80));
    EXPECT_EQ(detections.regions, (std::vector<Region>{{{0.0, 0.0, 96.0, 80.0}, RegionKind::whole_frame, 0}}));
  }
  EXPECT_EQ(all[20].items.size(), 1U);  // the square, in the middle
  detector.reset();
  EXPECT_NO_THROW(detector.process(scene.frame(0.0), 0.0));
}

TEST_P(Halves, AnExpectationOfAnotherTimeIsRefusedAndTheFrameStaysDue) {
  Detector detector(GetParam());
  int pushed = 0;
  while (!detector.push(scene.frame(0.1 * pushed), 0.1 * pushed)) ++pushed;
  Detections detections;
  Expectation wrong;
  wrong.time_s = 0.05;
  EXPECT_TRUE(contains(message_of<InputError>([&] { detector.detect(wrong, detections); }), "expectation.time_s: 0.05"));
  Expectation right;
  right.time_s = detector.next().time_s;
  Expectation in_parts = right;
  in_parts.regions = {{{200.0, 0.0, 10.0, 10.0}, RegionKind::predicted, 0}};
  EXPECT_TRUE(contains(message_of<InputError>([&] { detector.detect(in_parts, detections); }), "expectation.regions"));
  EXPECT_TRUE(detector.due());
  EXPECT_NO_THROW(detector.detect(right, detections));
  EXPECT_EQ(detections.index, 0);
}

TEST_P(Halves, StepsOutOfTurnAreRefused) {
  Detector detector(GetParam());
  Detections detections;
  EXPECT_TRUE(contains(message_of<InputError>([&] { detector.detect({}, detections); }), "none is due"));
  EXPECT_TRUE(contains(message_of<InputError>([&] { static_cast<void>(detector.next()); }), "none is due"));
  int pushed = 0;
  while (!detector.push(scene.frame(0.1 * pushed), 0.1 * pushed)) ++pushed;
  EXPECT_TRUE(contains(message_of<InputError>([&] { detector.push(scene.frame(90.0), 90.0); }), "detect()"));
  Expectation expectation;
  expectation.time_s = detector.next().time_s;
  detector.detect(expectation, detections);
  EXPECT_FALSE(detector.due());
  EXPECT_THROW(detector.detect(expectation, detections), InputError);
}

INSTANTIATE_TEST_SUITE_P(Configs, Halves, testing::Values(scene_config(), delayed_config(20)),
                         [](const auto& tested) { return tested.index == 0 ? "direct" : "delayed"; });

}  // namespace
}  // namespace survtrack
