// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include <gtest/gtest.h>

#include <opencv2/core.hpp>
#include <opencv2/video/background_segm.hpp>
#include <vector>

#include "survtrack/core/errors.hpp"
#include "survtrack/segmentation/segmenter.hpp"

namespace survtrack {
namespace {

cv::Mat segment(Segmenter& model, const cv::Mat& frame) {
  cv::Mat mask;
  std::vector<Event> events;
  model.push(frame);
  model.segment(frame, {}, mask, events);
  return mask;
}

TEST(OpenCvSegmenters, Mog2GivesItsOwnMasksButForTheFirstAndShadows) {
  const Mog2Options options{.history_frames = 40, .variance_threshold = 25.0};
  const auto model = make_segmenter(options);
  const auto peer = cv::createBackgroundSubtractorMOG2(40, 25.0, true);
  cv::RNG random(1);
  int foreground = 0;
  for (int i = 0; i < 30; ++i) {
    cv::Mat frame(40, 50, CV_8UC3);
    random.fill(frame, cv::RNG::UNIFORM, 80, 110);
    if (i > 20) frame(cv::Rect(i, 10, 8, 8)).setTo(cv::Scalar(10, 200, 240));
    cv::Mat expected;
    peer->apply(frame, expected);
    EXPECT_TRUE(i > 0 || cv::countNonZero(expected) == 2000) << "OpenCV mends its first frame itself";
    const cv::Mat mask = segment(*model, frame);
    if (i == 0) expected.setTo(0);
    EXPECT_EQ(cv::norm(mask, expected == 255, cv::NORM_INF), 0) << "frame " << i;
    foreground += cv::countNonZero(mask);
  }
  EXPECT_GE(foreground, 200);
}

TEST(OpenCvSegmenters, ShadowsAreNotForeground) {
  // A darker version of the background, seven tenths as bright, is a shadow to both models.
  const cv::Mat light(20, 20, CV_8UC3, cv::Scalar(150, 160, 170));
  cv::Mat shaded = light.clone();
  shaded(cv::Rect(5, 5, 6, 6)) *= 0.7;
  for (const bool detect : {true, false}) {
    const std::vector<SegmenterOptions> models{Mog2Options{.detect_shadows = detect},
                                               KnnOptions{.detect_shadows = detect}};
    for (const SegmenterOptions& options : models) {
      const auto model = make_segmenter(options);
      for (int i = 0; i < 30; ++i) segment(*model, light);
      EXPECT_EQ(cv::countNonZero(segment(*model, shaded)), detect ? 0 : 36) << options.index();
    }
  }
}

TEST(OpenCvSegmenters, KnnSeesAnObjectInTheSecondFrame) {
  const cv::Mat still(20, 20, CV_8UC3, cv::Scalar(50, 60, 70));
  cv::Mat object = still.clone();
  object(cv::Rect(5, 5, 6, 6)).setTo(cv::Scalar(200, 210, 220));
  const auto model = make_segmenter(KnnOptions{});
  EXPECT_EQ(cv::countNonZero(segment(*model, still)), 0);
  const cv::Mat mask = segment(*model, object);
  EXPECT_EQ(cv::countNonZero(mask), 36);
  EXPECT_EQ(cv::countNonZero(mask(cv::Rect(5, 5, 6, 6))), 36);
}

TEST(OpenCvSegmenters, RefuseOptionsOutOfRange) {
  EXPECT_THROW(make_segmenter(Mog2Options{.history_frames = 0}), ConfigError);
  EXPECT_THROW(make_segmenter(Mog2Options{.variance_threshold = 0.0}), ConfigError);
  EXPECT_THROW(make_segmenter(KnnOptions{.squared_distance_threshold = -1.0}), ConfigError);
}

}  // namespace
}  // namespace survtrack
