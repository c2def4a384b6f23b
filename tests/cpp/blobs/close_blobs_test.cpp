// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

// The merge module (Narayana 2007, 4.1 and 6.4).

#include "survtrack/blobs/close_blobs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <opencv2/core.hpp>
#include <random>
#include <utility>
#include <vector>

#include "survtrack/blobs/blob_extractor.hpp"

namespace survtrack {
namespace {

class CloseBlobs : public testing::Test {
 protected:
  CloseBlobs() {
    options_.min_area_px = 0.0;
    options_.min_area_fraction = 0.0;
    options_.max_blobs = 100000;
    options_.share_blobs = false;
    options_.min_relative_height = 0.0;
    set({.threshold_y_px = 10.0, .threshold_x_px = 10.0, .color_threshold = 50.0});
  }

  void set(const CloseMergeOptions& merge) { options_.merge = merge; }

  /// A rectangle of foreground; its centroid is half a pixel before its middle.
  void fill(int x, int y, int w, int h, const cv::Scalar& color = {90, 90, 90}) {
    mask_(cv::Rect(x, y, w, h)) = 255;
    frame_(cv::Rect(x, y, w, h)) = color;
  }

  void clear(int width = 200, int height = 100) {
    mask_ = cv::Mat::zeros(height, width, CV_8UC1);
    frame_ = cv::Mat(height, width, CV_8UC3, cv::Scalar(10, 20, 30));
  }

  std::vector<Detection> extract() {
    BlobExtractor(options_).extract(mask_, frame_, expectation_, false, detections_);
    return detections_.items;
  }

  /// Two squares of 4x4 whose centroids are so far apart.
  std::size_t count_of_pair(int dx, int dy, const cv::Scalar& color = {90, 90, 90}) {
    clear();
    fill(50, 20, 4, 4);
    fill(50 + dx, 20 + dy, 4, 4, color);
    return extract().size();
  }

  std::vector<double> areas() {
    std::vector<double> found;
    for (const Detection& blob : extract()) found.push_back(blob.area_px);
    std::sort(found.begin(), found.end());
    return found;
  }

