// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

// Frames that what is learned of the scene cannot be of: refused when they come, not when their turn comes.

#include <gtest/gtest.h>

#include <string>

#include "../error_message.hpp"
#include "scene_run.hpp"

namespace survtrack {
namespace {

Config grid_config(Config config) {
  config.vicinity = GridVicinityOptions{.cell_px = 30};
  return config;
}

cv::Mat grey_frame(int width, int height) { return {height, width, CV_8UC1, cv::Scalar(90)}; }

TEST(FrameSize, SmallerThanACellIsRefusedAtOnceAndTheRunGoesOn) {
  for (const Config& config : {grid_config(scene_config()), grid_config(delayed_config(8))}) {
    Pipeline disturbed(config), quiet(config);
    EXPECT_TRUE(contains(message_of<InputError>([&] { disturbed.process(grey_frame(40, 20), 0.0); }),
                         "vicinity.cell_px: 30 is larger than the frame of 40x20 px"));
    const SyntheticScene scene;
    const auto times = steady_times(10.0, 30);
    std::string found;
    ASSERT_NO_THROW(found = fingerprint(run_scene(disturbed, scene, times)));
    EXPECT_TRUE(found == fingerprint(run_scene(quiet, scene, times)));
  }
}

TEST(FrameSize, OtherThanThatOfALearnedSceneIsRefusedAtOnceAndTheRunGoesOn) {
  const SyntheticScene scene;
  const auto times = steady_times(10.0, 30);
  for (const Config& config : {grid_config(scene_config()), grid_config(delayed_config(8))}) {
    Pipeline teacher(config);
    run_scene(teacher, scene, times);
    Pipeline disturbed(config), quiet(config);
    disturbed.load_learned_scene(teacher.learned_scene());
    quiet.load_learned_scene(teacher.learned_scene());
    EXPECT_TRUE(contains(message_of<InputError>([&] { disturbed.process(grey_frame(200, 100), 0.0); }),
                         "frame: is 200x100", "160x120"));
    std::string found;
    ASSERT_NO_THROW(found = fingerprint(run_scene(disturbed, scene, times)));
    EXPECT_TRUE(found == fingerprint(run_scene(quiet, scene, times)));
  }
}

}  // namespace
}  // namespace survtrack
