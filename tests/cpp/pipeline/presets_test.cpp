// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "../error_message.hpp"
#include "survtrack/pipeline/pipeline.hpp"

namespace survtrack {
namespace {

TEST(Presets, AllLoadAndMakeAPipeline) {
  const std::vector<std::string> names = preset_names();
  ASSERT_FALSE(names.empty());
  EXPECT_EQ(names.front(), "survtrack");
  EXPECT_EQ(std::set<std::string>(names.begin(), names.end()).size(), names.size());
  EXPECT_EQ(std::count(names.begin(), names.end(), "narayana2007"), 1);
  for (const std::string& name : names) {
    EXPECT_FALSE(preset_text(name).empty()) << name;
    EXPECT_TRUE(preset(name) == Config::from_toml(preset_text(name))) << name;
    EXPECT_TRUE(Pipeline::from_preset(name).config() == preset(name)) << name;
  }
}

TEST(Presets, TheDefaultIsTheDefaultOptions) { EXPECT_TRUE(preset("survtrack") == Config{}); }

TEST(Presets, UnknownNamesAreRefusedWithTheChoices) {
  for (const char* name : {"", "narayana", "../survtrack", "Survtrack"}) {
    EXPECT_TRUE(contains(message_of<ConfigError>([&] { preset(name); }),
                         "preset: unknown \"" + std::string(name) + "\"; one of: survtrack, narayana2007"));
    EXPECT_THROW(preset_text(name), ConfigError);
    EXPECT_THROW(Pipeline::from_preset(name), ConfigError);
  }
}

TEST(Presets, Narayana2007IsWhatThePaperPrints) {
  const Config config = preset("narayana2007");
  const auto& segmenter = std::get<MovingAverageOptions>(config.segmenter);
  EXPECT_EQ(segmenter.window, Window::centred);
  EXPECT_EQ(segmenter.window_frames, 150);
  EXPECT_EQ(segmenter.threshold, 10.0);
  EXPECT_TRUE(segmenter.secondary_background);
  EXPECT_EQ(segmenter.secondary_threshold, 15.0);
  EXPECT_FALSE(config.blobs.merge_fragments);
  EXPECT_FALSE(config.blobs.share_blobs);
  EXPECT_EQ(config.blobs.min_relative_height, 0.0);  // no blob is dropped for what tracks have learned
  EXPECT_EQ(std::get<MeanVelocityOptions>(config.filter).window_steps, 5);
  EXPECT_FALSE(std::get<MeanVelocityOptions>(config.filter).extrapolate_lost);
  EXPECT_TRUE(std::holds_alternative<CentroidOptions>(config.measurement));
  EXPECT_EQ(std::get<MatchMatrixOptions>(config.cost).max_match, 0.0);
  EXPECT_TRUE(std::holds_alternative<OldestFirstOptions>(config.assignment));
  EXPECT_EQ(std::get<LostCountOptions>(config.lifecycle).lost_after_frames, 5);
  EXPECT_EQ(Pipeline(config).delay_frames(), 75);
}

}  // namespace
}  // namespace survtrack
