// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "survtrack/core/checks.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <opencv2/core.hpp>
#include <string>
#include <utility>
#include <vector>

#include "../error_message.hpp"
#include "core/check_mask.hpp"
#include "survtrack/core/errors.hpp"

namespace survtrack {
namespace {

std::string image_refusal(const cv::Mat& image) {
  return message_of<InputError>([&] { check_image(image); });
}

TEST(CheckImage, TakesGreyAndColourAndViews) {
  EXPECT_NO_THROW(check_image(cv::Mat::zeros(1, 1, CV_8UC1)));
  EXPECT_NO_THROW(check_image(cv::Mat::zeros(3, 4, CV_8UC3)));
  const cv::Mat whole = cv::Mat::zeros(8, 8, CV_8UC3);
  EXPECT_NO_THROW(check_image(whole(cv::Rect(2, 2, 3, 5))));
}

TEST(CheckImage, NamesTheTypeThatCame) {
  const std::vector<std::pair<int, std::string>> types = {
      {CV_8SC1, "2x5 int8"},    {CV_16UC1, "2x5 uint16"},   {CV_16SC1, "2x5 int16"},
      {CV_32SC1, "2x5 int32"},  {CV_32FC3, "2x5x3 float32"}, {CV_64FC1, "2x5 float64"},
      {CV_8UC2, "2x5x2 uint8"}, {CV_8UC4, "2x5x4 uint8"},
  };
  for (const auto& [type, name] : types) {
    EXPECT_TRUE(contains(image_refusal(cv::Mat::zeros(2, 5, type)), "frame: is " + name, "HxWx3 (BGR) uint8"));
  }
}

TEST(CheckImage, RefusesEmptyAndMoreDimensions) {
  EXPECT_TRUE(contains(image_refusal(cv::Mat()), "frame: is empty", "at least one pixel"));
  EXPECT_TRUE(contains(image_refusal(cv::Mat(0, 5, CV_8UC1)), "frame: is empty"));
  const std::vector<int> sides = {2, 3, 4};
  EXPECT_TRUE(contains(image_refusal(cv::Mat(sides, CV_8UC1, cv::Scalar(0))), "frame: has 3 dimensions"));
}

TEST(CheckImage, UsesTheNameItIsGiven) {
  EXPECT_TRUE(contains(message_of<InputError>([] { check_image(cv::Mat(), "background"); }), "background: is empty"));
}

TEST(CheckMask, RefusesColour) {
  EXPECT_NO_THROW(check_mask(cv::Mat::zeros(2, 2, CV_8UC1)));
  const std::string message = message_of<InputError>([] { check_mask(cv::Mat::zeros(2, 2, CV_8UC3)); });
  EXPECT_TRUE(contains(message, "mask: has 3 channels"));
}

TEST(CheckSameFormat, NamesBothFormats) {
  const cv::Mat image = cv::Mat::zeros(20, 30, CV_8UC1);
  EXPECT_NO_THROW(check_same_format(image, {30, 20}, 1));
  EXPECT_TRUE(contains(message_of<InputError>([&] { check_same_format(image, {20, 30}, 1); }), "frame: is 20x30 uint8",
                       "were 30x20", "reset()"));
  EXPECT_TRUE(contains(message_of<InputError>([&] { check_same_format(image, {30, 20}, 3); }), "were 20x30x3"));
}

TEST(CheckTime, MustBeFiniteAndIncrease) {
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_NO_THROW(check_time(-5.0, std::nullopt));
  EXPECT_NO_THROW(check_time(1.0, std::nextafter(1.0, 0.0)));
  for (const double time_s : {std::nan(""), infinity, -infinity, 2e12}) {
    EXPECT_TRUE(contains(message_of<InputError>([&] { check_time(time_s, std::nullopt); }), "time_s: is ", "finite"));
  }
  EXPECT_TRUE(contains(message_of<InputError>([] { check_time(1.5, 1.5); }), "time_s: 1.5 does not come after 1.5"));
  EXPECT_TRUE(contains(message_of<InputError>([] { check_time(1.0, 1.5); }), "time_s: 1 does not come after 1.5"));
}

}  // namespace
}  // namespace survtrack
