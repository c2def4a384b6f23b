// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>

#include "../simd_levels.hpp"
#include "survtrack/core/errors.hpp"
#include "survtrack/segmentation/cleanup.hpp"

namespace survtrack {
namespace {

constexpr CleanupOptions median(int side) { return {.median_px = side, .open_px = 0, .close_px = 0}; }
constexpr CleanupOptions opening(int side) { return {.median_px = 0, .open_px = side, .close_px = 0}; }
constexpr CleanupOptions closing(int side) { return {.median_px = 0, .open_px = 0, .close_px = side}; }

cv::Mat empty_mask() { return cv::Mat::zeros(40, 70, CV_8UC1); }

cv::Mat mask_with(const std::vector<cv::Rect>& objects) {
  cv::Mat mask = empty_mask();
  for (const cv::Rect& object : objects) mask(object).setTo(255);
  return mask;
}

cv::Mat cleaned(const cv::Mat& mask, const CleanupOptions& options) {
  cv::Mat result = mask.clone();
  Cleanup(options).apply(result);
  return result;
}

bool same(const cv::Mat& a, const cv::Mat& b) { return cv::norm(a, b, cv::NORM_INF) == 0; }

TEST(Cleanup, OpeningRemovesWhatIsThinner) {
  const cv::Mat noisy = mask_with({{10, 10, 3, 3}, {20, 20, 1, 1}, {30, 5, 2, 20}, {40, 30, 20, 2}});
  EXPECT_TRUE(same(cleaned(noisy, opening(3)), mask_with({{10, 10, 3, 3}})));
  EXPECT_TRUE(same(cleaned(noisy, opening(5)), empty_mask()));
}

TEST(Cleanup, OpeningKeepsObjectsThatLeaveTheImage) {
  // Of each a strip of two pixels is still to be seen, at every side and corner.
  const cv::Mat leaving =
      mask_with({{0, 10, 2, 8}, {68, 10, 2, 8}, {20, 0, 8, 2}, {20, 38, 8, 2}, {0, 0, 2, 2}, {68, 38, 2, 2}});
  EXPECT_TRUE(same(cleaned(leaving, opening(3)), leaving));
  // A line of one pixel is noise there as anywhere.
  EXPECT_TRUE(same(cleaned(mask_with({{0, 10, 1, 8}, {20, 39, 8, 1}}), opening(3)), empty_mask()));
}

TEST(Cleanup, ClosingJoinsOverNarrowerGaps) {
  const cv::Mat parts = mask_with({{10, 10, 5, 5}, {17, 10, 5, 5}, {10, 20, 5, 5}, {18, 20, 5, 5}});
  EXPECT_TRUE(same(cleaned(parts, closing(3)), mask_with({{10, 10, 12, 5}, {10, 20, 5, 5}, {18, 20, 5, 5}})));
}

TEST(Cleanup, ClosingDoesNotGrowObjectsToTheBorder) {
  const cv::Mat near = mask_with({{1, 10, 8, 8}, {61, 20, 8, 8}, {30, 1, 8, 8}, {30, 31, 8, 8}, {0, 34, 4, 4}});
  for (const int side : {3, 5, 9}) EXPECT_TRUE(same(cleaned(near, closing(side)), near)) << side;
}

TEST(Cleanup, MedianFollowsTheMajority) {
  const cv::Mat noisy = mask_with({{10, 10, 6, 6}, {12, 12, 1, 1}, {30, 30, 2, 2}});
  cv::Mat expected = mask_with({{10, 10, 6, 6}});
  for (const cv::Point corner : {cv::Point(10, 10), {15, 10}, {10, 15}, {15, 15}}) {
    expected.at<std::uint8_t>(corner) = 0;
  }
  EXPECT_TRUE(same(cleaned(noisy, median(3)), expected));
}

TEST(Cleanup, ZeroAndOneLeaveTheMaskAlone) {
  const cv::Mat noisy = mask_with({{10, 10, 1, 1}, {20, 0, 1, 30}});
  EXPECT_TRUE(same(cleaned(noisy, {.median_px = 0, .open_px = 0, .close_px = 0}), noisy));
  EXPECT_TRUE(same(cleaned(noisy, {.median_px = 1, .open_px = 1, .close_px = 1}), noisy));
}

TEST(Cleanup, StepsComeInTheirOrder) {
  cv::Mat mask(50, 80, CV_8UC1);
  cv::RNG(4).fill(mask, cv::RNG::UNIFORM, 0, 2);
  mask *= 255;
  const CleanupOptions all{.median_px = 5, .open_px = 3, .close_px = 7};
  EXPECT_TRUE(same(cleaned(mask, all), cleaned(cleaned(cleaned(mask, median(5)), opening(3)), closing(7))));
}

/// OpenCV's own; its closing would fill gaps towards the border, so it gets a margin of background.
cv::Mat reference(const cv::Mat& mask, const CleanupOptions& options) {
  cv::Mat result = mask.clone();
  if (options.median_px > 0) cv::medianBlur(mask, result, options.median_px);
  const auto square = [](int side) { return cv::getStructuringElement(cv::MORPH_RECT, {side, side}); };
  if (options.open_px > 0) cv::morphologyEx(mask, result, cv::MORPH_OPEN, square(options.open_px));
  if (options.close_px > 0) {
    const int margin = options.close_px;
    cv::copyMakeBorder(mask, result, margin, margin, margin, margin, cv::BORDER_CONSTANT, 0);
    cv::morphologyEx(result, result, cv::MORPH_CLOSE, square(options.close_px));
    result = result(cv::Rect({margin, margin}, mask.size())).clone();
  }
  return result;
}

class CleanupLevels : public AtEverySimdLevel {};

TEST_P(CleanupLevels, MatchOpenCvOnRandomMasks) {
  cv::RNG random(11);
  const std::vector<CleanupOptions> all{
      median(3),  median(5),  median(7),   median(9),   median(31), opening(3),  opening(5),
      opening(21), opening(65), opening(99), closing(3), closing(5), closing(21), closing(99)};
  for (const CleanupOptions& options : all) {
    Cleanup cleanup(options);  // one for all sizes
    for (const cv::Size size : {cv::Size(1, 1), {1, 40}, {40, 1}, {63, 9}, {64, 30}, {65, 31}, {127, 12}, {200, 150}}) {
      for (const int percent : {2, 30, 60, 90, 99}) {
        // Blocks of 1 to 8 pixels, so that large squares find something as well.
        const int block = random.uniform(1, 9);
        cv::Mat coarse(size.height / block + 1, size.width / block + 1, CV_8UC1), mask;
        random.fill(coarse, cv::RNG::UNIFORM, 0, 100);
        cv::resize(coarse < percent, mask, {}, block, block, cv::INTER_NEAREST);
        cv::Mat larger(size.height + 5, size.width + 9, CV_8UC1, cv::Scalar(77));
        cv::Mat view = larger(cv::Rect({4, 2}, size));
        mask(cv::Rect({0, 0}, size)).copyTo(view);
        const cv::Mat expected = reference(view.clone(), options);
        cleanup.apply(view);
        ASSERT_TRUE(same(view, expected)) << "median " << options.median_px << ", open " << options.open_px
                                          << ", close " << options.close_px << ", " << size << ", " << percent << " %";
        view.setTo(77);
        ASSERT_EQ(cv::countNonZero(larger != 77), 0) << "wrote beyond the mask";
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Levels, CleanupLevels, testing::ValuesIn(simd_levels()), simd_level_name);

TEST(Cleanup, RefusesWhatIsNoMask) {
  cv::Mat colour(4, 4, CV_8UC3, cv::Scalar::all(0)), real(4, 4, CV_32FC1, cv::Scalar(0)), none;
  Cleanup cleanup(opening(3));
  EXPECT_THROW(cleanup.apply(colour), InputError);
  EXPECT_THROW(cleanup.apply(real), InputError);
  EXPECT_THROW(cleanup.apply(none), InputError);
}

TEST(Cleanup, RefusesOptionsOutOfRange) {
  EXPECT_THROW(Cleanup(opening(4)), ConfigError);
  EXPECT_THROW(Cleanup(median(33)), ConfigError);
  EXPECT_THROW(Cleanup(closing(-1)), ConfigError);
}

}  // namespace
}  // namespace survtrack
