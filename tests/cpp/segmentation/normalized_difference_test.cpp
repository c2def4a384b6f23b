// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "../error_message.hpp"
#include "../simd_levels.hpp"
#include "segmentation/local_difference.hpp"
#include "survtrack/core/errors.hpp"
#include "survtrack/segmentation/segmenter.hpp"

namespace survtrack {
namespace {

cv::Mat random_picture(const cv::Size& size, std::uint64_t seed) {
  cv::Mat picture(size, CV_8UC1);
  cv::RNG random(seed);
  random.fill(picture, cv::RNG::UNIFORM, 0, 256);
  return picture;
}

/// Equation 3 as it stands, pixel by pixel, in double.
double equation_3(const cv::Mat& frame, const cv::Mat& reference, int x, int y, int side, double constant) {
  const auto level = [&](int px, int py) {
    return static_cast<double>(reference.at<std::uint8_t>(std::clamp(py, 0, reference.rows - 1), std::clamp(px, 0, reference.cols - 1)));
  };
  double above = 0.0;
  double below = constant;
  for (int ny = std::max(y - side / 2, 0); ny <= std::min(y + side / 2, frame.rows - 1); ++ny) {
    for (int nx = std::max(x - side / 2, 0); nx <= std::min(x + side / 2, frame.cols - 1); ++nx) {
      const double gradient = std::hypot(level(nx + 1, ny) - level(nx - 1, ny), level(nx, ny + 1) - level(nx, ny - 1)) / 2.0;
      above += std::abs(frame.at<std::uint8_t>(ny, nx) - level(nx, ny)) * gradient;
      below += gradient * gradient;
    }
  }
  return above / below;
}

class LocalDifferences : public AtEverySimdLevel {};

TEST_P(LocalDifferences, AreEquation3) {
  LocalDifference local;
  for (const cv::Size size : {cv::Size(37, 21), cv::Size(1, 1), cv::Size(2, 5), cv::Size(9, 1), cv::Size(3, 40)}) {
    const cv::Mat frame = random_picture(size, 1);
    const cv::Mat reference = random_picture(size, 2);
    for (const int side : {0, 1, 3, 5, 31}) {
      cv::Mat values;
      local.find(frame, reference, side, 50.0, values);
      for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
          const double expected = equation_3(frame, reference, x, y, side, 50.0);
          // A gradient is rounded to 1/16, which is little beside the sum of several of noise.
          const double rounding = (side < 3 ? 0.07 : 0.003) * expected + 1e-3;
          ASSERT_NEAR(values.at<float>(y, x), expected, rounding) << size << " " << side << ": " << x << ", " << y;
        }
      }
    }
  }
}

/// A ramp of 8 grey levels a pixel that moved by d px: |difference| = 8 d, |gradient| = 8, so that each term of the
/// sums is 64 d above and 64 below, and 25 of them give 1600 d / (1600 + c).
TEST_P(LocalDifferences, OfARampIsHowFarItMoved) {
  cv::Mat reference(9, 25, CV_8UC1);
  for (int y = 0; y < 9; ++y) {
    for (int x = 0; x < 25; ++x) reference.at<std::uint8_t>(y, x) = static_cast<std::uint8_t>(8 * x + 16);
  }
  for (const int moved_px : {0, 1, 2}) {
    const cv::Mat frame = reference - 8 * moved_px;
    cv::Mat values;
    LocalDifference().find(frame, reference, 5, 400.0, values);
    EXPECT_FLOAT_EQ(values.at<float>(4, 12), static_cast<float>(1600.0 * moved_px / 2000.0));
    // In the corner N is 3 x 3, and the ramp's first column has half the gradient, as the last pixel is repeated:
    // 3 (4 + 8 + 8) 8 d above, 3 (16 + 64 + 64) = 432 below.
    EXPECT_FLOAT_EQ(values.at<float>(0, 0), static_cast<float>(480.0 * moved_px / 832.0));
  }
}

TEST_P(LocalDifferences, OfFlatPicturesAreZero) {
  cv::Mat values;
  LocalDifference().find(cv::Mat(6, 6, CV_8UC1, cv::Scalar(255)), cv::Mat(6, 6, CV_8UC1, cv::Scalar(0)), 5, 1e-6, values);
  EXPECT_EQ(cv::countNonZero(values), 0);
}

INSTANTIATE_TEST_SUITE_P(All, LocalDifferences, testing::ValuesIn(simd_levels()), simd_level_name);

cv::Mat next_mask(Segmenter& model, const cv::Mat& frame, double time_s, const std::vector<Box>& keep = {}) {
  cv::Mat mask;
  std::vector<Event> events;
  Expectation expectation;
  expectation.time_s = time_s;
  expectation.keep = keep;
  model.segment(frame, expectation, mask, events);
  return mask;
}

