// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include <gtest/gtest.h>

#include "../error_message.hpp"
#include "scene_run.hpp"

namespace survtrack {
namespace {

Config region_config(Acquisition acquisition = Acquisition::border) {
  Config config = scene_config();
  std::get<SelectiveOptions>(config.segmenter).update_time_s = 0.2;  // whole frames for 0.4 s
  PredictedRegionsOptions regions;
  regions.acquisition = acquisition;
  regions.border = 0.2;
  regions.refresh_frames = 20;
  regions.whole_above = 100.0;  // in frames as small as these pieces of rows cost more than their pixels spare
  config.regions = regions;
  return config;
}

std::size_t count_of(const FrameResult& result, RegionKind kind) {
  std::size_t count = 0;
  for (const Region& region : result.detections.regions) count += region.kind == kind ? 1U : 0U;
  return count;
}

TEST(Regions, FindTheSameInFewerPixels) {
  const auto times_s = steady_times(10.0, 60);
  Pipeline whole(scene_config()), parts(region_config());
  const auto expected = run_scene(whole, {}, times_s), found = run_scene(parts, {}, times_s);
  const std::int64_t area = 160 * 120;
  std::int64_t read = 0;
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_EQ(expected[i].detections.pixels_read, area);
    read += found[i].detections.pixels_read;
    ASSERT_EQ(found[i].tracks.size(), expected[i].tracks.size()) << i;
    for (std::size_t k = 0; k < found[i].tracks.size(); ++k) {
      EXPECT_EQ(found[i].tracks[k].id, expected[i].tracks[k].id);
      EXPECT_GT(iou(found[i].tracks[k].box, expected[i].tracks[k].box), 0.9) << i;
    }
  }
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(count_of(found[i], RegionKind::whole_frame), 1U) << "the background is young";
  EXPECT_EQ(count_of(found[6], RegionKind::acquisition), 4U);
  EXPECT_EQ(count_of(found[6], RegionKind::refresh), 1U);
  EXPECT_EQ(count_of(found[40], RegionKind::predicted), 1U);
  EXPECT_LT(static_cast<double>(read), 0.7 * static_cast<double>(area) * static_cast<double>(found.size()));
}

TEST(Regions, SameFramesSameBytes) {
  const auto times_s = steady_times(10.0, 40);
  Pipeline a(region_config()), b(region_config());
  const std::string first = fingerprint(run_scene(a, {}, times_s));
  EXPECT_EQ(first, fingerprint(run_scene(b, {}, times_s)));
  a.reset();
  EXPECT_EQ(first, fingerprint(run_scene(a, {}, times_s)));
}

TEST(Regions, TheStripFindsWhatNoRegionHolds) {
  // Something that appears in the middle of the picture.
  SyntheticScene scene;
  scene.enters_s = -2.0;
  const auto found_after = [&](int refresh_frames) {
    Config config = region_config(Acquisition::strip);
    std::get<PredictedRegionsOptions>(config.regions).refresh_frames = refresh_frames;
    Pipeline pipeline(config);
    SyntheticScene empty;
    empty.enters_s = 1e9;
    int frames = 0;
    for (int i = 0; i < 60; ++i) {
      const double time_s = 0.1 * i;
      const auto result = pipeline.process((i < 10 ? empty : scene).frame(0.05 * i), time_s);
      if (!result->tracks.empty()) break;
      ++frames;
    }
    return frames;
  };
  EXPECT_LT(found_after(10), 25);
  EXPECT_EQ(message_of<ConfigError>([&] { found_after(0); }).find("regions.refresh_frames: 0 reads no strip"), 0U);
}

TEST(Regions, AreReadWholeWhenTheyWouldCostMore) {
  Config config = region_config();
  std::get<PredictedRegionsOptions>(config.regions).whole_above = 0.3;
  Pipeline pipeline(config);
  for (const FrameResult& result : run_scene(pipeline, {}, steady_times(10.0, 5))) {
    EXPECT_EQ(result.detections.pixels_read, 160 * 120);
    EXPECT_EQ(count_of(result, RegionKind::whole_frame), 1U);
    EXPECT_EQ(count_of(result, RegionKind::refresh), 0U);
  }
}

TEST(Regions, OfManyPiecesCostMoreThanTheirPixels) {
  for (const auto& [whole_above, pixels] : {std::pair{1.0, 160 * 120}, std::pair{100.0, 6 * 8 * 120}}) {
    Config config = region_config();
    auto& options = std::get<PredictedRegionsOptions>(config.regions);
    options.acquisition = Acquisition::zones;
    options.refresh_frames = 0;
    options.whole_above = whole_above;
    Pipeline pipeline(config);
    std::vector<Box> columns;
    for (int k = 0; k < 6; ++k) columns.push_back({20.0 + 20.0 * k, 0.0, 8.0, 120.0});
    pipeline.load_zones(columns);
    std::optional<FrameResult> result;
    for (int i = 0; i < 20; ++i) result = pipeline.process(cv::Mat(120, 160, CV_8UC3, cv::Scalar::all(90)), 0.1 * i);
    EXPECT_EQ(result->detections.pixels_read, pixels);
  }
}

TEST(Regions, AfterAFloodTheNextFrameIsReadWhole) {
  Pipeline pipeline(region_config());
  const SyntheticScene scene;
  int changed_at = -1;
  for (int i = 0; i < 20; ++i) {
    cv::Mat frame = scene.frame(0.04 * i);
    if (i >= 10) frame += cv::Scalar::all(90);
    const auto result = pipeline.process(frame, 0.1 * i);
    for (const Event& event : result->events) {
      if (event.kind == EventKind::scene_changed) changed_at = i;
    }
  }
  EXPECT_EQ(changed_at, 11);
}

TEST(Regions, NeedAModelThatReadsThem) {
  Config config = region_config();
  config.segmenter = Mog2Options{};
  const std::string message = message_of<ConfigError>([&] { config.check(); });
  EXPECT_EQ(message.find("regions.model: \"predicted\" needs a background model that can read parts of a frame, and "
                         "segmenter.model is \"mog2\"; expected segmenter.model selective"),
            0U)
      << message;
  EXPECT_THROW(Pipeline{config}, ConfigError);
}

TEST(Regions, NeedACovariance) {
  Config config = region_config();
  config.filter = MeanVelocityOptions{};
  config.cost = DistanceOptions{};
  EXPECT_EQ(message_of<ConfigError>([&] { config.check(); }).find("regions.model: \"predicted\" needs a filter with a covariance"), 0U);
  config.filter = KalmanDiscreteOptions{.covariances = Covariances::as_published};
  config.cost = DistanceOptions{};
  EXPECT_EQ(message_of<ConfigError>([&] { config.check(); })
                .find("regions.model: \"predicted\" needs a filter with a covariance, and filter.covariances is \"as_published\""),
            0U);
}

TEST(Regions, AnObjectThatFillsItsRegionIsNoFlood) {
  Config config = region_config(Acquisition::zones);
  config.lifecycle = RegionGrowthOptions{};
  auto& regions = std::get<PredictedRegionsOptions>(config.regions);
  regions.margin = 0.0;
  Pipeline pipeline(config);
  pipeline.load_zones({{0.0, 52.0, 16.0, 16.0}});
  SyntheticScene scene;
  scene.enters_s = 1.0;
  int whole = 0;
  for (int i = 0; i < 40; ++i) {
    const auto result = pipeline.process(scene.frame(0.1 * i), 0.1 * i);
    if (i > 6) whole += static_cast<int>(count_of(*result, RegionKind::whole_frame));
  }
  EXPECT_EQ(whole, 0);
}

TEST(Regions, NobodyStartsOutsideOfTheZonesInWholeFramesEither) {
  Config config = region_config(Acquisition::zones);
  std::get<SelectiveOptions>(config.segmenter).update_time_s = 100.0;  // whole frames all the time
  config.lifecycle = RegionGrowthOptions{};
  Pipeline pipeline(config);
  pipeline.load_zones({{140.0, 0.0, 20.0, 20.0}});
  for (const FrameResult& result : run_scene(pipeline, {}, steady_times(10.0, 40))) {
    EXPECT_EQ(count_of(result, RegionKind::whole_frame), 1U);
    EXPECT_EQ(count_of(result, RegionKind::acquisition), 1U);
    EXPECT_TRUE(result.tracks.empty());
  }
}

TEST(Regions, AfterAnyGapTheRunGoesOn) {
  for (const FilterOptions& filter : std::vector<FilterOptions>{KalmanCvOptions{}, KalmanCaOptions{}, ExtendedOptions{}}) {
    Config config = region_config();
    config.filter = filter;
    config.lifecycle = CountMedianOptions{.median_frames = 1, .keep_contacts = true};
    Pipeline pipeline(config);
    const SyntheticScene scene;
    double time_s = 0.0;
    for (int i = 0; i < 20; ++i) pipeline.process(scene.frame(0.1 * i), time_s = 0.1 * i);
    for (const double gap_s : {1e3, 1e7, 1e9, 1e11}) {
      time_s += gap_s;
      EXPECT_NO_THROW(pipeline.process(scene.frame(2.0), time_s)) << gap_s;
    }
  }
}

TEST(Regions, OfTheCallersOwnAreRead) {
  Detector detector(region_config());
  const SyntheticScene scene;
  detector.process(scene.frame(0.0), 0.0);
  detector.process(scene.frame(0.9), 0.9);
  const Box left{0.0, 0.0, 60.0, 120.0};
  const auto seen = detector.process(scene.frame(2.0), 1.0, {}, {}, {left});
  ASSERT_TRUE(seen);
  EXPECT_EQ(seen->pixels_read, 60 * 120 + 100 * 6) << "and a strip of 6 rows";
  ASSERT_EQ(seen->items.size(), 1U);
  EXPECT_EQ(seen->items[0].box.x, 40.0);
  EXPECT_EQ(seen->items[0].box.right(), 60.0) << "what lies beyond is not seen";
  EXPECT_EQ(message_of<InputError>([&] { detector.process(scene.frame(2.0), 1.1, {}, {}, {left, {400.0, 0.0, 10.0, 10.0}}); })
                .find("regions[1]: (400, 0, 10, 10) lies outside of the frame of 160x120"),
            0U);
  Config other = scene_config();
  other.segmenter = KnnOptions{};
  Detector whole(other);
  EXPECT_THROW(whole.process(scene.frame(0.0), 0.0, {}, {}, {left}), InputError);
}

TEST(Regions, ZonesAreAskedForAndChecked) {
  const SyntheticScene scene;
  Pipeline pipeline(region_config(Acquisition::zones));
  EXPECT_EQ(message_of<InputError>([&] { pipeline.process(scene.frame(0.0), 0.0); }).find("regions.acquisition: \"zones\" needs zones"), 0U);
  EXPECT_THROW(pipeline.load_zones({}), InputError);
  EXPECT_THROW(pipeline.load_zones({{0.0, 0.0, 0.0, 10.0}}), InputError);
  pipeline.load_zones({{0.0, 30.0, 40.0, 60.0}, {200.0, 0.0, 10.0, 10.0}});
  EXPECT_EQ(message_of<InputError>([&] { pipeline.process(scene.frame(0.0), 0.0); })
                .find("zones[1]: (200, 0, 10, 10) lies outside of the frame of 160x120 px"),
            0U);
  pipeline.load_zones({{0.0, 30.0, 40.0, 60.0}});
  const auto results = run_scene(pipeline, scene, steady_times(10.0, 40));
  EXPECT_EQ(results.back().tracks.size(), 1U);
  EXPECT_EQ(count_of(results.back(), RegionKind::acquisition), 1U);
  EXPECT_LT(results.back().detections.pixels_read, 160 * 120 / 2);
  EXPECT_THROW(pipeline.load_zones({{0.0, 30.0, 40.0, 60.0}}), InputError) << "after the first frame";
  Pipeline without(region_config(Acquisition::border));
  EXPECT_THROW(without.load_zones({{0.0, 30.0, 40.0, 60.0}}), InputError);
}

}  // namespace
}  // namespace survtrack
