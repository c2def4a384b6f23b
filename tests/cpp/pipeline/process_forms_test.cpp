// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include <gtest/gtest.h>

#include <opencv2/core.hpp>
#include <string>
#include <thread>
#include <vector>

#include "scene_run.hpp"

namespace survtrack {
namespace {

Config with_all_outputs(Config config) {
  config.outputs = {.background = true, .contours = true, .cost_matrix = true};
  return config;
}

class ProcessForms : public testing::TestWithParam<Config> {
 protected:
  const SyntheticScene scene_{.width = 96, .height = 80};
  const std::vector<double> times_s_ = steady_times(10.0, 40);
};

TEST_P(ProcessForms, ReusedBuffersHoldWhatReturnedResultsDo) {
  Pipeline returning(GetParam()), reusing(GetParam());
  const std::vector<FrameResult> results = run_scene(returning, scene_, times_s_);
  FrameResult result;
  std::size_t next = 0;
  for (const double time_s : times_s_) {
    if (!reusing.process(scene_.frame(time_s), time_s, result)) continue;
    ASSERT_EQ(fingerprint(result), fingerprint(results.at(next))) << "frame " << next;
    ++next;
  }
  while (reusing.finish(result)) {
    ASSERT_EQ(fingerprint(result), fingerprint(results.at(next))) << "frame " << next;
    ++next;
  }
  EXPECT_EQ(next, results.size());
  EXPECT_EQ(next, times_s_.size());
}

TEST_P(ProcessForms, ReturnedResultsAreNeverOverwritten) {
  Pipeline pipeline(GetParam());
  std::vector<FrameResult> kept;
  std::vector<std::string> prints;
  for (const double time_s : times_s_) {
    auto result = pipeline.process(scene_.frame(time_s), time_s);
    if (!result) continue;
    prints.push_back(fingerprint(*result));
    kept.push_back(std::move(*result));
  }
  for (std::size_t i = 0; i < kept.size(); ++i) EXPECT_EQ(fingerprint(kept[i]), prints[i]) << "frame " << i;
}

TEST_P(ProcessForms, TwoRunsAndAResetAreTheSame) {
  Pipeline first(GetParam()), second(GetParam());
  const std::string once = fingerprint(run_scene(first, scene_, times_s_));
  EXPECT_EQ(fingerprint(run_scene(second, scene_, times_s_)), once);
  first.reset();
  EXPECT_EQ(fingerprint(run_scene(first, scene_, times_s_)), once);
}

TEST_P(ProcessForms, AResetMidwayTakesAnotherFormatAndEarlierTimes) {
  Pipeline pipeline(GetParam()), fresh(GetParam());
  const SyntheticScene other{.width = 64, .height = 70, .channels = 1};
  for (int i = 0; i < 20; ++i) pipeline.process(other.frame(100.0 + i), 100.0 + i);
  pipeline.reset();
  EXPECT_EQ(fingerprint(run_scene(pipeline, scene_, times_s_)), fingerprint(run_scene(fresh, scene_, times_s_)));
}

TEST_P(ProcessForms, TwoPipelinesInTwoThreadsDoNotMeet) {
  Pipeline alone(GetParam());
  const std::string expected = fingerprint(run_scene(alone, scene_, times_s_));
  std::vector<std::string> prints(2);
  std::vector<std::thread> threads;
  for (std::string& print : prints) {
    threads.emplace_back([&] {
      Pipeline pipeline(GetParam());
      print = fingerprint(run_scene(pipeline, scene_, times_s_));
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (const std::string& print : prints) EXPECT_EQ(print, expected);
}

TEST_P(ProcessForms, InputIsLeftAlone) {
  Pipeline pipeline(GetParam());
  for (const double time_s : times_s_) {
    const cv::Mat frame = scene_.frame(time_s);
    const cv::Mat before = frame.clone();
    pipeline.process(frame, time_s);
    ASSERT_EQ(cv::norm(frame, before, cv::NORM_INF), 0.0);
  }
}

TEST_P(ProcessForms, AViewGivesWhatACopyDoes) {
  Pipeline views(GetParam()), copies(GetParam());
  for (const double time_s : times_s_) {
    const cv::Mat frame = scene_.frame(time_s);
    cv::Mat larger(frame.rows + 7, frame.cols + 13, frame.type(), cv::Scalar::all(0));
    cv::Mat view = larger(cv::Rect(5, 3, frame.cols, frame.rows));
    frame.copyTo(view);
    const auto a = views.process(view, time_s);
    const auto b = copies.process(frame, time_s);
    ASSERT_EQ(a.has_value(), b.has_value());
    ASSERT_EQ(a ? fingerprint(*a) : "", b ? fingerprint(*b) : "");
  }
}

INSTANTIATE_TEST_SUITE_P(Pipelines, ProcessForms,
                         testing::Values(scene_config(), with_all_outputs(scene_config()), delayed_config(20),
                                         with_all_outputs(delayed_config(20)), Config{}),
                         [](const auto& tested) { return "config_" + std::to_string(tested.index); });

}  // namespace
}  // namespace survtrack
