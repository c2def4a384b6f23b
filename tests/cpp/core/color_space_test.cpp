// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "survtrack/core/color_space.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/imgproc.hpp>

namespace survtrack {
namespace {

const Color black{0.0, 0.0, 0.0};
const Color grey{128.0, 128.0, 128.0};
const Color white{255.0, 255.0, 255.0};
const Color blue{255.0, 0.0, 0.0};
const Color green{0.0, 255.0, 0.0};
const Color red{0.0, 0.0, 255.0};
const Color yellow{0.0, 255.0, 255.0};
const Color dark_magenta{100.0, 0.0, 100.0};

void expect_near(const ColorCoordinates& found, const ColorCoordinates& expected, double tolerance) {
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(found[i], expected[i], tolerance) << "coordinate " << i;
}

TEST(ColorSpace, BgrIsTheColourItself) {
  EXPECT_EQ(coordinates({1.5, 20.25, 254.75}, ColorSpace::bgr), (ColorCoordinates{1.5, 20.25, 254.75}));
}

TEST(ColorSpace, HsvOfKnownColours) {
  const auto hsv = [](const Color& color) { return coordinates(color, ColorSpace::hsv); };
  EXPECT_EQ(hsv(red), (ColorCoordinates{0.0, 255.0, 255.0}));
  EXPECT_EQ(hsv(yellow), (ColorCoordinates{60.0, 255.0, 255.0}));
  EXPECT_EQ(hsv(green), (ColorCoordinates{120.0, 255.0, 255.0}));
  EXPECT_EQ(hsv(blue), (ColorCoordinates{240.0, 255.0, 255.0}));
  EXPECT_EQ(hsv(dark_magenta), (ColorCoordinates{300.0, 255.0, 100.0}));
}

TEST(ColorSpace, TheHueOfGreyIs0) {
  EXPECT_EQ(coordinates(black, ColorSpace::hsv), (ColorCoordinates{0.0, 0.0, 0.0}));
  EXPECT_EQ(coordinates(grey, ColorSpace::hsv), (ColorCoordinates{0.0, 0.0, 128.0}));
  EXPECT_EQ(coordinates(white, ColorSpace::hsv), (ColorCoordinates{0.0, 0.0, 255.0}));
}

TEST(ColorSpace, LabOfKnownColours) {
  // sRGB under D65, as tables print it.
  const auto lab = [](const Color& color) { return coordinates(color, ColorSpace::lab); };
  expect_near(lab(black), {0.0, 0.0, 0.0}, 0.02);
  expect_near(lab(white), {100.0, 0.0, 0.0}, 0.02);
  expect_near(lab(red), {53.24, 80.09, 67.20}, 0.05);
  expect_near(lab(green), {87.73, -86.18, 83.18}, 0.05);
  expect_near(lab(blue), {32.30, 79.19, -107.86}, 0.05);
  expect_near(lab(grey), {53.59, 0.0, 0.0}, 0.02);
}

/// All combinations of some levels of each channel, one a pixel.
cv::Mat palette() {
  cv::Mat colors(1, 8 * 8 * 8, CV_32FC3);
  for (int i = 0; i < colors.cols; ++i) {
    const auto level = [](int step) { return static_cast<float>(36 * step); };
    colors.at<cv::Vec3f>(i) = {level(i % 8), level(i / 8 % 8), level(i / 64)};
  }
  return colors;
}

Color color_at(const cv::Mat& colors, int i) {
  const auto& pixel = colors.at<cv::Vec3f>(i);
  return {pixel[0], pixel[1], pixel[2]};
}

TEST(ColorSpace, HsvIsThatOfOpenCv) {
  const cv::Mat colors = palette();
  cv::Mat converted;
  cv::cvtColor(cv::Mat(colors / 255.0), converted, cv::COLOR_BGR2HSV);
  for (int i = 0; i < colors.cols; ++i) {
    const auto& expected = converted.at<cv::Vec3f>(i);  // degrees, 0 to 1, 0 to 1
    expect_near(coordinates(color_at(colors, i), ColorSpace::hsv),
                {expected[0], 255.0 * expected[1], 255.0 * expected[2]}, 0.01);
  }
}

TEST(ColorSpace, LabIsThatOfOpenCv) {
  const cv::Mat colors = palette();
  cv::Mat converted;
  cv::cvtColor(cv::Mat(colors / 255.0), converted, cv::COLOR_BGR2Lab);
  for (int i = 0; i < colors.cols; ++i) {
    const auto& expected = converted.at<cv::Vec3f>(i);
    // OpenCV interpolates in a table.
    expect_near(coordinates(color_at(colors, i), ColorSpace::lab), {expected[0], expected[1], expected[2]}, 0.6);
  }
}

TEST(ColorSpace, DifferencesAreSigned) {
  for (const ColorSpace space : {ColorSpace::bgr, ColorSpace::lab}) {
    EXPECT_EQ(color_difference({1.0, 5.0, -3.0}, {4.0, 3.0, 300.0}, space), (ColorCoordinates{3.0, -2.0, 303.0}));
  }
}

TEST(ColorSpace, HuesDifferTheShorterWayRound) {
  const auto hue_difference = [](double a, double b) {
    return color_difference({a, 10.0, 30.0}, {b, 20.0, 10.0}, ColorSpace::hsv);
  };
  EXPECT_EQ(hue_difference(350.0, 10.0), (ColorCoordinates{20.0, 10.0, -20.0}));
  EXPECT_EQ(hue_difference(10.0, 350.0), (ColorCoordinates{-20.0, 10.0, -20.0}));
  EXPECT_EQ(hue_difference(30.0, 90.0)[0], 60.0);
  EXPECT_EQ(hue_difference(0.0, 180.0)[0], 180.0);
  EXPECT_EQ(hue_difference(180.0, 0.0)[0], -180.0);
  EXPECT_EQ(hue_difference(359.0, 0.0)[0], 1.0);
}

TEST(ColorSpace, NearlyGreyHuesStayOnTheCircle) {
  // A red whose green is a hair below its blue: the hue is just below 360 degrees, or 0.
  const ColorCoordinates hsv = coordinates({100.0 + 1e-14, 100.0, 200.0}, ColorSpace::hsv);
  EXPECT_GE(hsv[0], 0.0);
  EXPECT_LE(hsv[0], 360.0);
  EXPECT_LE(std::abs(color_difference(hsv, {0.0, hsv[1], hsv[2]}, ColorSpace::hsv)[0]), 1e-9);
}

}  // namespace
}  // namespace survtrack
