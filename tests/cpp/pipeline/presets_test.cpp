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

TEST(Presets, ABaseIsAPresetUnderTheOptionsBesideIt) {
  const Config config = Config::from_toml("base = \"narayana2007\"\n[lifecycle]\nlost_after_frames = 9\n");
  EXPECT_EQ(std::get<LostCountOptions>(config.lifecycle).lost_after_frames, 9);
  EXPECT_TRUE(std::holds_alternative<BeliefOptions>(config.cost));
  Config expected = preset("narayana2007");
  expected.set("lifecycle.lost_after_frames=9");
  EXPECT_TRUE(config == expected);
  EXPECT_TRUE(Config::from_json(R"({"base": "narayana2007", "lifecycle": {"lost_after_frames": 9}})") == expected);
}

TEST(Presets, AnUnknownBaseIsRefusedByName) {
  EXPECT_TRUE(contains(message_of<ConfigError>([] { Config::from_toml("base = \"narayana\"\n", "yard.toml"); }),
                       "yard.toml: ", "unknown \"narayana\"; one of: survtrack, narayana2007"));
  EXPECT_TRUE(contains(message_of<ConfigError>([] { Config::from_toml("base = 2007\n", "yard.toml"); }),
                       "yard.toml: base: 2007 is not allowed; expected one of: "));
}

TEST(Presets, TheThreeOfNarayana2007DifferInTheirFormulas) {
  const Config whole = preset("narayana2007");
  const Config euclidean = preset("narayana2007_euclidean");
  const Config published = preset("narayana2007_published");
  EXPECT_EQ(std::get<BeliefOptions>(whole.cost).order, BeliefOrder::free);
  EXPECT_GT(std::get<BeliefOptions>(whole.cost).learn_after, 0);
  EXPECT_GT(std::get<MatchMatrixOptions>(euclidean.cost).velocity_break_point, 0.0);
  EXPECT_EQ(std::get<BeliefOptions>(published.cost).order, BeliefOrder::published);
  EXPECT_EQ(std::get<BeliefOptions>(published.cost).learn_after, 0);
  EXPECT_EQ(std::get<GridVicinityOptions>(published.vicinity).form, VicinityForm::published_constant);
}

TEST(Presets, Narayana2007IsWhatThePaperPrints) {
  const Config config = preset("narayana2007");
  const auto& segmenter = std::get<MovingAverageOptions>(config.segmenter);
  EXPECT_EQ(segmenter.window, Window::centred);
  EXPECT_EQ(segmenter.window_frames, 150);
  EXPECT_EQ(segmenter.threshold, 10.0);
  EXPECT_TRUE(segmenter.secondary_background);
  EXPECT_EQ(segmenter.secondary_threshold, 15.0);
  EXPECT_TRUE(std::get<CloseMergeOptions>(config.blobs.merge).vicinity_scaled);
  EXPECT_EQ(std::get<CloseMergeOptions>(config.blobs.merge).threshold_y_px, 5.0);
  const auto& vicinity = std::get<GridVicinityOptions>(config.vicinity);
  EXPECT_EQ(vicinity.form, VicinityForm::settling);
  EXPECT_EQ(vicinity.cell_px, 30);
  EXPECT_EQ(vicinity.max_factor, 5.0);
  EXPECT_EQ(vicinity.learning_rate, 0.1);
  EXPECT_FALSE(config.blobs.share_blobs);
  EXPECT_EQ(config.blobs.min_relative_height, 0.0);  // no blob is dropped for what tracks have learned
  EXPECT_EQ(std::get<MeanVelocityOptions>(config.filter).window_steps, 5);
  EXPECT_FALSE(std::get<MeanVelocityOptions>(config.filter).extrapolate_lost);
  EXPECT_TRUE(std::holds_alternative<CentroidOptions>(config.measurement));
  EXPECT_EQ(std::get<BeliefOptions>(config.cost).color_weight, 150.0);
  EXPECT_EQ(std::get<BeliefOptions>(config.cost).position_weight, 150.0);
  EXPECT_EQ(std::get<MatchMatrixOptions>(preset("narayana2007_euclidean").cost).max_match, 0.0);
  EXPECT_TRUE(std::holds_alternative<OldestFirstOptions>(config.assignment));
  EXPECT_EQ(std::get<LostCountOptions>(config.lifecycle).lost_after_frames, 5);
  EXPECT_EQ(Pipeline(config).delay_frames(), 75);
}

