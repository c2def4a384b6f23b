// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "segmentation/scene_measures.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/core.hpp>
#include <utility>
#include <vector>

namespace survtrack {
namespace {

/// A sample of grey levels.
SceneSample grey(const std::vector<int>& levels, int columns) {
  SceneSample sample;
  sample.grid = {columns, static_cast<int>(levels.size()) / columns};
  for (const int level : levels) sample.levels.insert(sample.levels.end(), 3, static_cast<std::uint8_t>(level));
  return sample;
}

TEST(SceneMeasures, ChangedPixelsDifferStrictlyInSomeChannel) {
  const SceneSample a = grey({10, 10, 10, 10, 10}, 5);
  SceneSample b = grey({10, 35, 36, 10, 200}, 5);
  b.levels[0] = 36;  // the blue of the first
  EXPECT_DOUBLE_EQ(scene_difference(ChangedPixelsOptions{}, a, b), 3.0 / 5.0);
}

/// Four blocks of 2 x 1: means 10, 30, 50, 70 against 10, 46, 50, 70, and deviations 0 but for the third, of 0 against 20.
TEST(SceneMeasures, BlocksCountTheirMeansAndDeviations) {
  const SceneSample a = grey({10, 10, 30, 30, 50, 50, 70, 70}, 4);
  const SceneSample b = grey({10, 10, 46, 46, 30, 70, 70, 70}, 4);
  BlocksOptions options;
  options.blocks_a_side = 2;
  EXPECT_DOUBLE_EQ(scene_difference(options, a, b), 2.0 / 4.0);
  options.mean_difference = 16.0;
  EXPECT_DOUBLE_EQ(scene_difference(options, a, b), 1.0 / 4.0);
  options.deviation_difference = 20.0;
  EXPECT_DOUBLE_EQ(scene_difference(options, a, b), 0.0);
  // More blocks than samples: each sample is one, and the others do not count.
  options.blocks_a_side = 16;
  EXPECT_DOUBLE_EQ(scene_difference(options, a, b), 2.0 / 8.0) << "16 is not more than 16";
}

TEST(SceneMeasures, HistogramsHaveAnIntersection) {
  const SceneSample a = grey({0, 0, 31, 32, 64, 255}, 6);
  const SceneSample b = grey({255, 0, 5, 90, 200, 200}, 6);
  // Bins of 32 levels: a has 3, 1, 1, 0, 0, 0, 0, 1 and b 2, 0, 1, 0, 0, 0, 2, 1; in common are 2 + 1 + 1.
  EXPECT_NEAR(scene_difference(HistogramOptions{}, a, b), 1.0 - 4.0 / 6.0, 1e-15);
  SceneSample red = grey({200, 200}, 2);
  SceneSample blue = red;
  red.levels[0] = red.levels[1] = red.levels[3] = red.levels[4] = 10;
  blue.levels[1] = blue.levels[2] = blue.levels[4] = blue.levels[5] = 10;
  EXPECT_DOUBLE_EQ(scene_difference(HistogramOptions{}, red, blue), 1.0) << "colours count, not channels one by one";
}

/// Cumulative distributions after the levels 1, 2, 3, 4: 0.5, 0.75, 1, 1 against 0, 0.25, 0.25, 1.
TEST(SceneMeasures, KolmogorovSmirnovIsTheGreatestDistanceOfDistributions) {
  const SceneSample a = grey({1, 1, 2, 3}, 4);
  const SceneSample b = grey({2, 4, 4, 4}, 4);
  EXPECT_DOUBLE_EQ(scene_difference(KolmogorovSmirnovOptions{}, a, b), 0.75);
  EXPECT_DOUBLE_EQ(scene_difference(KolmogorovSmirnovOptions{}, b, a), 0.75);
}

TEST(SceneMeasures, AreZeroOfTheSameAndSymmetricAndAtMostOne) {
  cv::RNG random(4);
  std::vector<SceneSample> all;
  for (int i = 0; i < 6; ++i) {
    SceneSample sample;
    sample.grid = {13, 7};
    for (int k = 0; k < 3 * 13 * 7; ++k) sample.levels.push_back(static_cast<std::uint8_t>(random.uniform(0, 40 + 40 * i)));
    all.push_back(sample);
  }
  const SceneMeasureOptions measures[] = {BlocksOptions{}, ChangedPixelsOptions{}, HistogramOptions{}, KolmogorovSmirnovOptions{}};
  for (const SceneMeasureOptions& measure : measures) {
    const auto difference = [&](const SceneSample& a, const SceneSample& b) {
      return std::visit([&](const auto& options) { return scene_difference(options, a, b); }, measure);
    };
    for (const SceneSample& a : all) {
      EXPECT_EQ(difference(a, a), 0.0);
      for (const SceneSample& b : all) {
        EXPECT_EQ(difference(a, b), difference(b, a));
        EXPECT_GE(difference(a, b), 0.0);
        EXPECT_LE(difference(a, b), 1.0);
      }
    }
  }
}

TEST(SceneSamples, AreAsManyAsAskedAtMostAndSpreadOverTheFrame) {
  for (const cv::Size size : {cv::Size(768, 576), cv::Size(320, 240), cv::Size(1, 1), cv::Size(3000, 2), cv::Size(2, 3000), cv::Size(33, 70)}) {
    for (const int samples : {16, 4096, 1000000}) {
      const SceneGrid grid = scene_grid(size, samples);
      EXPECT_GE(grid.columns, 1);
      EXPECT_GE(grid.rows, 1);
      EXPECT_LE(grid.columns, size.width);
      EXPECT_LE(grid.rows, size.height);
      EXPECT_LE(grid.count(), static_cast<std::size_t>(samples)) << size;
    }
  }
  const SceneGrid grid = scene_grid({768, 576}, 4096);
  EXPECT_EQ(grid.columns, 73);
  EXPECT_EQ(grid.rows, 55);
}

TEST(SceneSamples, AreMeansOfSquaresInsideTheFrame) {
  cv::Mat frame(5, 5, CV_8UC3, cv::Scalar(10, 20, 30));
  frame.at<cv::Vec3b>(0, 0) = {19, 20, 30};
  frame.at<cv::Vec3b>(2, 2) = {10, 65, 30};
  SceneSample sample;
  take_sample(frame, {1, 1}, 3, sample);
  EXPECT_EQ(sample.levels, (std::vector<std::uint8_t>{10, 25, 30})) << "20 + 45 / 9";
  take_sample(frame, {5, 5}, 3, sample);
  EXPECT_EQ(sample.levels[0], 12) << "10 + 9 / 4, rounded: a corner's square is 2 x 2";
  take_sample(frame, {5, 5}, 0, sample);
  EXPECT_EQ(sample.levels[0], 19);
  EXPECT_EQ(sample.levels[3 * 12 + 1], 65);
  const cv::Mat level(4, 4, CV_8UC1, cv::Scalar(77));
  take_sample(level, {2, 1}, 3, sample);
  EXPECT_EQ(sample.levels, std::vector<std::uint8_t>(6, 77));
}

TEST(SceneSamples, SayHowColorfulBlackAndAlikeTheyAre) {
  SceneSample sample = grey({20, 30, 24, 25}, 2);
  EXPECT_EQ(color_of(sample), 0.0);
  EXPECT_DOUBLE_EQ(black_part_of(sample, 24), 0.5);
  sample.levels[0] = 60;
  EXPECT_DOUBLE_EQ(color_of(sample), 10.0);
  EXPECT_DOUBLE_EQ(black_part_of(sample, 24), 0.25);
  const SceneSample a = grey({10, 20, 30, 40}, 4);
  EXPECT_NEAR(correlation(a, grey({5, 10, 15, 20}, 4)), 1.0, 1e-12);
  EXPECT_NEAR(correlation(a, grey({40, 30, 20, 10}, 4)), -1.0, 1e-12);
  // Deviations -15, -5, 5, 15 and -10, 10, 10, -10: their products sum to 0.
  EXPECT_NEAR(correlation(a, grey({10, 30, 30, 10}, 4)), 0.0, 1e-12);
  EXPECT_EQ(correlation(a, grey({7, 7, 7, 7}, 4)), 0.0);
}

}  // namespace
}  // namespace survtrack
