// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include <gtest/gtest.h>

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "../simd_levels.hpp"
#include "random_masks.hpp"
#include "survtrack/core/errors.hpp"
#include "survtrack/segmentation/cleanup.hpp"

namespace survtrack {
namespace {

CleanupOptions over(int frames) { return {.median_px = 0, .temporal_median_frames = frames}; }

bool same(const cv::Mat& a, const cv::Mat& b) { return a.size() == b.size() && cv::norm(a, b, cv::NORM_INF) == 0; }

cv::Mat next(Cleanup& cleanup, const cv::Mat& mask) {
  cv::Mat result = mask.clone();
  cleanup.apply(result);
  return result;
}

/// What a pixel becomes, mask after mask: '1' is foreground.
std::string answers(Cleanup& cleanup, const std::string& masks) {
  std::string text;
  for (const char one : masks) {
    const cv::Mat mask(3, 70, CV_8UC1, cv::Scalar(one == '1' ? 255 : 0));
    const cv::Mat result = next(cleanup, mask);
    EXPECT_EQ(cv::norm(result, cv::Mat(3, 70, CV_8UC1, cv::Scalar(result.at<std::uint8_t>(0, 0))), cv::NORM_INF), 0);
    text += result.at<std::uint8_t>(0, 0) == 255 ? '1' : '0';
  }
  return text;
}

TEST(TemporalMedian, IsTheMajorityOfTheLastMasks) {
  Cleanup three(over(3));
  // Two of three; the first mask stands alone, and of two both are needed.
  EXPECT_EQ(answers(three, "1011010001110"), "1011110000111");
  three.reset();
  EXPECT_EQ(answers(three, "0110"), "0011");
  three.reset();
  EXPECT_EQ(answers(three, "11"), "11");
  Cleanup five(over(5));
  EXPECT_EQ(answers(five, "1100011100"), "1110000111");
}

class TemporalMedianLevels : public AtEverySimdLevel {};

TEST_P(TemporalMedianLevels, MatchesCounting) {
  cv::RNG random(21);
  for (const int frames : {3, 5, 7, 9, 15, 31, 127}) {
    Cleanup cleanup(over(frames));
    for (const cv::Size size : {cv::Size(1, 1), {65, 7}, {128, 30}, {200, 150}}) {
      cleanup.reset();
      std::vector<cv::Mat> masks;
      for (int k = 0; k < std::min(2 * frames + 3, 60); ++k) {
        masks.push_back(random_mask(random, size, random.uniform(20, 80)));
        cv::Mat sum = cv::Mat::zeros(size, CV_32SC1);
        const int there = std::min(k + 1, frames);
        for (int i = k + 1 - there; i <= k; ++i) cv::add(sum, masks[static_cast<std::size_t>(i)] / 255, sum, {}, CV_32S);
        cv::Mat larger(size.height + 5, size.width + 9, CV_8UC1, cv::Scalar(77));
        cv::Mat view = larger(cv::Rect({4, 2}, size));
        masks.back().copyTo(view);
        cleanup.apply(view);
        ASSERT_TRUE(same(view, 2 * sum > there)) << frames << ", " << size << ", " << k;
        view.setTo(77);
        ASSERT_EQ(cv::countNonZero(larger != 77), 0) << "wrote beyond the mask";
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Levels, TemporalMedianLevels, testing::ValuesIn(simd_levels()), simd_level_name);

TEST(TemporalMedian, ComesBeforeTheOtherSteps) {
  cv::RNG random(23);
  Cleanup all({.median_px = 5, .open_px = 3, .temporal_median_frames = 3}), first(over(3)), rest({.median_px = 5, .open_px = 3});
  for (int k = 0; k < 6; ++k) {
    const cv::Mat mask = random_mask(random, {90, 70}, 60);
    EXPECT_TRUE(same(next(all, mask), next(rest, next(first, mask))));
  }
}

TEST(TemporalMedian, ZeroAndOneAreOff) {
  cv::RNG random(25);
  for (const int frames : {0, 1}) {
    Cleanup cleanup(over(frames));
    for (const cv::Size size : {cv::Size(20, 30), {40, 10}}) {
      const cv::Mat mask = random_mask(random, size, 50);
      EXPECT_TRUE(same(next(cleanup, mask), mask));
    }
  }
}

TEST(TemporalMedian, RefusesAnotherSizeAndKeepsItsState) {
  Cleanup cleanup(over(3)), undisturbed(over(3));
  const cv::Mat full(3, 70, CV_8UC1, cv::Scalar(255)), empty = cv::Mat::zeros(3, 70, CV_8UC1);
  cv::Mat other(4, 70, CV_8UC1, cv::Scalar(9));
  next(cleanup, full);
  next(undisturbed, full);
  try {
    cleanup.apply(other);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(),
                 "mask: is 4x70, the masks before were 3x70; temporal_median_frames takes one size (reset() starts another)");
  }
  EXPECT_EQ(cv::countNonZero(other != 9), 0);
  for (const cv::Mat& mask : {full, empty, empty}) EXPECT_TRUE(same(next(cleanup, mask), next(undisturbed, mask)));
  cleanup.reset();
  EXPECT_NO_THROW(cleanup.apply(other));
}

TEST(TemporalMedian, AMaskTooSmallForTheTilesLeavesTheStateAlone) {
  CleanupOptions options = over(3);
  options.tiling = QuadrantsOptions{};
  Cleanup cleanup(options);
  cv::Mat small = cv::Mat::zeros(20, 20, CV_8UC1), large = cv::Mat::zeros(60, 60, CV_8UC1);
  EXPECT_THROW(cleanup.apply(small), InputError);
  EXPECT_NO_THROW(cleanup.apply(large));
}

TEST(TemporalMedian, RefusesEvenLengths) {
  EXPECT_THROW(Cleanup(over(4)), ConfigError);
  EXPECT_THROW(Cleanup(over(-3)), ConfigError);
  EXPECT_THROW(Cleanup(over(1001)), ConfigError);
}

}  // namespace
}  // namespace survtrack
