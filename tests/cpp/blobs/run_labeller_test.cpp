// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "survtrack/blobs/run_labeller.hpp"

#include <gtest/gtest.h>

#include <map>
#include <opencv2/imgproc.hpp>

#include "survtrack/core/errors.hpp"

namespace survtrack {
namespace {

cv::Mat mask_of(const std::vector<std::string>& rows) {
  cv::Mat mask(static_cast<int>(rows.size()), static_cast<int>(rows[0].size()), CV_8UC1);
  for (int y = 0; y < mask.rows; ++y) {
    for (int x = 0; x < mask.cols; ++x) {
      mask.at<std::uint8_t>(y, x) = rows[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)] == '#' ? 255 : 0;
    }
  }
  return mask;
}

/// Labels a pixel, -1: background; checks that the runs come in order and do not overlap.
cv::Mat painted(const std::vector<Run>& runs, const cv::Size& size) {
  cv::Mat labels(size, CV_32SC1, cv::Scalar(-1));
  const Run* before = nullptr;
  for (const Run& run : runs) {
    EXPECT_LT(run.x_begin, run.x_end);
    EXPECT_TRUE(before == nullptr || before->y < run.y || (before->y == run.y && before->x_end < run.x_begin));
    before = &run;
    labels.row(run.y).colRange(run.x_begin, run.x_end).setTo(run.label);
  }
  return labels;
}

/// The same components, and numbered in the order of their first pixels.
void expect_like_opencv(RunLabeller& labeller, const cv::Mat& mask, int connectivity = 8) {
  const cv::Mat labels = painted(labeller.label(mask), mask.size());
  cv::Mat expected;
  const int count = cv::connectedComponents(mask, expected, connectivity, CV_32S) - 1;
  ASSERT_EQ(labeller.count(), count) << mask.size();
  std::map<int, int> label_of;
  for (int y = 0; y < mask.rows; ++y) {
    for (int x = 0; x < mask.cols; ++x) {
      const int theirs = expected.at<int>(y, x);
      const int ours = labels.at<int>(y, x);
      ASSERT_EQ(ours >= 0, theirs > 0) << x << ", " << y;
      if (theirs == 0) continue;
      const auto next = static_cast<int>(label_of.size());
      ASSERT_EQ(ours, label_of.emplace(theirs, next).first->second) << x << ", " << y << " of " << mask.size();
    }
  }
}

TEST(RunLabeller, NumbersComponentsByTheirFirstPixels) {
  RunLabeller labeller;
  const auto& runs = labeller.label(mask_of({"..#.#", "##..#", "....#"}));
  ASSERT_EQ(labeller.count(), 2);
  ASSERT_EQ(runs.size(), 5U);
  const auto expect_run = [&](std::size_t i, int y, int x_begin, int x_end, int label) {
    EXPECT_EQ(runs[i].y, y);
    EXPECT_EQ(runs[i].x_begin, x_begin);
    EXPECT_EQ(runs[i].x_end, x_end);
    EXPECT_EQ(runs[i].label, label);
  };
  expect_run(0, 0, 2, 3, 0);
  expect_run(1, 0, 4, 5, 1);
  expect_run(2, 1, 0, 2, 0);  // meets the first at a corner
  expect_run(3, 1, 4, 5, 1);
  expect_run(4, 2, 4, 5, 1);
}

TEST(RunLabeller, FourNeighboursDoNotMeetAtCorners) {
  RunLabeller four(Connectivity::four);
  const cv::Mat chess = mask_of({"##..", "..##", "##.."});
  four.label(chess);
  EXPECT_EQ(four.count(), 3);
  RunLabeller eight;
  eight.label(chess);
  EXPECT_EQ(eight.count(), 1);
  four.label(mask_of({".##.", "##..", ".##."}));
  EXPECT_EQ(four.count(), 1);
}

TEST(RunLabeller, FourConnectedMasksAreLikeOpenCvs) {
  RunLabeller labeller(Connectivity::four);
  cv::RNG random(9);
  for (int i = 0; i < 60; ++i) {
    cv::Mat noise(random.uniform(1, 40), random.uniform(1, 150), CV_8UC1);
    random.fill(noise, cv::RNG::UNIFORM, 0, 256);
    expect_like_opencv(labeller, noise > random.uniform(40, 220), 4);
  }
}

TEST(RunLabeller, JoinsWhatMeetsFurtherDown) {
  RunLabeller labeller;
  const auto& runs = labeller.label(mask_of({"#.#.#.#", "#.#.#.#", "#####.#", "......#"}));
  EXPECT_EQ(labeller.count(), 2);
  for (const auto& run : runs) EXPECT_EQ(run.label, run.x_begin == 6 ? 1 : 0);
}

TEST(RunLabeller, AnyValueButZeroIsForeground) {
  cv::Mat mask(1, 255, CV_8UC1);
  for (int i = 0; i < 255; ++i) mask.at<std::uint8_t>(0, i) = static_cast<std::uint8_t>(i + 1);
  RunLabeller labeller;
  EXPECT_EQ(labeller.label(mask).size(), 1U);
  EXPECT_EQ(labeller.count(), 1);
}

TEST(RunLabeller, EmptyAndFullMasks) {
  RunLabeller labeller;
  for (const cv::Size size : {cv::Size(1, 1), {64, 2}, {65, 3}, {300, 200}}) {
    EXPECT_TRUE(labeller.label(cv::Mat(cv::Mat::zeros(size, CV_8UC1))).empty());
    EXPECT_EQ(labeller.count(), 0);
    EXPECT_EQ(labeller.label(cv::Mat(size, CV_8UC1, cv::Scalar(255))).size(), static_cast<std::size_t>(size.height));
    EXPECT_EQ(labeller.count(), 1);
  }
}

TEST(RunLabeller, MatchesOpenCvOnRandomMasks) {
  cv::RNG random(21);
  RunLabeller labeller;
  for (const cv::Size size : {cv::Size(1, 1), {1, 30}, {300, 1}, {7, 5}, {63, 20}, {64, 20}, {65, 20}, {190, 90}}) {
    for (int percent = 0; percent <= 100; percent += 5) {
      cv::Mat levels(size, CV_8UC1);
      random.fill(levels, cv::RNG::UNIFORM, 0, 100);
      expect_like_opencv(labeller, levels < percent);
    }
  }
}

TEST(RunLabeller, MatchesOpenCvOnStridedViews) {
  cv::RNG random(22);
  RunLabeller labeller;
  for (int width = 1; width < 140; width += 6) {
    cv::Mat levels(40, 150, CV_8UC1);
    random.fill(levels, cv::RNG::UNIFORM, 0, 100);
    const cv::Mat mask = levels < 40;
    expect_like_opencv(labeller, mask(cv::Rect(7, 3, width, 30)));
  }
}

TEST(RunLabeller, LongSpiralIsOneComponent) {
  // Many provisional labels that join late, in a chain.
  cv::Mat mask = cv::Mat::zeros(201, 201, CV_8UC1);
  for (int ring = 0; ring < 50; ++ring) {
    cv::rectangle(mask, cv::Rect(4 * ring / 2, 4 * ring / 2, 201 - 4 * ring, 201 - 4 * ring), 255);
    if (ring > 0) mask.at<std::uint8_t>(199 - 2 * ring + 2, 100) = 255;
  }
  RunLabeller labeller;
  labeller.label(mask);
  EXPECT_EQ(labeller.count(), 1);
  expect_like_opencv(labeller, mask);
}

TEST(RunLabeller, RefusesWhatIsNoMask) {
  RunLabeller labeller;
  EXPECT_THROW(labeller.label(cv::Mat()), InputError);
  EXPECT_THROW(labeller.label(cv::Mat(3, 3, CV_8UC3, cv::Scalar::all(0))), InputError);
  EXPECT_THROW(labeller.label(cv::Mat(3, 3, CV_32SC1, cv::Scalar(0))), InputError);
}

}  // namespace
}  // namespace survtrack
