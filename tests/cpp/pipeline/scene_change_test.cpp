// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include <gtest/gtest.h>

#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "../error_message.hpp"
#include "../segmentation/scene_pictures.hpp"
#include "survtrack/pipeline/pipeline.hpp"

namespace survtrack {
namespace {

Config guarded(const SegmenterOptions& segmenter, SceneAction action = SceneAction::restart) {
  Config config;
  config.segmenter = segmenter;
  GuardOptions guard;
  guard.action = action;
  config.scene_change = guard;
  config.cleanup.median_px = 0;
  return config;
}

std::vector<SegmenterOptions> all_segmenters() {
  StaticReferenceOptions median;
  median.source = ReferenceSource::median;
  NormalizedDifferenceOptions previous;
  previous.reference = DifferenceReference::previous;
  MovingAverageOptions causal;
  causal.window = Window::causal;
  MovingAverageOptions centred;
  centred.window_frames = 9;
  return {SelectiveOptions{}, Mog2Options{}, KnnOptions{}, StaticReferenceOptions{}, median,
          NormalizedDifferenceOptions{}, previous, HornSchunckOptions{}, causal, centred};
}

/// Part of the frame that is foreground, frame by frame at ten a second, and the events.
struct Outcome {
  std::vector<double> foreground;
  std::vector<Event> events;
};

Outcome run(Detector& detector, const std::vector<cv::Mat>& frames) {
  Outcome result;
  const auto take = [&](const Detections& detections) {
    result.foreground.push_back(cv::countNonZero(detections.mask) / static_cast<double>(detections.mask.total()));
    result.events.insert(result.events.end(), detections.events.begin(), detections.events.end());
  };
  for (std::size_t i = 0; i < frames.size(); ++i) {
    if (const auto detections = detector.process(frames[i], 0.1 * static_cast<double>(i))) take(*detections);
  }
  for (const Detections& detections : detector.finish()) take(detections);
  return result;
}

std::vector<cv::Mat> stills(const cv::Mat& scene, int count, std::vector<cv::Mat> before = {}) {
  for (int i = 0; i < count; ++i) before.push_back(noisy(scene, static_cast<int>(before.size())));
  return before;
}

TEST(SceneChange, ACutEmptiesTheMaskOfEveryModel) {
  for (const SegmenterOptions& options : all_segmenters()) {
    Detector detector(guarded(options));
    const Outcome result = run(detector, stills(colorful_scene(2), 30, stills(colorful_scene(1), 30)));
    const char* const name = std::visit([](const auto& one) { return one.model; }, options);
    ASSERT_EQ(result.foreground.size(), 60U);
    ASSERT_EQ(result.events.size(), 1U) << name;
    EXPECT_EQ(result.events[0].kind, EventKind::scene_changed);
    EXPECT_EQ(result.events[0].index, 30);
    EXPECT_EQ(result.events[0].time_s, 3.0);
    EXPECT_TRUE(contains(result.events[0].text, "The scene changed (cut", "changed_pixels", "0.450", "starts anew"));
    EXPECT_EQ(result.foreground[30], 0.0) << name;
    // A flow over ten frames would look back over the cut, and an average remember the scene before.
    for (std::size_t i = 31; i < 60; ++i) EXPECT_LT(result.foreground[i], 0.02) << name << " " << i;
  }
}

TEST(SceneChange, WithoutAGuardOrActionABackgroundThatIsNotLearnedFloods) {
  for (const bool report : {false, true}) {
    Config config = guarded(StaticReferenceOptions{}, SceneAction::report);
    if (!report) config.scene_change = NoSceneChangeOptions{};
    Detector detector(config);
    const Outcome result = run(detector, stills(colorful_scene(2), 10, stills(colorful_scene(1), 10)));
    EXPECT_EQ(result.events.size(), report ? 1U : 0U);
    for (std::size_t i = 10; i < 20; ++i) EXPECT_GT(result.foreground[i], 0.5);
  }
}

TEST(SceneChange, InfraredALampAndDuskDoNotFloodABackgroundThatIsNotLearned) {
  const cv::Mat day = colorful_scene(1);
  std::vector<cv::Mat> frames = stills(day, 20);
  for (int i = 0; i < 20; ++i) frames.push_back(without_color(day));
  frames = stills(day, 20, std::move(frames));
  frames = stills(lit(day, 0.5), 20, std::move(frames));
  for (int i = 0; i < 100; ++i) frames.push_back(noisy(lit(day, 0.5 + 0.005 * i), i));
  Detector detector(guarded(StaticReferenceOptions{}));
  const Outcome result = run(detector, frames);
  ASSERT_GE(result.events.size(), 4U);
  EXPECT_TRUE(contains(result.events[0].text, "infrared", "color_part"));
  EXPECT_EQ(result.events[0].index, 20);
  EXPECT_TRUE(contains(result.events[1].text, "infrared", "color_part"));
  EXPECT_TRUE(contains(result.events[2].text, "brightness"));
  EXPECT_EQ(result.events[2].index, 60);
  EXPECT_TRUE(contains(result.events[3].text, "gradual"));
  // What changes slowly is told when nearly half of the frame is far from its mean, not before.
  for (std::size_t i = 0; i < frames.size(); ++i) EXPECT_LT(result.foreground[i], i < 80 ? 0.1 : 0.65) << i;
  Config alone;
  alone.segmenter = StaticReferenceOptions{};
  Detector unguarded(alone);
  EXPECT_GT(run(unguarded, frames).foreground[85], 0.8);
}

TEST(SceneChange, BlackFramesLeaveTheBackgroundAsItWas) {
  const cv::Mat scene = colorful_scene(1);
  for (const SegmenterOptions& options : all_segmenters()) {
    const char* const name = std::visit([](const auto& one) { return one.model; }, options);
    std::vector<cv::Mat> frames = stills(scene, 40);
    for (int i = 0; i < 3; ++i) frames.emplace_back(72, 96, CV_8UC3, cv::Scalar::all(8));
    frames = stills(scene, 20, std::move(frames));
    const cv::Rect object(30, 20, 20, 20);
    for (std::size_t i = 43; i < 63; ++i) frames[i](object).setTo(cv::Scalar(250, 250, 250));
    Detector detector(guarded(options));
    const Outcome result = run(detector, frames);
    ASSERT_EQ(result.events.size(), 1U) << name;
    EXPECT_TRUE(contains(result.events[0].text, "black frame", "black_part 1.000", "the background is kept"));
    for (std::size_t i = 40; i < 43; ++i) EXPECT_EQ(result.foreground[i], 0.0) << name;
    // What came with the picture is found at once: the model did not start anew.
    const double found = 400.0 / (96.0 * 72.0);
    EXPECT_GT(result.foreground[43], 0.3 * found) << name;
    EXPECT_LT(result.foreground[43], 4.0 * found) << name;
  }
}

TEST(SceneChange, RelearnKeepsMasksEmptyWhileItLearns) {
  std::vector<cv::Mat> frames = stills(colorful_scene(2), 60, stills(colorful_scene(1), 20));
  for (std::size_t i = 21; i < 80; ++i) frames[i](cv::Rect(static_cast<int>(i) - 20, 20, 12, 12)).setTo(cv::Scalar(255, 255, 255));
  Config config = guarded(SelectiveOptions{}, SceneAction::relearn);
  config.set("scene_change.relearn_s=1.5");
  Detector detector(config);
  const Outcome result = run(detector, frames);
  ASSERT_EQ(result.events.size(), 1U);
  for (std::size_t i = 20; i < 35; ++i) EXPECT_EQ(result.foreground[i], 0.0) << i;
  for (std::size_t i = 36; i < 80; ++i) EXPECT_GT(result.foreground[i], 0.005) << i;
  // After a reset nothing is left of it.
  detector.reset();
  EXPECT_EQ(run(detector, frames).foreground, result.foreground);
}

TEST(SceneChange, TheBackgroundIsLearnedAnewOnDemand) {
  for (const SegmenterOptions& options : all_segmenters()) {
    Config config = guarded(options);
    config.scene_change = NoSceneChangeOptions{};
    if (auto* selective = std::get_if<SelectiveOptions>(&config.segmenter)) selective->scene_change_fraction = 1.0;
    Detector detector(config);
    const int delay = detector.delay_frames();
    std::vector<double> foreground;
    const auto frames = stills(colorful_scene(2), 30, stills(colorful_scene(1), 30));
    for (int i = 0; i < 60; ++i) {
      if (i == 30 + delay) detector.relearn_background();
      const auto detections = detector.process(frames[static_cast<std::size_t>(i)], 0.1 * i);
      if (detections) foreground.push_back(cv::countNonZero(detections->mask) / static_cast<double>(detections->mask.total()));
    }
    for (std::size_t i = 30; i < foreground.size(); ++i) EXPECT_LT(foreground[i], 0.02) << options.index() << " " << i;
  }
}

TEST(SceneChange, APictureIsGivenBeforeTheFirstFrame) {
  Config config = guarded(StaticReferenceOptions{.source = ReferenceSource::picture});
  Pipeline pipeline(config);
  const cv::Mat scene = colorful_scene(1);
  FrameResult result;
  const auto missing = message_of<InputError>([&] { pipeline.process(scene, 0.0, result); });
  EXPECT_TRUE(contains(missing, "background: segmenter.source is \"picture\" and none was given"));
  pipeline.load_background(colorful_scene(1, {40, 30}));
  EXPECT_TRUE(contains(message_of<InputError>([&] { pipeline.process(scene, 0.0, result); }), "the picture is 30x40x3, the frame 72x96x3"));
  pipeline.load_background(scene);
  for (int turn = 0; turn < 2; ++turn) {
    cv::Mat frame = scene.clone();
    frame(cv::Rect(10, 10, 20, 20)).setTo(cv::Scalar::all(255));
    ASSERT_TRUE(pipeline.process(frame, 0.0, result));
    EXPECT_EQ(cv::countNonZero(result.mask()), 400);
    EXPECT_TRUE(contains(message_of<InputError>([&] { pipeline.load_background(scene); }), "background: came after the first frame"));
    pipeline.reset();
  }
  Pipeline other;
  EXPECT_TRUE(contains(message_of<InputError>([&] { other.load_background(scene); }), "background: this background model takes no picture"));
}

}  // namespace
}  // namespace survtrack