/// Steps i to iv of 3.1.3, with the pyramid of OpenCV.
cv::Mat plain_mask(const cv::Mat& frame, const cv::Mat& reference, const NormalizedDifferenceOptions& options, int levels) {
  std::vector<cv::Mat> frames{frame};
  std::vector<cv::Mat> references{reference};
  for (int level = 1; level < levels; ++level) {
    cv::Mat halves[2];
    cv::pyrDown(frames.back(), halves[0]);
    cv::pyrDown(references.back(), halves[1]);
    frames.push_back(halves[0]);
    references.push_back(halves[1]);
  }
  std::vector<double> before;
  std::vector<double> values;
  for (int level = levels - 1; level >= 0; --level) {
    const cv::Mat& own = frames[static_cast<std::size_t>(level)];
    const cv::Mat& theirs = references[static_cast<std::size_t>(level)];
    values.assign(own.total(), 0.0);
    for (int y = 0; y < own.rows; ++y) {
      for (int x = 0; x < own.cols; ++x) {
        double& value = values[static_cast<std::size_t>(y * own.cols + x)];
        value = equation_3(own, theirs, x, y, options.neighbourhood_px, options.constant);
        const int coarse = (own.cols + 1) / 2;
        if (level < levels - 1 && value <= options.high) value = before[static_cast<std::size_t>(y / 2 * coarse + x / 2)];
      }
    }
    before = values;
  }
  cv::Mat mask(frame.size(), CV_8UC1);
  for (std::size_t i = 0; i < values.size(); ++i) mask.data[i] = values[i] > options.threshold ? 255 : 0;
  return mask;
}

/// Blurred noise on which a square goes right.
cv::Mat scene(int frame) {
  cv::Mat picture = random_picture({70, 45}, 5);
  cv::GaussianBlur(picture, picture, {5, 5}, 0);
  if (frame > 0) picture(cv::Rect(5 + 3 * frame, 15, 14, 12)).setTo(200);
  return picture;
}

TEST(NormalizedDifference, ReplacesFromTheCoarsestLevelDown) {
  for (const int levels : {1, 2, 3}) {
    for (const double high : {0.3, 1.0, 4.0}) {
      NormalizedDifferenceOptions options;
      options.reference = DifferenceReference::previous;
      options.frames_back = 2;
      options.levels = levels;
      options.high = high;
      options.threshold = 1.0;
      const auto model = make_segmenter(options);
      int moving = 0;
      for (int k = 0; k < 8; ++k) {
        const cv::Mat mask = next_mask(*model, scene(k), k);
        if (k < 2) {
          EXPECT_EQ(cv::countNonZero(mask), 0);
          continue;
        }
        // Values within rounding of the threshold may fall on either side.
        const cv::Mat expected = plain_mask(scene(k), scene(k - 2), options, levels);
        EXPECT_LE(cv::countNonZero(mask != expected), 16) << levels << " " << high << " " << k;
        cv::Mat background;
        model->background(background);
        EXPECT_EQ(cv::norm(background, scene(k - 2), cv::NORM_INF), 0);
        moving += cv::countNonZero(mask);
      }
      EXPECT_GT(moving, 100);
      EXPECT_LT(moving, 6 * 70 * 45 / 2);
    }
  }
}

TEST(NormalizedDifference, SmallFramesHaveFewerLevels) {
  NormalizedDifferenceOptions deep;
  deep.reference = DifferenceReference::previous;
  deep.levels = 10;
  NormalizedDifferenceOptions three = deep;
  three.levels = 3;  // 45 rows, 23, 12; 6 would be below 8
  const auto a = make_segmenter(deep);
  const auto b = make_segmenter(three);
  for (int k = 0; k < 4; ++k) EXPECT_EQ(cv::norm(next_mask(*a, scene(k), k), next_mask(*b, scene(k), k), cv::NORM_INF), 0);
}

TEST(NormalizedDifference, RunningReferenceIsThePlainMeanAtFirstAndThenFades) {
  NormalizedDifferenceOptions options;
  options.update_time_s = 4.0;
  const auto model = make_segmenter(options);
  const auto reference_of = [&](int level, double time_s, const std::vector<Box>& keep = {}) {
    next_mask(*model, cv::Mat(10, 10, CV_8UC1, cv::Scalar(level)), time_s, keep);
    cv::Mat picture;
    model->background(picture);
    return picture.empty() ? -1 : static_cast<int>(picture.at<std::uint8_t>(5, 5));
  };
  EXPECT_EQ(reference_of(100, 0.0), -1);
  EXPECT_EQ(reference_of(140, 1.0), 100);
  EXPECT_EQ(reference_of(140, 2.0), 140);  // all of one second's mean: the first frame has no time of its own
  EXPECT_EQ(reference_of(20, 8.0), 140);
  EXPECT_EQ(reference_of(20, 8.4, {Box{0, 0, 10, 10}}), 20);
  EXPECT_EQ(reference_of(120, 8.8), 20);
  EXPECT_EQ(reference_of(120, 9.2, {Box{0, 0, 10, 10}}), 30);  // 20 + 0.4 / 4 of the difference
  EXPECT_EQ(reference_of(120, 9.6), 30) << "a kept place does not learn";
}

TEST(NormalizedDifference, BadOptionsFramesAndTimesAreRefused) {
  NormalizedDifferenceOptions options;
  options.constant = 0.0;
  EXPECT_TRUE(contains(message_of<ConfigError>([&] { make_segmenter(options); }), "constant: 0 is not allowed"));
  options.constant = 100.0;
  options.neighbourhood_px = 4;
  EXPECT_THROW(make_segmenter(options), ConfigError);
  const auto model = make_segmenter(NormalizedDifferenceOptions{});
  next_mask(*model, scene(0), 0.0);
  EXPECT_THROW(next_mask(*model, scene(1), 0.0), InputError);
  EXPECT_THROW(next_mask(*model, cv::Mat(3, 3, CV_8UC1, cv::Scalar(0)), 1.0), InputError);
}

}  // namespace
}  // namespace survtrack
