// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include <gtest/gtest.h>

#include <cstdint>
#include <opencv2/core.hpp>

#include "survtrack/core/errors.hpp"
#include "survtrack/segmentation/segmenter.hpp"

namespace survtrack {
namespace {

const cv::Size frame_size(20, 10);
const cv::Rect patch(4, 3, 5, 4);
const cv::Scalar scene_color(100, 150, 200);

cv::Mat grey(int level) { return cv::Mat(frame_size, CV_8UC1, cv::Scalar(level)); }

cv::Mat with_patch(cv::Mat frame, const cv::Scalar& color) {
  frame(patch).setTo(color);
  return frame;
}

/// A segmenter and a clock.
struct Playback {
  explicit Playback(const SelectiveOptions& options = {}) : segmenter(make_segmenter(options)) {}

  const cv::Mat& at(double time_s, const cv::Mat& frame) {
    expectation.time_s = time_s;
    segmenter->segment(frame, expectation, mask, events);
    return mask;
  }
  const cv::Mat& after(double elapsed_s, const cv::Mat& frame) { return at(expectation.time_s + elapsed_s, frame); }
  /// Shows `frame` for some time.
  void show(double duration_s, const cv::Mat& frame, double elapsed_s = 0.5) {
    for (double shown_s = 0.0; shown_s < duration_s; shown_s += elapsed_s) after(elapsed_s, frame);
  }
  int foreground() const { return cv::countNonZero(mask); }
  int background(int x = 0, int y = 0) const {
    cv::Mat picture;
    segmenter->background(picture);
    return picture.ptr<std::uint8_t>(y)[x * picture.channels()];
  }

