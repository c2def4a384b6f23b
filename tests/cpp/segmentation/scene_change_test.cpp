// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "survtrack/segmentation/scene_change.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "../error_message.hpp"
#include "scene_pictures.hpp"
#include "survtrack/core/errors.hpp"

namespace survtrack {
namespace {

struct Told {
  int frame;
  SceneChange change;
};

/// A guard that is shown frame after frame, ten a second, and what it told.
struct Watch {
  explicit Watch(const GuardOptions& options = {}) : guard(options) {}

  SceneLook show(const cv::Mat& picture) {
    const SceneLook look = guard.look(picture, 0.1 * frames);
    if (look.change) told.push_back({frames, *look.change});
    ++frames;
    return look;
  }

  void show_still(const cv::Mat& scene, int count) {
    for (int i = 0; i < count; ++i) show(noisy(scene, frames));
  }

  /// "cut 20, black 30"
  std::string kinds() const {
    std::string text;
    for (const Told& one : told) {
      text += (text.empty() ? "" : ", ") + std::string(to_string(one.change.kind)) + " " + std::to_string(one.frame);
    }
    return text;
  }

  SceneGuard guard;
  int frames = 0;
  std::vector<Told> told;
};

std::vector<SceneMeasureOptions> all_measures() {
  return {BlocksOptions{}, ChangedPixelsOptions{}, HistogramOptions{}, KolmogorovSmirnovOptions{}};
}

TEST(SceneGuard, TellsACutOnceByEveryMeasure) {
  const cv::Mat grey_scene(72, 96, CV_8UC3, cv::Scalar(60, 50, 70));
  for (const SceneMeasureOptions& measure : all_measures()) {
    GuardOptions options;
    options.measure = measure;
    options.color_level = 200.0;  // colour is not what is tested
    Watch watch(options);
    watch.show_still(grey_scene, 20);
    watch.show_still(colorful_scene(1), 20);
    ASSERT_EQ(watch.kinds(), "cut 20") << watch.told.size();
    const SceneChange& change = watch.told[0].change;
    EXPECT_EQ(change.measure, std::visit([](const auto& one) { return one.model; }, measure));
    EXPECT_EQ(change.threshold, std::visit([](const auto& one) { return one.threshold; }, measure));
    EXPECT_GT(change.value, change.threshold);
  }
}

TEST(SceneGuard, TellsALampFromACutByTheCorrelation) {
  Watch watch;
  watch.show_still(colorful_scene(1), 20);
  watch.show_still(lit(colorful_scene(1), 0.6), 20);
  watch.show_still(colorful_scene(1), 20);
  watch.show_still(colorful_scene(2), 20);
  EXPECT_EQ(watch.kinds(), "brightness 20, brightness 40, cut 60");
}

TEST(SceneGuard, TellsAGradualChangeOnceItIsFarFromTheReference) {
  for (const SceneMeasureOptions& measure : all_measures()) {
    GuardOptions options;
    options.measure = measure;
    Watch watch(options);
    watch.show_still(colorful_scene(1), 30);
    for (int i = 0; i < 300; ++i) watch.show(noisy(lit(colorful_scene(1), 1.0 - 0.002 * i), i));
    watch.show_still(lit(colorful_scene(1), 0.4), 30);
    ASSERT_GE(watch.told.size(), 1U);
    EXPECT_LE(watch.told.size(), 6U) << watch.kinds();
    for (const Told& one : watch.told) EXPECT_EQ(one.change.kind, SceneChangeKind::gradual) << watch.kinds();
  }
}

TEST(SceneGuard, FollowsWhatIsSlowerThanItsMemory) {
  GuardOptions options;
  options.memory_s = 2.0;
  Watch watch(options);
  for (int i = 0; i < 600; ++i) watch.show(noisy(lit(colorful_scene(1), 1.0 - 0.001 * i), i));
  EXPECT_EQ(watch.kinds(), "");
}

TEST(SceneGuard, TellsWhenColorGoesAndComesBack) {
  for (const SceneMeasureOptions& measure : all_measures()) {
    GuardOptions options;
    options.measure = measure;
    Watch watch(options);
    watch.show_still(colorful_scene(1), 20);
    // No noise: its own colour is that of a camera's night.
    for (int i = 0; i < 20; ++i) watch.show(without_color(colorful_scene(1)));
    watch.show_still(colorful_scene(1), 20);
    ASSERT_EQ(watch.kinds(), "infrared 20, infrared 40");
    EXPECT_EQ(watch.told[0].change.measure, "color_part");
    EXPECT_EQ(watch.told[0].change.value, 0.0);
    EXPECT_EQ(watch.told[0].change.threshold, 0.25);
  }
}

TEST(SceneGuard, KeepsTheReferenceOverBlackFrames) {
  const cv::Mat black(72, 96, CV_8UC3, cv::Scalar::all(10));
  Watch watch;
  watch.show_still(colorful_scene(1), 20);
  for (int i = 0; i < 40; ++i) EXPECT_TRUE(watch.show(black).black);
  EXPECT_FALSE(watch.show(colorful_scene(1)).black);
  watch.show_still(colorful_scene(1), 19);
  ASSERT_EQ(watch.kinds(), "black 20");
  EXPECT_EQ(watch.told[0].change.measure, "black_part");
  EXPECT_EQ(watch.told[0].change.value, 1.0);
  watch.show(black);
  watch.show_still(colorful_scene(2), 20);
  EXPECT_EQ(watch.kinds(), "black 20, black 80, cut 81") << "another scene comes back";
}

TEST(SceneGuard, ASceneThatIsDarkItselfHasNoBlackFrames) {
  const cv::Mat night(72, 96, CV_8UC3, cv::Scalar::all(5));
  Watch watch;
  for (int i = 0; i < 20; ++i) EXPECT_FALSE(watch.show(noisy(night, i)).black);
  EXPECT_EQ(watch.kinds(), "");
  watch.show_still(colorful_scene(1), 5);
  EXPECT_EQ(watch.told.size(), 1U) << watch.kinds();
}

TEST(SceneGuard, ALargeObjectIsNoChange) {
  for (const SceneMeasureOptions& measure : all_measures()) {
    GuardOptions options;
    options.measure = measure;
    Watch watch(options);
    watch.show_still(colorful_scene(1), 20);
    for (int i = 0; i < 40; ++i) {
      cv::Mat frame = noisy(colorful_scene(1), i);
      frame(cv::Rect(i, 20, 32, 40)).setTo(cv::Scalar(20, 200, 240));  // 19 % of the frame
      watch.show(frame);
    }
    EXPECT_EQ(watch.kinds(), "");
  }
}

TEST(SceneGuard, AFadeIsGradualUnlessItIsOverWithinFramesBack) {
  for (const auto& [fade_frames, gradual] : {std::pair{3, false}, std::pair{60, true}}) {
    Watch watch;
    watch.show_still(colorful_scene(1), 20);
    for (int i = 1; i <= fade_frames; ++i) {
      const double part = static_cast<double>(i) / fade_frames;
      cv::Mat mixed;
      cv::addWeighted(colorful_scene(1), 1.0 - part, colorful_scene(2), part, 0.0, mixed);
      watch.show(mixed);
    }
    ASSERT_GE(watch.told.size(), 1U);
    EXPECT_EQ(watch.told[0].change.kind == SceneChangeKind::gradual, gradual) << watch.kinds();
  }
}

TEST(SceneGuard, ResetMakesTheNextFrameAFirstFrame) {
  Watch watch;
  EXPECT_EQ(watch.guard.sample_count(), 0);
  watch.show_still(colorful_scene(1), 5);
  EXPECT_EQ(watch.guard.sample_count(), 52 * 39);
  watch.guard.reset();
  watch.frames = 0;
  watch.show(colorful_scene(2, {40, 30}));
  EXPECT_EQ(watch.kinds(), "");
  EXPECT_EQ(watch.guard.sample_count(), 40 * 30);
}

TEST(SceneGuard, TakesTheSmallestFramesAndRefusesBadOnes) {
  for (const int type : {CV_8UC1, CV_8UC3}) {
    for (const cv::Size size : {cv::Size(1, 1), cv::Size(1, 9), cv::Size(9, 1)}) {
      Watch watch;
      const cv::Mat frame(size, type, cv::Scalar::all(100));
      for (int i = 0; i < 5; ++i) watch.show(frame);
      EXPECT_EQ(watch.kinds(), "");
    }
  }
  Watch watch;
  watch.show_still(colorful_scene(1), 3);
  EXPECT_THROW(watch.guard.look(colorful_scene(1), 0.1), InputError);
  EXPECT_THROW(watch.guard.look(colorful_scene(1), std::nan("")), InputError);
  EXPECT_THROW(watch.guard.look(colorful_scene(1, {40, 30}), 9.0), InputError);
  EXPECT_THROW(watch.guard.look(cv::Mat(72, 96, CV_8UC1, cv::Scalar(0)), 9.0), InputError);
  EXPECT_THROW(watch.guard.look(cv::Mat(72, 96, CV_32FC3), 9.0), InputError);
  EXPECT_FALSE(watch.guard.look(colorful_scene(1), 9.0).change) << "its state is as it was";
  GuardOptions options;
  options.measure = BlocksOptions{.blocks_a_side = 0};
  EXPECT_TRUE(contains(message_of<ConfigError>([&] { SceneGuard{options}; }), "measure.blocks_a_side: 0 is not allowed"));
}

TEST(SceneGuard, DescribesAChangeWithItsNumbers) {
  const SceneChange change{SceneChangeKind::brightness, "blocks", 0.8125, 0.5};
  EXPECT_EQ(describe(change, SceneAction::restart),
            "The scene changed (brightness, a lamp): blocks 0.812 is beyond 0.500; the background starts anew from this frame.");
  EXPECT_TRUE(contains(describe(change, SceneAction::relearn), "learned anew"));
  EXPECT_TRUE(contains(describe(change, SceneAction::report), "nothing is done"));
  EXPECT_TRUE(contains(describe({SceneChangeKind::infrared, "color_part", 0.1, 0.25}, SceneAction::restart), "infrared", "0.100 is below 0.250"));
  EXPECT_TRUE(contains(describe({SceneChangeKind::black, "black_part", 1.0, 0.95}, SceneAction::restart), "black frame", "the background is kept"));
  EXPECT_TRUE(contains(describe({SceneChangeKind::gradual, "histogram", 0.7, 0.6}, SceneAction::restart), "(gradual): histogram"));
}

}  // namespace
}  // namespace survtrack
