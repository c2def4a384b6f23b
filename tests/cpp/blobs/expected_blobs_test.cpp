// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

// Joining, dividing and dropping of blobs by what the tracker expects.

#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>

#include "survtrack/blobs/blob_extractor.hpp"

namespace survtrack {
namespace {

constexpr int width = 200;
constexpr int height = 100;

class ExpectedBlobs : public testing::Test {
 protected:
  void fill(int x, int y, int w, int h) { mask_(cv::Rect(x, y, w, h)) = 255; }

  void expect_track(const Box& box, double lost_s = 0.1, bool confirmed = true) {
    PredictedTrack track;
    track.id = confirmed ? static_cast<std::int64_t>(expectation_.tracks.size()) + 1 : 0;
    track.confirmed = confirmed;
    track.box = box;
    track.position = box.center();
    track.lost_s = lost_s;
    expectation_.tracks.push_back(track);
  }

  std::vector<Detection> extract(bool contours = false) {
    frame_ = cv::Mat(height, width, CV_8UC1, cv::Scalar(90));
    BlobExtractor(options_).extract(mask_, frame_, expectation_, contours, detections_);
    return detections_.items;
  }

  cv::Mat mask_ = cv::Mat::zeros(height, width, CV_8UC1);
  cv::Mat frame_;
  Expectation expectation_;
  BlobOptions options_;
  Detections detections_;
};

// ---------------------------------------------------------------- fragments

TEST_F(ExpectedBlobs, FragmentsAboveEachOtherAreJoined) {
  fill(50, 20, 10, 20);  // body
  fill(52, 44, 8, 16);   // legs; the gap of 4 is below a quarter of the taller one's 20
  const auto blobs = extract();
  ASSERT_EQ(blobs.size(), 1u);
  EXPECT_EQ(blobs[0].box, (Box{50, 20, 10, 40}));
  EXPECT_EQ(blobs[0].area_px, 10 * 20 + 8 * 16);
}

TEST_F(ExpectedBlobs, FragmentsFarApartOrSideBySideStayApart) {
  fill(50, 20, 10, 20);
  fill(50, 46, 10, 20);  // the gap of 6 is above 5
  fill(63, 20, 10, 20);  // beside
  EXPECT_EQ(extract().size(), 3u);
}

TEST_F(ExpectedBlobs, NothingIsJoinedBeyondTheHeightOfTheTrackExpectedThere) {
  fill(50, 10, 10, 30);
  fill(50, 42, 10, 30);
  EXPECT_EQ(extract().size(), 1u);
  // One person of height 30 stands there: the two together are 62 high, more than 1.2 times that.
  expect_track({50, 10, 10, 30});
  expect_track({50, 42, 10, 30});
  EXPECT_EQ(extract().size(), 2u);
}

TEST_F(ExpectedBlobs, TheScenesScaleLimitsWhereNoTrackIsExpected) {
  fill(50, 10, 10, 30);
  fill(50, 42, 10, 30);
  expectation_.scale.known = true;
  expectation_.scale.height_at_top_px = 31.0;
  EXPECT_EQ(extract().size(), 2u);
  expectation_.scale.height_at_top_px = 60.0;
  EXPECT_EQ(extract().size(), 1u);
}

TEST_F(ExpectedBlobs, JoiningIsAnOption) {
  fill(50, 20, 10, 20);
  fill(52, 44, 8, 16);
  options_.merge = NoMergeOptions{};
  EXPECT_EQ(extract().size(), 2u);
}

TEST_F(ExpectedBlobs, ChainsOfFragmentsAreJoinedWhateverTheirOrder) {
  for (int y = 10; y < 60; y += 10) fill(50 + y % 20 / 10, y, 10, 9);
  const auto blobs = extract();
  ASSERT_EQ(blobs.size(), 1u);
  EXPECT_EQ(blobs[0].area_px, 5 * 90);
}

TEST_F(ExpectedBlobs, AJoinedBlobHasTheContourOfItsLargestFragment) {
  fill(50, 20, 10, 20);
  fill(52, 44, 8, 16);
  extract(true);
  ASSERT_EQ(detections_.contours.size(), 1u);
  EXPECT_EQ(cv::boundingRect(detections_.contours[0]), cv::Rect(50, 20, 10, 20));
}

// ---------------------------------------------------------------- sharing

TEST_F(ExpectedBlobs, ABlobOverTwoTracksIsDividedBetweenThem) {
  fill(40, 30, 40, 50);
  expect_track({40, 30, 20, 50});
  expect_track({60, 30, 20, 50});
  const auto blobs = extract();
  ASSERT_EQ(blobs.size(), 2u);
  EXPECT_EQ(blobs[0].box, (Box{40, 30, 20, 50}));
  EXPECT_EQ(blobs[1].box, (Box{60, 30, 20, 50}));
  EXPECT_TRUE(blobs[0].shared);
  EXPECT_TRUE(blobs[1].shared);
  EXPECT_EQ(blobs[0].area_px + blobs[1].area_px, 40 * 50);
}

TEST_F(ExpectedBlobs, PixelsGoToTheTrackNearestInItsOwnMeasure) {
  fill(40, 30, 60, 50);
  expect_track({40, 30, 40, 50});  // twice as wide as the other: its share reaches farther
  expect_track({80, 30, 20, 50});
  const auto blobs = extract();
  ASSERT_EQ(blobs.size(), 2u);
  EXPECT_EQ(blobs[0].box, (Box{40, 30, 40, 50}));
  EXPECT_EQ(blobs[1].box, (Box{80, 30, 20, 50}));
}

TEST_F(ExpectedBlobs, WhatIsFarFromAllTracksIsABlobOfItsOwn) {
  fill(20, 30, 120, 50);
  expect_track({20, 30, 20, 50});
  expect_track({45, 30, 20, 50});
  const auto blobs = extract();
  ASSERT_EQ(blobs.size(), 3u);
  EXPECT_FALSE(blobs[2].shared);
  EXPECT_EQ(blobs[2].box.x, 45 + 10 + 16);  // beyond 1.6 half sides of the second track
  EXPECT_EQ(blobs[2].box.right(), 140);
}

TEST_F(ExpectedBlobs, ASingleTrackSharesOnlyABlobMuchLargerThanItself) {
  fill(40, 30, 30, 50);
  expect_track({40, 30, 20, 50});
  ASSERT_EQ(extract().size(), 1u);  // 1.5 times as wide
  EXPECT_FALSE(detections_.items[0].shared);
  fill(70, 30, 30, 50);
  const auto blobs = extract();  // 3 times
  ASSERT_EQ(blobs.size(), 2u);
  EXPECT_TRUE(blobs[0].shared);
}

TEST_F(ExpectedBlobs, TentativeAndLongLostTracksGetNoShare) {
  fill(40, 30, 40, 50);
  expect_track({40, 30, 20, 50}, 0.1, false);
  expect_track({60, 30, 20, 50}, 5.0);
  const auto blobs = extract();
  ASSERT_EQ(blobs.size(), 1u);
  EXPECT_FALSE(blobs[0].shared);
}

TEST_F(ExpectedBlobs, SharingIsAnOption) {
  fill(40, 30, 40, 50);
  expect_track({40, 30, 20, 50});
  expect_track({60, 30, 20, 50});
  options_.share_blobs = false;
  EXPECT_EQ(extract().size(), 1u);
}

// ---------------------------------------------------------------- dropping

TEST_F(ExpectedBlobs, TheLargerOfTheTwoAreaLimitsCounts) {
  fill(50, 20, 5, 5);
  options_.min_area_px = 25;
  options_.min_area_fraction = 0.0;
  EXPECT_EQ(extract().size(), 1u);
  options_.min_area_px = 26;
  EXPECT_EQ(extract().size(), 0u);
  options_.min_area_px = 0;
  options_.min_area_fraction = 26.0 / (width * height);
  EXPECT_EQ(extract().size(), 0u);
}

TEST_F(ExpectedBlobs, OfTooManyBlobsTheLargestAreKeptInTheirOrder) {
  options_.max_blobs = 2;
  fill(10, 10, 10, 10);
  fill(50, 12, 9, 9);
  fill(90, 14, 12, 12);
  const auto blobs = extract();
  ASSERT_EQ(blobs.size(), 2u);
  EXPECT_EQ(blobs[0].box.x, 10);
  EXPECT_EQ(blobs[1].box.x, 90);
}

TEST_F(ExpectedBlobs, LowBlobsAreDroppedUnlessExpectedOrCutByTheBorder) {
  expectation_.scale.known = true;
  expectation_.scale.height_at_top_px = 50.0;
  fill(50, 20, 30, 20);
  EXPECT_EQ(extract().size(), 0u);
  expect_track({50, 20, 30, 20});
  EXPECT_EQ(extract().size(), 1u);
  expectation_.tracks.clear();
  mask_ = 0;
  fill(50, 80, 30, 20);  // the frame ends at 100
  EXPECT_EQ(extract().size(), 1u);
}

}  // namespace
}  // namespace survtrack