  std::unique_ptr<Segmenter> segmenter;
  Expectation expectation;
  cv::Mat mask;
  std::vector<Event> events;
};

TEST(Selective, FirstFrameIsBackground) {
  Playback run;
  const cv::Mat frame(frame_size, CV_8UC3, scene_color);
  EXPECT_EQ(cv::countNonZero(run.at(5.0, frame)), 0);
  cv::Mat picture;
  run.segmenter->background(picture);
  ASSERT_EQ(picture.type(), CV_8UC3);
  EXPECT_EQ(cv::norm(picture, frame, cv::NORM_INF), 0.0);
}

TEST(Selective, BackgroundIsThePlainMeanAtFirstAndThenFades) {
  Playback run;
  const auto background_after = [&](double time_s, int level) {
    EXPECT_EQ(cv::countNonZero(run.at(time_s, grey(level))), 0);
    return run.background();
  };
  background_after(0.0, 100);
  EXPECT_EQ(background_after(1.0, 110), 110);   // the only interval seen
  EXPECT_EQ(background_after(2.0, 100), 105);   // 110 - 10/2
  EXPECT_EQ(background_after(3.0, 114), 108);   // 105 + 9/3
  EXPECT_EQ(background_after(4.0, 100), 106);   // 108 - 8/4
  EXPECT_EQ(background_after(5.0, 118), 109);   // 106 + 12/4: the time constant is 4 s
  EXPECT_EQ(background_after(5.4, 119), 110);   // 109 + 10 * 0.4/4
  EXPECT_EQ(background_after(7.4, 100), 105);   // 110 - 10 * 2/4
  EXPECT_EQ(background_after(3600.0, 95), 95);  // a late frame counts for all the time without one
}

TEST(Selective, FastCamerasAreFollowedAsWell) {
  Playback run;
  run.at(0.0, grey(100));
  run.show(10.0, grey(100));
  run.show(20.0, grey(105), 0.002);  // 5 grey levels * 0.002/4 are far below 1/128
  EXPECT_EQ(run.background(), 105);
}

TEST(Selective, ToleranceFollowsTheNoiseOfThePixel) {
  Playback run;
  const auto frame = [](int left, int right) {
    cv::Mat result = grey(right);
    result.colRange(0, 10).setTo(left);
    return result;
  };
  run.at(0.0, frame(100, 100));
  for (int i = 0; i < 400; ++i) run.after(0.04, frame(i % 2 == 0 ? 92 : 108, 100));  // mean deviation 8
  run.after(0.04, frame(122, 122));
  EXPECT_EQ(cv::countNonZero(run.mask.colRange(0, 10)), 0);
  EXPECT_EQ(cv::countNonZero(run.mask.colRange(10, 20)), 100);
  run.after(0.04, frame(128, 100));
  EXPECT_EQ(cv::countNonZero(run.mask.colRange(0, 10)), 100);
}

TEST(Selective, ForegroundDoesNotLeakIntoTheBackground) {
  Playback run;
  run.at(0.0, grey(100));
  run.show(60.0, grey(100));
  run.show(15.0, with_patch(grey(100), 121), 0.1);
  EXPECT_EQ(run.foreground(), patch.area());
  EXPECT_EQ(run.background(patch.x, patch.y), 100);
  run.after(0.1, grey(100));
  EXPECT_EQ(run.foreground(), 0);
}

TEST(Selective, WhatStaysIsAbsorbed) {
  Playback run;
  run.at(0.0, grey(100));
  run.show(60.0, grey(100));
  const double placed_s = run.expectation.time_s + 0.5;
  run.at(placed_s, with_patch(grey(100), 180));
  run.show(20.0, with_patch(grey(100), 180));
  EXPECT_EQ(run.foreground(), patch.area());  // 20 s old
  run.after(0.5, with_patch(grey(100), 180));
  EXPECT_EQ(run.foreground(), 0);
  EXPECT_EQ(run.background(patch.x, patch.y), 180);
  run.after(0.5, grey(100));  // taken away again: the bare floor is new
  EXPECT_EQ(run.foreground(), patch.area());
}

TEST(Selective, WhatChangesItsColorIsNotAbsorbed) {
  Playback run;
  run.at(0.0, grey(100));
  for (int i = 0; i < 200; ++i) run.after(0.5, with_patch(grey(100), i % 2 == 0 ? 180 : 210));
  EXPECT_EQ(run.foreground(), patch.area());
}

TEST(Selective, GhostsOfTheFirstFrameVanishSoon) {
  Playback run;
  run.at(0.0, with_patch(grey(100), 180));
  run.show(1.0, with_patch(grey(100), 180), 0.1);
  run.show(1.0, grey(100), 0.1);
  EXPECT_EQ(run.foreground(), patch.area());  // 0.9 s old in a run of 2 s
  run.show(0.3, grey(100), 0.1);
  EXPECT_EQ(run.foreground(), 0);  // more than half of the run
  EXPECT_EQ(run.background(patch.x, patch.y), 100);
}

int foreground_of_patch(const cv::Scalar& color, const SelectiveOptions& options = {}) {
  const cv::Mat scene(frame_size, CV_8UC3, scene_color);
  Playback run(options);
  run.at(0.0, scene);
  run.after(0.1, with_patch(scene.clone(), color));
  return run.foreground();
}

TEST(Selective, ShadowsAreNoForeground) {
  EXPECT_EQ(foreground_of_patch(cv::Scalar(80, 120, 160)), 0);              // 0.8 of the scene
  EXPECT_EQ(foreground_of_patch(cv::Scalar(70, 105, 140)), 0);              // 0.7, the darkest
  EXPECT_EQ(foreground_of_patch(cv::Scalar(88, 120, 152)), 0);              // 8 off the darkened colour
  EXPECT_EQ(foreground_of_patch(cv::Scalar(89, 120, 151)), patch.area());   // 9 off
  EXPECT_EQ(foreground_of_patch(cv::Scalar(120, 120, 120)), patch.area());  // as bright, another colour
  EXPECT_EQ(foreground_of_patch(cv::Scalar(69, 105, 140)), patch.area());   // too dark
  EXPECT_EQ(foreground_of_patch(cv::Scalar(115, 172, 230)), patch.area());  // brighter
  SelectiveOptions options;
  options.remove_shadows = false;
  EXPECT_EQ(foreground_of_patch(cv::Scalar(80, 120, 160), options), patch.area());
}

TEST(Selective, GreyFramesKeepWhatIsDarker) {
  Playback run;
  run.at(0.0, grey(200));
  run.after(0.1, with_patch(grey(200), 160));
  EXPECT_EQ(run.foreground(), patch.area());
  cv::Mat picture;
  run.segmenter->background(picture);
  EXPECT_EQ(picture.type(), CV_8UC1);
}

TEST(Selective, SceneChangeStartsAnew) {
  Playback run;
  run.at(0.0, grey(100));
  run.show(10.0, grey(100));
  cv::Mat other = grey(200);
  other.rowRange(0, 3).setTo(100);  // 70 % differ
  EXPECT_EQ(cv::countNonZero(run.after(0.5, other)), 0);
  ASSERT_EQ(run.events.size(), 1U);
  EXPECT_EQ(run.events[0].kind, EventKind::scene_changed);
  EXPECT_NE(run.events[0].text.find("70 % of the frame"), std::string::npos) << run.events[0].text;
  EXPECT_EQ(run.background(0, 9), 200);
  EXPECT_EQ(cv::countNonZero(run.after(0.5, other)), 0);
  EXPECT_EQ(run.events.size(), 1U);
  other.rowRange(0, 6).setTo(30);  // 60 %: no more than the fraction
  EXPECT_EQ(cv::countNonZero(run.after(0.5, other)), 120);
  EXPECT_EQ(run.events.size(), 1U);
}

TEST(Selective, SceneChangeCanBeTurnedOff) {
  SelectiveOptions options;
  options.scene_change_fraction = 1.0;
  Playback run(options);
  run.at(0.0, grey(100));
  EXPECT_EQ(cv::countNonZero(run.after(0.5, grey(200))), frame_size.area());
  EXPECT_TRUE(run.events.empty());
}

TEST(Selective, KeptPlacesAreNotLearned) {
  Playback run;
  run.at(0.0, grey(100));
  // Two that overlap, one beyond the border, one outside.
  run.expectation.keep = {{2.0, 2.0, 5.0, 3.0}, {5.5, 3.0, 4.0, 6.0}, {17.0, -4.0, 50.0, 6.0}, {40.0, 40.0, 3.0, 3.0}};
  run.show(10.0, grey(110));
  cv::Mat expected = grey(110);
  for (const cv::Rect& kept : {cv::Rect(2, 2, 5, 3), cv::Rect(5, 3, 5, 6), cv::Rect(17, 0, 3, 2)}) expected(kept) = 100;
  cv::Mat picture;
  run.segmenter->background(picture);
  EXPECT_EQ(cv::norm(picture, expected, cv::NORM_INF), 0.0);
  cv::Mat object = grey(110);
  object.colRange(0, 10).setTo(180);
  run.show(60.0, object);
  EXPECT_EQ(run.foreground(), 15 + 30 - 4);  // absorbed elsewhere
  EXPECT_EQ(run.mask.at<std::uint8_t>(2, 2), 255);
  EXPECT_EQ(run.background(2, 2), 100);
}

TEST(Selective, StillNoisySceneStaysEmpty) {
  Playback run;
  std::uint32_t random = 1;
  cv::Mat frame(48, 64, CV_8UC3);
  for (int i = 0; i < 200; ++i) {
    for (int row = 0; row < frame.rows; ++row) {
      for (int x = 0; x < 3 * frame.cols; ++x) {
        random = random * 1664525U + 1013904223U;
        frame.ptr<std::uint8_t>(row)[x] = static_cast<std::uint8_t>(97 + (random >> 16) % 7);
      }
    }
    const cv::Mat before = frame.clone();
    ASSERT_EQ(cv::countNonZero(run.at(0.04 * i, frame)), 0) << "frame " << i;
    ASSERT_EQ(cv::norm(before, frame, cv::NORM_INF), 0.0) << "the input is left alone";
  }
}

TEST(Selective, ResetMakesTheNextFrameAFirstFrame) {
  Playback run;
  run.at(100.0, grey(100));
  run.segmenter->reset();
  EXPECT_EQ(cv::countNonZero(run.at(0.0, cv::Mat(3, 4, CV_8UC3, scene_color))), 0);
  EXPECT_TRUE(run.events.empty());
  EXPECT_EQ(run.mask.size(), cv::Size(4, 3));
}

TEST(Selective, BadFramesAndTimesAreRefused) {
  Playback run;
  run.at(1.0, grey(100));
  EXPECT_THROW(run.at(1.0, grey(100)), InputError);
  EXPECT_THROW(run.at(0.5, grey(100)), InputError);
  EXPECT_THROW(run.at(2.0, cv::Mat(frame_size, CV_8UC3, scene_color)), InputError);
  EXPECT_THROW(run.at(2.0, cv::Mat(frame_size, CV_16UC1, cv::Scalar(0))), InputError);
  EXPECT_EQ(cv::countNonZero(run.at(2.0, grey(100))), 0);
}

}  // namespace
}  // namespace survtrack
