// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include <gtest/gtest.h>

#include <cstdint>
#include <opencv2/core.hpp>
#include <vector>

#include "../error_message.hpp"
#include "survtrack/core/errors.hpp"
#include "survtrack/pipeline/detector.hpp"
#include "survtrack/segmentation/horn_schunck.hpp"
#include "survtrack/segmentation/segmenter.hpp"

namespace survtrack {
namespace {

/// Noise on which a bright square goes two pixels a frame to the right.
std::vector<cv::Mat> film(int frames) {
  std::vector<cv::Mat> all;
  for (int i = 0; i < frames; ++i) {
    cv::Mat frame(48, 80, CV_8UC1);
    cv::RNG(7).fill(frame, cv::RNG::UNIFORM, 60, 90);
    frame(cv::Rect(5 + 2 * i, 18, 14, 12)).setTo(200);
    all.push_back(frame);
  }
  return all;
}

struct Answers {
  std::vector<cv::Mat> masks;
  std::vector<cv::Mat> flows;
};

Answers run(const HornSchunckOptions& options, const std::vector<cv::Mat>& frames) {
  const auto model = make_segmenter(options);
  Answers result;
  std::vector<Event> events;
  for (const cv::Mat& frame : frames) {
    model->push(frame);
    model->segment(frame, {}, result.masks.emplace_back(), events);
    model->flow(result.flows.emplace_back());
  }
  return result;
}

TEST(HornSchunckSegmenter, IsTheFlowSinceTheNthFrameBefore) {
  const auto frames = film(12);
  for (const int frames_back : {1, 3, 10}) {
    for (const auto derivatives : {Derivatives::hs1981, Derivatives::sobel}) {
      HornSchunckOptions options;
      options.frames_back = frames_back;
      options.derivatives = derivatives;
      options.smoothness = 0.2;
      options.sweeps = 40;
      options.magnitude_threshold = 0.25;
      const Answers result = run(options, frames);
      const FlowOptions same{.smoothness = 0.2, .sweeps = 40, .derivatives = derivatives};
      for (int i = 0; i < 12; ++i) {
        const auto frame = static_cast<std::size_t>(i);
        if (i < frames_back) {
          EXPECT_EQ(cv::countNonZero(result.masks[frame]), 0);
          EXPECT_TRUE(result.flows[frame].empty());
          continue;
        }
        FlowField expected;
        horn_schunck(frames[static_cast<std::size_t>(i - frames_back)], frames[frame], same, expected);
        int moving = 0;
        for (int y = 0; y < 48; ++y) {
          for (int x = 0; x < 80; ++x) {
            const float u = expected.u.at<float>(y, x);
            const float v = expected.v.at<float>(y, x);
            ASSERT_EQ(result.flows[frame].at<cv::Vec2f>(y, x), cv::Vec2f(u, v));
            ASSERT_EQ(result.masks[frame].at<std::uint8_t>(y, x), u * u + v * v > 0.0625f ? 255 : 0);
            moving += result.masks[frame].at<std::uint8_t>(y, x) / 255;
          }
        }
        EXPECT_GT(moving, 20);
        EXPECT_LT(moving, 48 * 80 / 2);
      }
    }
  }
}

TEST(HornSchunckSegmenter, ARunNoLongerThanItLooksBackHasNoForeground) {
  HornSchunckOptions options;
  options.frames_back = 12;
  const Answers result = run(options, film(12));
  for (const cv::Mat& mask : result.masks) EXPECT_EQ(cv::countNonZero(mask), 0);
  for (const cv::Mat& field : result.flows) EXPECT_TRUE(field.empty());
}

TEST(HornSchunckSegmenter, RefusesFramesOfAnotherSize) {
  const auto model = make_segmenter(HornSchunckOptions{});
  cv::Mat mask;
  std::vector<Event> events;
  model->segment(cv::Mat(20, 30, CV_8UC1, cv::Scalar(9)), {}, mask, events);
  const std::string message = message_of<InputError>(
      [&] { model->segment(cv::Mat(20, 31, CV_8UC1, cv::Scalar(9)), {}, mask, events); });
  EXPECT_NE(message.find("frame: is 20x31 uint8, the frames before were 20x30"), std::string::npos) << message;
}

TEST(HornSchunckSegmenter, DetectorsHandOutTheFlowWhenAsked) {
  Config config;
  HornSchunckOptions options;
  options.frames_back = 2;
  config.segmenter = options;
  const auto frames = film(4);
  for (const bool asked : {false, true}) {
    config.outputs.flow = asked;
    Detector detector(config);
    for (std::size_t i = 0; i < frames.size(); ++i) {
      const auto detections = detector.process(frames[i], 0.1 * static_cast<double>(i));
      ASSERT_TRUE(detections.has_value());
      EXPECT_EQ(detections->flow.empty(), !asked || i < 2);
    }
  }
  config.segmenter = SelectiveOptions{};
  const std::string message = message_of<ConfigError>([&] { Detector other(config); });
  EXPECT_EQ(message.find("outputs.flow: true needs a flow field"), 0U) << message;
}

TEST(HornSchunck, HasNoBackgroundToAskFor) {
  Config config;
  config.segmenter = HornSchunckOptions{};
  config.outputs.background = true;
  const std::string message = message_of<ConfigError>([&] { config.check(); });
  EXPECT_EQ(message.find("outputs.background: true needs a background picture"), 0U) << message;
}

TEST(HornSchunck, WritesIntoTheGivenFieldsAndMayStartFromThem) {
  const auto frames = film(2);
  FlowField expected;
  horn_schunck(frames[0], frames[1], {}, expected);
  cv::Mat larger(60, 200, CV_32FC1, cv::Scalar(7));
  FlowField flow{larger(cv::Rect(3, 2, 80, 48)), cv::Mat(48, 80, CV_32FC1)};
  const std::uint8_t* const data[2] = {flow.u.data, flow.v.data};
  horn_schunck(frames[0], frames[1], {}, flow);
  EXPECT_EQ(flow.u.data, data[0]);
  EXPECT_EQ(flow.v.data, data[1]);
  EXPECT_EQ(cv::norm(flow.u, expected.u, cv::NORM_INF), 0);
  EXPECT_EQ(cv::norm(flow.v, expected.v, cv::NORM_INF), 0);
  horn_schunck(frames[0], frames[1], {}, flow, flow);
  FlowField longer;
  horn_schunck(frames[0], frames[1], {.sweeps = 200}, longer);
  EXPECT_EQ(cv::norm(flow.u, longer.u, cv::NORM_INF), 0);
  flow.u.setTo(7);
  EXPECT_EQ(cv::countNonZero(larger != 7), 0) << "wrote beyond the field";
}

}  // namespace
}  // namespace survtrack