  cv::Mat mask_ = cv::Mat::zeros(100, 200, CV_8UC1);
  cv::Mat frame_ = cv::Mat(100, 200, CV_8UC3, cv::Scalar(10, 20, 30));
  Expectation expectation_;
  BlobOptions options_;
  Detections detections_;
};

// ---------------------------------------------------------------- thresholds

TEST_F(CloseBlobs, AreOneUpToEachDistance) {
  EXPECT_EQ(count_of_pair(10, 0), 1U);
  EXPECT_EQ(count_of_pair(11, 0), 2U);
  EXPECT_EQ(count_of_pair(-10, 6), 1U);
  EXPECT_EQ(count_of_pair(-11, 6), 2U);
  EXPECT_EQ(count_of_pair(0, 10), 1U);
  EXPECT_EQ(count_of_pair(0, 11), 2U);
  EXPECT_EQ(count_of_pair(10, 10), 1U);  // each direction for itself
}

TEST_F(CloseBlobs, EachDirectionHasItsThreshold) {
  set({.threshold_y_px = 6.0, .threshold_x_px = 20.0, .color_threshold = 50.0});
  EXPECT_EQ(count_of_pair(20, 6), 1U);
  EXPECT_EQ(count_of_pair(21, 6), 2U);
  EXPECT_EQ(count_of_pair(20, 7), 2U);
}

TEST_F(CloseBlobs, AreOneUpToEachDifferenceInColour) {
  EXPECT_EQ(count_of_pair(8, 0, {140, 140, 140}), 1U);
  EXPECT_EQ(count_of_pair(8, 0, {40, 140, 90}), 1U);
  EXPECT_EQ(count_of_pair(8, 0, {141, 90, 90}), 2U);
  EXPECT_EQ(count_of_pair(8, 0, {90, 39, 90}), 2U);
  EXPECT_EQ(count_of_pair(8, 0, {90, 90, 141}), 2U);
}

TEST_F(CloseBlobs, OfAGreyFrameHaveOneLevel) {
  for (const auto& [level, count] : {std::pair{140, 1U}, std::pair{141, 2U}}) {
    clear();
    frame_ = cv::Mat(mask_.size(), CV_8UC1, cv::Scalar(0));
    fill(50, 20, 4, 4);
    fill(58, 20, 4, 4, cv::Scalar(level));
    EXPECT_EQ(extract().size(), count) << level;
  }
}

TEST_F(CloseBlobs, AtExactlyTheThresholdAreOneWhereverTheyLieAndWhateverTheirSize) {
  for (int side = 1; side <= 7; ++side) {
    for (int x = 0; x < 180; x += 3) {
      clear();
      fill(x, 20, side, side);
      fill(x + 10, 20, side, side);
      ASSERT_EQ(extract().size(), 1U) << side << " at " << x;
    }
  }
}

TEST_F(CloseBlobs, AtExactlyTheThresholdAreOneWhateverTheirShape) {
  for (int x = 0; x < 180; x += 3) {
    clear();
    for (const int at : {x, x + 10}) {  // an L of three pixels: its centroid has thirds
      fill(at, 20, 1, 2);
      fill(at + 1, 21, 1, 1);
    }
    ASSERT_EQ(extract().size(), 1U) << x;
  }
}

TEST_F(CloseBlobs, AtExactlyTheColourThresholdAreOneWhateverTheirSize) {
  for (int side = 1; side <= 7; ++side) {
    for (int level = 0; level <= 205; level += 5) {
      clear();
      fill(50, 20, side, side, cv::Scalar::all(level));
      fill(59, 20, side, side, cv::Scalar::all(level + 50));
      ASSERT_EQ(extract().size(), 1U) << side << ", level " << level;
    }
  }
}

// ---------------------------------------------------------------- what is joined

TEST_F(CloseBlobs, AreJoinedInChains) {
  for (int i = 0; i < 6; ++i) fill(20 + 10 * i, 20 + i, 4, 4);
  const auto blobs = extract();
  ASSERT_EQ(blobs.size(), 1U);
  EXPECT_EQ(blobs[0].area_px, 6 * 16);
  EXPECT_EQ(blobs[0].box, (Box{20, 20, 54, 9}));
}

TEST_F(CloseBlobs, AreComparedAsTheyWereBeforeJoining) {
  // The third is within 10 px of the middle of the two, but of neither.
  fill(50, 40, 4, 4);
  fill(60, 50, 4, 4);
  fill(65, 35, 4, 4);
  EXPECT_EQ(areas(), (std::vector<double>{16, 32}));
}

TEST_F(CloseBlobs, GetTheStatisticsOfTheUnion) {
  fill(50, 20, 4, 4, {90, 60, 30});    // 16 px about (51.5, 21.5)
  fill(56, 22, 8, 6, {120, 60, 70});   // 48 px about (59.5, 24.5)
  const auto blobs = extract();
  ASSERT_EQ(blobs.size(), 1U);
  EXPECT_EQ(blobs[0].area_px, 64.0);
  EXPECT_EQ(blobs[0].box, (Box{50, 20, 14, 8}));
  EXPECT_DOUBLE_EQ(blobs[0].position.x, (16 * 51.5 + 48 * 59.5) / 64);
  EXPECT_DOUBLE_EQ(blobs[0].position.y, (16 * 21.5 + 48 * 24.5) / 64);
  EXPECT_DOUBLE_EQ(blobs[0].mean_color.blue, (16 * 90 + 48 * 120) / 64.0);
  EXPECT_DOUBLE_EQ(blobs[0].mean_color.green, 60.0);
  EXPECT_DOUBLE_EQ(blobs[0].mean_color.red, (16 * 30 + 48 * 70) / 64.0);
  EXPECT_DOUBLE_EQ(blobs[0].moments_px2.xx,
                   16.0 / 64 * (1.25 + 6.0 * 6.0) + 48.0 / 64 * (5.25 + 2.0 * 2.0));  // (n^2 - 1)/12, and the shifts
}

TEST_F(CloseBlobs, AreNotBridgedByNoise) {
  fill(50, 20, 6, 6);
  fill(60, 20, 2, 2);
  fill(66, 20, 6, 6);
  EXPECT_EQ(extract().size(), 1U);
  options_.min_area_px = 5.0;
  EXPECT_EQ(areas(), (std::vector<double>{36, 36}));
}

TEST_F(CloseBlobs, KeepTheRasterOrderOfTheirFirstPixels) {
  fill(100, 10, 4, 4);
  fill(20, 12, 4, 4);
  fill(104, 16, 4, 4);  // to the first
  const auto blobs = extract();
  ASSERT_EQ(blobs.size(), 2U);
  EXPECT_EQ(blobs[0].area_px, 32.0);
  EXPECT_EQ(blobs[1].box.x, 20.0);
}

TEST_F(CloseBlobs, AreTheSameInAMirror) {
  std::mt19937 random(8);
  for (int round = 0; round < 20; ++round) {
    clear();
    for (int i = 0; i < 60; ++i) {
      const int x = static_cast<int>(random() % 196), y = static_cast<int>(random() % 96);
      fill(x, y, 1 + static_cast<int>(random() % 4), 1 + static_cast<int>(random() % 4),
           cv::Scalar::all(static_cast<double>(random() % 200)));
    }
    set({.threshold_y_px = 8.4, .threshold_x_px = 6.3, .color_threshold = 50.35});  // no mean is just as far
    const auto expected = areas();
    for (const int axis : {0, 1, -1}) {
      const cv::Mat mask = mask_.clone(), frame = frame_.clone();
      cv::flip(mask, mask_, axis);
      cv::flip(frame, frame_, axis);
      EXPECT_EQ(areas(), expected) << "round " << round << ", axis " << axis;
      mask.copyTo(mask_);
      frame.copyTo(frame_);
    }
  }
}

// ---------------------------------------------------------------- vicinity

class ScaledCloseBlobs : public CloseBlobs {
 protected:
  ScaledCloseBlobs() {
    set({.threshold_y_px = 10.0, .threshold_x_px = 10.0, .color_threshold = 50.0, .vicinity_scaled = true});
    VicinityGrid grid;
    grid.cell_px = 10;
    grid.frame_width = 200;
    grid.frame_height = 100;
    grid.rows = 10;
    grid.columns = 20;
    grid.max_factor = 5.0;
    grid.cells.resize(200);
    expectation_.vicinity = grid;
  }

