// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "survtrack/core/color_histogram.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <opencv2/core.hpp>

#include "../error_message.hpp"
#include "survtrack/core/errors.hpp"

namespace survtrack {
namespace {

TEST(ColorHistogram, CountsPixelsByColour) {
  cv::Mat image(2, 4, CV_8UC3, cv::Scalar(10, 40, 250));
  image.at<cv::Vec3b>(1, 3) = {31, 63, 224};  // the last of the same bins
  image.at<cv::Vec3b>(0, 0) = {32, 40, 250};
  image.at<cv::Vec3b>(0, 1) = {255, 255, 255};
  const ColorHistogram histogram = color_histogram(image);
  EXPECT_EQ(histogram.parts[ColorHistogram::bin(0, 32, 224)], 6.0F / 8.0F);
  EXPECT_EQ(histogram.parts[0 * 64 + 1 * 8 + 7], 6.0F / 8.0F) << "blue is the slowest";
  EXPECT_EQ(histogram.parts[1 * 64 + 1 * 8 + 7], 1.0F / 8.0F);
  EXPECT_EQ(histogram.parts[511], 1.0F / 8.0F);
  EXPECT_EQ(std::accumulate(histogram.parts.begin(), histogram.parts.end(), 0.0F), 1.0F);
}

TEST(ColorHistogram, OfGreyIsThatOfEqualChannels) {
  cv::Mat grey(5, 7, CV_8UC1);
  cv::randu(grey, 0, 256);
  cv::Mat color(grey.size(), CV_8UC3);
  for (int y = 0; y < grey.rows; ++y) {
    for (int x = 0; x < grey.cols; ++x) {
      const auto level = grey.at<std::uint8_t>(y, x);
      color.at<cv::Vec3b>(y, x) = {level, level, level};
    }
  }
  EXPECT_EQ(color_histogram(grey), color_histogram(color));
}

TEST(ColorHistogram, LooksAtTheMaskOnly) {
  cv::Mat image(4, 4, CV_8UC3, cv::Scalar(0, 0, 0));
  cv::Mat mask = cv::Mat::zeros(4, 4, CV_8UC1);
  image.row(1).setTo(cv::Scalar(255, 0, 0));
  mask.row(1).setTo(255);
  EXPECT_EQ(color_histogram(image, mask).parts[7 * 64], 1.0F);
  EXPECT_EQ(color_histogram(image, cv::Mat::zeros(4, 4, CV_8UC1)), ColorHistogram{}) << "no pixel, no colour";
  EXPECT_EQ(message_of<InputError>([&] { color_histogram(image, cv::Mat::zeros(4, 5, CV_8UC1)); }),
            "mask: is 4x5, the image 4x4; expected the same size");
  EXPECT_THROW(color_histogram(cv::Mat(4, 4, CV_32FC1)), InputError);
}

TEST(ColorHistogram, IntersectionIsWhatIsCommon) {
  ColorHistogram a, b;
  a.parts[3] = 0.75F;
  a.parts[9] = 0.25F;
  b.parts[3] = 0.5F;
  b.parts[100] = 0.5F;
  EXPECT_DOUBLE_EQ(histogram_intersection(a, b), 0.5);
  EXPECT_DOUBLE_EQ(histogram_intersection(b, a), 0.5);
  EXPECT_DOUBLE_EQ(histogram_intersection(a, a), 1.0);
  EXPECT_DOUBLE_EQ(histogram_intersection(a, ColorHistogram{}), 0.0);
  refresh(a, b, 0.5);
  EXPECT_FLOAT_EQ(a.parts[3], 0.625F);
  EXPECT_FLOAT_EQ(a.parts[9], 0.125F);
  EXPECT_FLOAT_EQ(a.parts[100], 0.25F);
}

TEST(ColorHistogram, WhatIsNoneIsRefused) {
  ColorHistogram histogram;
  EXPECT_NO_THROW(check_histogram(histogram, "h"));
  histogram.parts[0] = 0.5F;
  EXPECT_EQ(message_of<InputError>([&] { check_histogram(histogram, "h"); }).find("h: its parts sum to 0.5"), 0U);
  histogram.parts[1] = -0.5F;
  EXPECT_EQ(message_of<InputError>([&] { check_histogram(histogram, "h"); }).find("h: has a part that is negative"), 0U);
  histogram.parts[1] = std::nanf("");
  EXPECT_THROW(check_histogram(histogram, "h"), InputError);
}

}  // namespace
}  // namespace survtrack
