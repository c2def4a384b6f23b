// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <opencv2/core.hpp>
#include <optional>
#include <string>
#include <vector>

#include "../error_message.hpp"
#include "scene_run.hpp"

namespace survtrack {
namespace {

const SyntheticScene scene{.width = 64, .height = 72};

struct BadCall {
  cv::Mat frame;
  double time_s;
  std::optional<std::int64_t> index;
  std::string message;
};

/// Calls that may not come after the frame of index `last` at time `t`.
std::vector<BadCall> bad_calls(double t, std::int64_t last) {
  const cv::Mat good = scene.frame(t);
  const auto with_type = [&](int type) { return cv::Mat(cv::Mat::zeros(good.size(), type)); };
  return {
      {cv::Mat(), t + 0.1, {}, "frame: is empty"},
      {with_type(CV_16UC3), t + 0.1, {}, "frame: is 72x64x3 uint16"},
      {with_type(CV_32FC3), t + 0.1, {}, "frame: is 72x64x3 float32"},
      {with_type(CV_8UC4), t + 0.1, {}, "frame: is 72x64x4 uint8"},
      {with_type(CV_8UC1), t + 0.1, {}, "the frames before were 72x64x3"},
      {cv::Mat(72, 65, CV_8UC3, cv::Scalar::all(0)), t + 0.1, {}, "the frames before were 72x64x3"},
      {good, t, {}, "does not come after"},
      {good, t - 1.0, {}, "does not come after"},
      {good, std::nan(""), {}, "time_s: is nan"},
      {good, HUGE_VAL, {}, "time_s: is inf"},
      {good, t + 0.1, last, "index: " + std::to_string(last)},
      {good, t + 0.1, -1, "index: -1"},
  };
}

class BadFrames : public testing::TestWithParam<Config> {};

TEST_P(BadFrames, AreRefusedAndTheRunGoesOnAsIfTheyHadNotCome) {
  Pipeline disturbed(GetParam()), quiet(GetParam());
  std::vector<FrameResult> with_bad_calls, without;
  for (int i = 0; i < 30; ++i) {
    const double t = 0.1 * i;
    if (auto r = disturbed.process(scene.frame(t), t)) with_bad_calls.push_back(std::move(*r));
    if (auto r = quiet.process(scene.frame(t), t)) without.push_back(std::move(*r));
    if (i % 9 != 0) continue;
    for (const BadCall& bad : bad_calls(t, i)) {
      EXPECT_TRUE(contains(message_of<InputError>([&] { disturbed.process(bad.frame, bad.time_s, bad.index); }), bad.message));
    }
  }
  for (FrameResult& r : disturbed.finish()) with_bad_calls.push_back(std::move(r));
  for (FrameResult& r : quiet.finish()) without.push_back(std::move(r));
  EXPECT_EQ(fingerprint(with_bad_calls), fingerprint(without));
}

TEST_P(BadFrames, ABadFirstFrameFixesNoFormat) {
  Pipeline pipeline(GetParam());
  EXPECT_THROW(pipeline.process(cv::Mat(5, 5, CV_16UC1, cv::Scalar(0)), 0.0), InputError);
  EXPECT_THROW(pipeline.process(scene.frame(0.0), std::nan("")), InputError);
  EXPECT_THROW(pipeline.process(cv::Mat(5, 5, CV_8UC1, cv::Scalar(0)), 0.0, -3), InputError);
  EXPECT_NO_THROW(pipeline.process(scene.frame(0.0), 0.0));
}

TEST_P(BadFrames, SmallestImages) {
  for (const int type : {CV_8UC1, CV_8UC3}) {
    for (const cv::Size size : {cv::Size(1, 1), cv::Size(1, 50), cv::Size(50, 1)}) {
      Pipeline pipeline(GetParam());
      int results = 0;
      for (int i = 0; i < 25; ++i) {
        results += pipeline.process(cv::Mat(size, type, cv::Scalar::all(10 * i)), 0.1 * i) ? 1 : 0;
      }
      EXPECT_EQ(results + static_cast<int>(pipeline.finish().size()), 25);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Pipelines, BadFrames, testing::Values(scene_config(), delayed_config(20), Config{}),
                         [](const auto& tested) { return "config_" + std::to_string(tested.index); });

}  // namespace
}  // namespace survtrack
