// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include <gtest/gtest.h>

#include "survtrack/pipeline/config.hpp"

namespace survtrack {
namespace {

TEST(ConfigSet, ReadsEveryKindOfValue) {
  Config config;
  config.set("time_unit_s=0.5");
  config.set("cleanup.open_px=7");
  config.set("blobs.share_blobs=false");
  config.set("filter.noise_unit=px");
  config.set("segmenter.model=\"moving_average\"");
  config.set("  segmenter.window =  causal ");
  EXPECT_EQ(config.time_unit_s, 0.5);
  EXPECT_EQ(config.cleanup.open_px, 7);
  EXPECT_FALSE(config.blobs.share_blobs);
  EXPECT_EQ(std::get<KalmanCvOptions>(config.filter).noise_unit, NoiseUnit::px);
  EXPECT_EQ(std::get<MovingAverageOptions>(config.segmenter).window, Window::causal);
}

TEST(ConfigSet, AppliesLeftToRight) {
  Config config;
  config.set("time_unit_s=0.5");
  config.set("time_unit_s=0.25");
  EXPECT_EQ(config.time_unit_s, 0.25);
}

TEST(ConfigSet, ChoosingAModelResetsIt) {
  Config config;
  config.set("filter.model=kalman_ca");
  config.set("filter.position_noise=0.75");
  EXPECT_EQ(std::get<KalmanCaOptions>(config.filter).position_noise, 0.75);
  config.set("filter.model=kalman_ca");
  EXPECT_EQ(std::get<KalmanCaOptions>(config.filter).position_noise, KalmanCaOptions{}.position_noise);
  config.set("filter.model=kalman_cv");
  EXPECT_EQ(std::get<KalmanCvOptions>(config.filter).position_noise, KalmanCvOptions{}.position_noise);
}

TEST(ConfigSet, ChoosingAModelResetsNothingElse) {
  Config config;
  config.set("cleanup.open_px=9");
  config.set("cost.model=match_matrix");
  config.set("cost.max_match=0.4");
  config.set("filter.model=mean_velocity");
  EXPECT_EQ(config.cleanup.open_px, 9);
  EXPECT_EQ(std::get<MatchMatrixOptions>(config.cost).max_match, 0.4);
}

TEST(ConfigSet, TakesATable) {
  Config config;
  config.set("lifecycle={model = \"lost_count\", lost_after_frames = 9}");
  EXPECT_EQ(std::get<LostCountOptions>(config.lifecycle).lost_after_frames, 9);
  config.set("lifecycle={lost_after_frames = 4}");
  EXPECT_EQ(std::get<LostCountOptions>(config.lifecycle).lost_after_frames, 4);
}

}  // namespace
}  // namespace survtrack