  VicinityCell& cell(double x, double y) { return expectation_.vicinity->cells[expectation_.vicinity->index_of({x, y})]; }
};

TEST_F(ScaledCloseBlobs, TakeTheFactorHalfWay) {
  EXPECT_EQ(count_of_pair(20, 0), 2U);
  cell(55.0, 25.0).factor_x = cell(75.0, 25.0).factor_x = 5.0;  // about each, but not between
  EXPECT_EQ(count_of_pair(20, 0), 2U);
  cell(62.0, 22.0).factor_x = 2.0;
  EXPECT_EQ(count_of_pair(20, 0), 1U);
  EXPECT_EQ(count_of_pair(21, 0), 2U);
}

TEST_F(ScaledCloseBlobs, ScaleEachDirectionForItself) {
  cell(51.0, 31.0).factor_x = 5.0;
  EXPECT_EQ(count_of_pair(0, 18), 2U);
  cell(51.0, 31.0).factor_y = 1.8;
  EXPECT_EQ(count_of_pair(0, 18), 1U);
  EXPECT_EQ(count_of_pair(0, 19), 2U);
}

TEST_F(ScaledCloseBlobs, ReachAsFarAsTheLargestFactor) {
  for (VicinityCell& each : expectation_.vicinity->cells) each.factor_y = each.factor_x = 5.0;
  EXPECT_EQ(count_of_pair(50, 50), 1U);
  EXPECT_EQ(count_of_pair(51, 0), 2U);
  EXPECT_EQ(count_of_pair(0, 51), 2U);
}

TEST_F(ScaledCloseBlobs, AreTakenAsTheyAreUntilThereIsAGrid) {
  expectation_.vicinity.reset();
  EXPECT_EQ(count_of_pair(10, 0), 1U);
  EXPECT_EQ(count_of_pair(11, 0), 2U);
}

TEST_F(ScaledCloseBlobs, AreNotScaledUnlessAsked) {
  for (VicinityCell& each : expectation_.vicinity->cells) each.factor_y = each.factor_x = 5.0;
  set({.threshold_y_px = 10.0, .threshold_x_px = 10.0, .color_threshold = 50.0, .vicinity_scaled = false});
  EXPECT_EQ(count_of_pair(11, 0), 2U);
}

// ---------------------------------------------------------------- many

TEST_F(CloseBlobs, AThousandApartOrTogether) {
  for (const auto& [step, count] : {std::pair{11, 1000U}, std::pair{10, 1U}}) {
    clear(40 * 11, 25 * 11);
    for (int i = 0; i < 1000; ++i) fill(i % 40 * step, i / 40 * step, 4, 4);
    EXPECT_EQ(extract().size(), count);
  }
}

TEST_F(CloseBlobs, NoneAtAll) { EXPECT_TRUE(extract().empty()); }

}  // namespace
}  // namespace survtrack
