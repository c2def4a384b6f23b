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
  const BoxCenterOptions options{.size_time_s = 0.5};
  OpenTrack track = open_track(10.0, 10.0);
  EXPECT_TRUE(learn_size(options, track, detection_of({0.0, 0.0, 20.0, 40.0}, {}), 0.05));
  EXPECT_NEAR(track.width_px, 15.0, 1e-12);
  EXPECT_NEAR(track.height_px, 25.0, 1e-12);
  EXPECT_TRUE(learn_size(options, track, detection_of({0.0, 0.0, 30.0, 25.0}, {}), 0.05));
  EXPECT_NEAR(track.width_px, 20.0, 1e-12);
  track.size_samples = 1000;
  learn_size(options, track, detection_of({0.0, 0.0, 30.0, 25.0}, {}), 0.05);
  EXPECT_NEAR(track.width_px, 21.0, 1e-12);  // a tenth of the way in a tenth of the time
  learn_size(options, track, detection_of({0.0, 0.0, 70.0, 25.0}, {}), 3.0);
  EXPECT_NEAR(track.width_px, 70.0, 1e-12);  // never beyond what is seen
}

TEST(Measurement, NothingIsLearnedFromSharesAndInGroups) {
  OpenTrack track = open_track(10.0, 10.0);
  Detection detection = detection_of({0.0, 0.0, 30.0, 30.0}, {});
  detection.shared = true;
  EXPECT_FALSE(learn_size(BoxCenterOptions{}, track, detection, 0.1));
  detection.shared = false;
  track.grouped = true;
  EXPECT_FALSE(learn_size(BoxCenterOptions{}, track, detection, 0.1));
  EXPECT_EQ(track.width_px, 10.0);
  EXPECT_EQ(track.size_samples, 1);
}

TEST(Measurement, SizeIsTheRootOfTheArea) { EXPECT_EQ(open_track(9.0, 16.0).size_px(), 12.0); }

}  // namespace
}  // namespace survtrack
