// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include <gtest/gtest.h>

#include <cstdint>
#include <opencv2/core.hpp>
#include <vector>

#include "../error_message.hpp"
#include "scene_run.hpp"

namespace survtrack {
namespace {

const SyntheticScene scene{.width = 64, .height = 72};

double time_of(int i) { return 5.0 + 0.1 * i; }

/// Frames of a camera that counts by threes from 7.
std::int64_t index_of(int i) { return 7 + 3 * i; }

void expect_frame(const FrameResult& result, int i) {
  EXPECT_EQ(result.index, index_of(i));
  EXPECT_EQ(result.time_s, time_of(i));
  EXPECT_EQ(result.detections.index, index_of(i));
  EXPECT_EQ(result.detections.time_s, time_of(i));
  EXPECT_EQ(cv::norm(result.frame, scene.frame(time_of(i)), cv::NORM_INF), 0.0) << "frame " << i;
}

TEST(Delay, ResultsCome75FramesLateWithTheirOwnFrame) {
  Pipeline pipeline(delayed_config(150));
  ASSERT_EQ(pipeline.delay_frames(), 75);
  constexpr int frames = 160;
  cv::Mat buffer;  // one for all frames, as cameras do
  int next = 0;
  for (int i = 0; i < frames; ++i) {
    scene.frame(time_of(i)).copyTo(buffer);
    const auto result = pipeline.process(buffer, time_of(i), index_of(i));
    ASSERT_EQ(result.has_value(), i >= 75) << "frame " << i;
    if (result) expect_frame(*result, next++);
  }
  EXPECT_EQ(next, frames - 75);
  buffer.setTo(0);
  for (const FrameResult& result : pipeline.finish()) expect_frame(result, next++);
  EXPECT_EQ(next, frames);
}

TEST(Delay, ASourceShorterThanTheDelay) {
  Pipeline pipeline(delayed_config(150));
  for (int i = 0; i < 10; ++i) EXPECT_FALSE(pipeline.process(scene.frame(time_of(i)), time_of(i), index_of(i)));
  const std::vector<FrameResult> rest = pipeline.finish();
  ASSERT_EQ(rest.size(), 10U);
  for (int i = 0; i < 10; ++i) expect_frame(rest[static_cast<std::size_t>(i)], i);
}

TEST(Delay, AnEmptySourceHasNoResults) {
  Pipeline delayed(delayed_config(150)), direct(scene_config());
  EXPECT_TRUE(delayed.finish().empty());
  EXPECT_TRUE(direct.finish().empty());
}

TEST(Delay, NoneWithoutLookAhead) {
  Config config = delayed_config(150);
  std::get<MovingAverageOptions>(config.segmenter).window = Window::causal;
  Pipeline causal(config), selective(scene_config());
  for (Pipeline* pipeline : {&causal, &selective}) {
    EXPECT_EQ(pipeline->delay_frames(), 0);
    for (int i = 0; i < 3; ++i) {
      const auto result = pipeline->process(scene.frame(time_of(i)), time_of(i), index_of(i));
      ASSERT_TRUE(result);
      expect_frame(*result, i);
    }
    EXPECT_TRUE(pipeline->finish().empty());
  }
}

TEST(Delay, AfterFinishOnlyResetIsAllowed) {
  for (const Config& config : {scene_config(), delayed_config(150)}) {
    Pipeline pipeline(config);
    pipeline.process(scene.frame(0.0), 0.0);
    pipeline.finish();
    EXPECT_TRUE(contains(message_of<InputError>([&] { pipeline.process(scene.frame(0.1), 0.1); }), "finish()", "reset()"));
    EXPECT_TRUE(pipeline.finish().empty());
    pipeline.reset();
    EXPECT_NO_THROW(pipeline.process(scene.frame(0.0), 0.0));
  }
}

}  // namespace
}  // namespace survtrack