TEST(Presets, Semko2007IsWhatTheThesisPrints) {
  const Config config = preset("semko2007");
  EXPECT_EQ(config.time_unit_s, 0.04);
  const auto& flow = std::get<HornSchunckOptions>(config.segmenter);
  EXPECT_EQ(flow.frames_back, 10);
  EXPECT_EQ(flow.smoothness, 0.5);
  EXPECT_EQ(flow.sweeps, 10);
  // Not the printed 0.03: see the preset.
  EXPECT_EQ(flow.magnitude_threshold, 0.06);
  EXPECT_EQ(config.cleanup.temporal_median_frames, 3);
  EXPECT_EQ(config.cleanup.median_px + config.cleanup.open_px + config.cleanup.close_px, 0);
  const auto& tiling = std::get<QuadrantsOptions>(config.cleanup.tiling);
  EXPECT_EQ(tiling.overlap_px, 10);
  EXPECT_EQ(tiling.erode_top_left_px, 4);
  EXPECT_EQ(tiling.dilate_top_left_px, 11);
  EXPECT_EQ(tiling.erode_top_right_px, 4);
  EXPECT_EQ(tiling.dilate_top_right_px, 14);
  EXPECT_EQ(tiling.erode_bottom_left_px, 4);
  EXPECT_EQ(tiling.dilate_bottom_left_px, 14);
  EXPECT_EQ(tiling.erode_bottom_right_px, 4);
  EXPECT_EQ(tiling.dilate_bottom_right_px, 15);
  EXPECT_EQ(config.blobs.min_area_px, 560.0);
  EXPECT_EQ(config.blobs.min_area_fraction, 0.0);
  EXPECT_EQ(config.blobs.max_blobs, 10);
  EXPECT_FALSE(config.blobs.share_blobs);
  EXPECT_EQ(config.blobs.min_relative_height, 0.0);
  EXPECT_TRUE(std::holds_alternative<NoMergeOptions>(config.blobs.merge));
  const auto& filter = std::get<KalmanCaOptions>(config.filter);
  EXPECT_EQ(filter.noise_unit, NoiseUnit::px);
  EXPECT_EQ(filter.noise_form, NoiseForm::identity);
  EXPECT_NEAR(filter.acceleration_noise * filter.acceleration_noise, 0.5, 1e-12);
  EXPECT_EQ(filter.position_noise, 1.0);
  EXPECT_EQ(filter.initial_position * filter.initial_position, 9.0);
  EXPECT_EQ(filter.initial_velocity * filter.initial_velocity, 25.0);
  EXPECT_EQ(filter.initial_acceleration * filter.initial_acceleration, 49.0);
  EXPECT_TRUE(std::holds_alternative<CentroidOptions>(config.measurement));
  EXPECT_EQ(std::get<DistanceOptions>(config.cost).max_distance_px, 0.0);
  EXPECT_FALSE(std::get<HungarianOptions>(config.assignment).confirmed_first);
  const auto& lifecycle = std::get<CountMedianOptions>(config.lifecycle);
  EXPECT_EQ(lifecycle.median_frames, 25);
  EXPECT_EQ(lifecycle.max_contacts, 10);
  EXPECT_FALSE(lifecycle.keep_contacts);
}

TEST(Presets, TheOthersOfItsKindDifferInWhatTheySay) {
  Config published = preset("semko2007");
  published.set("segmenter.magnitude_threshold=0.03");
  published.set("assignment.model=row_order");
  EXPECT_TRUE(published == preset("semko2007_published"));
  Config suliman = preset("semko2007");
  for (const char* change : {"segmenter.frames_back=1", "segmenter.smoothness=0.6", "cleanup.tiling.model=whole",
                             "cleanup.tiling.erode_px=4", "cleanup.tiling.dilate_px=11", "blobs.max_blobs=1",
                             "lifecycle.median_frames=1", "lifecycle.max_contacts=1", "lifecycle.keep_contacts=true",
                             "lifecycle.restart_after_s=1"}) {
    suliman.set(change);
  }
  EXPECT_TRUE(suliman == preset("suliman2010"));
}

}  // namespace
}  // namespace survtrack
