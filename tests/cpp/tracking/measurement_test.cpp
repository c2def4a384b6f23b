// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "survtrack/tracking/measurement.hpp"

#include <gtest/gtest.h>

namespace survtrack {
namespace {

Detection detection_of(const Box& box, const Point& position) {
  Detection detection;
  detection.box = box;
  detection.position = position;
  return detection;
}

OpenTrack open_track(double width, double height) {
  OpenTrack track;
  track.width_px = width;
  track.height_px = height;
  track.size_samples = 1;
  return track;
}

TEST(Measurement, CentreOrCentroid) {
  const Detection detection = detection_of({10.0, 20.0, 8.0, 4.0}, {11.0, 23.5});
  EXPECT_EQ(measured_position(BoxCenterOptions{}, detection), (Point{14.0, 22.0}));
  EXPECT_EQ(measured_position(CentroidOptions{}, detection), (Point{11.0, 23.5}));
}

TEST(Measurement, TheCentroidsBoxMovesAlong) {
  OpenTrack track = open_track(1.0, 1.0);
  learn_size(CentroidOptions{}, track, detection_of({10.0, 20.0, 8.0, 4.0}, {11.0, 23.5}), 0.1);
  EXPECT_EQ(box_at(CentroidOptions{}, track, {13.0, 22.5}), (Box{12.0, 19.0, 8.0, 4.0}));
  EXPECT_EQ(track.width_px, 8.0);
  EXPECT_EQ(track.height_px, 4.0);
}

TEST(Measurement, TheCentresBoxHasTheLearnedSize) {
  EXPECT_EQ(box_at(BoxCenterOptions{}, open_track(10.0, 20.0), {50.0, 60.0}), (Box{45.0, 50.0, 10.0, 20.0}));
}

TEST(Measurement, SizeIsAPlainMeanAtFirstAndOneWithATimeConstantLater) {
  BoxCenterOptions options;
  options.size_time_s = 0.5;
  OpenTrack track = open_track(10.0, 10.0);
  learn_size(options, track, detection_of({0.0, 0.0, 20.0, 40.0}, {}), 0.05);
  EXPECT_NEAR(track.width_px, 15.0, 1e-12);
  EXPECT_NEAR(track.height_px, 25.0, 1e-12);
  learn_size(options, track, detection_of({0.0, 0.0, 30.0, 25.0}, {}), 0.05);
  EXPECT_NEAR(track.width_px, 20.0, 1e-12);
  track.size_samples = 1000;
  learn_size(options, track, detection_of({0.0, 0.0, 30.0, 25.0}, {}), 0.05);
  EXPECT_NEAR(track.width_px, 21.0, 1e-12);  // a tenth of the way in a tenth of the time
  learn_size(options, track, detection_of({0.0, 0.0, 70.0, 25.0}, {}), 3.0);
  EXPECT_NEAR(track.width_px, 70.0, 1e-12);  // never beyond what is seen
}

Detection share_of(const Box& box) {
  Detection detection = detection_of(box, {});
  detection.shared = true;
  return detection;
}

TEST(Measurement, SharesTeachSizeByTheirWeight) {
  BoxCenterOptions options;
  options.size_time_s = 1.0;
  options.shared_size_gain = 0.2;
  OpenTrack track = open_track(10.0, 10.0);
  track.size_samples = 1000;
  learn_size(options, track, share_of({0.0, 0.0, 20.0, 20.0}), 0.5);
  EXPECT_NEAR(track.width_px, 11.0, 1e-12);
  options.shared_size_gain = 0.0;
  learn_size(options, track, share_of({0.0, 0.0, 20.0, 20.0}), 0.5);
  EXPECT_NEAR(track.width_px, 11.0, 1e-12);
}

TEST(Measurement, ABoxOfItsOwnIsSeenWhole) {
  const OpenTrack track = open_track(20.0, 40.0);
  const Detection half = detection_of({50.0, 60.0, 10.0, 40.0}, {});
  const Observation seen = observe(BoxCenterOptions{}, track, {60.0, 80.0}, half);
  EXPECT_EQ(seen.position, (Point{55.0, 80.0}));
  EXPECT_EQ(seen.extra_px2, Symmetric2{});
}

TEST(Measurement, AShareShowsTheEdgeThatFitsThePrediction) {
  BoxCenterOptions options;
  options.hidden_below = 0.85;
  const OpenTrack track = open_track(20.0, 40.0);
  const Detection half = share_of({50.0, 60.0, 10.0, 40.0});
  // Its left edge at 50 tells of a centre at 60, its right edge at 60 of one at 50.
  const Observation right_hidden = observe(options, track, {59.0, 80.0}, half);
  EXPECT_EQ(right_hidden.position, (Point{60.0, 80.0}));
  EXPECT_EQ(right_hidden.extra_px2, (Symmetric2{25.0, 0.0, 0.0}));
  EXPECT_EQ(observe(options, track, {51.0, 80.0}, half).position, (Point{50.0, 80.0}));
}

TEST(Measurement, AShareOfNearlyFullSizeIsTakenAsItIs) {
  BoxCenterOptions options;
  options.hidden_below = 0.85;
  const OpenTrack track = open_track(20.0, 40.0);
  const Observation seen = observe(options, track, {70.0, 80.0}, share_of({50.0, 60.0, 18.0, 44.0}));
  EXPECT_EQ(seen.position, (Point{59.0, 82.0}));
  EXPECT_EQ(seen.extra_px2, (Symmetric2{1.0, 0.0, 4.0}));
}

TEST(Measurement, ACentroidIsNeverInferred) {
  Detection share = share_of({50.0, 60.0, 10.0, 40.0});
  share.position = {54.0, 77.0};
  const Observation seen = observe(CentroidOptions{}, open_track(20.0, 40.0), {60.0, 80.0}, share);
  EXPECT_EQ(seen.position, (Point{54.0, 77.0}));
  EXPECT_EQ(seen.extra_px2, Symmetric2{});
}

TEST(Measurement, SizeIsTheRootOfTheArea) { EXPECT_EQ(open_track(9.0, 16.0).size_px(), 12.0); }

}  // namespace
}  // namespace survtrack
