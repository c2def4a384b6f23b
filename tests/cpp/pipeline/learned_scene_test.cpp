// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include <gtest/gtest.h>

#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "../error_message.hpp"
#include "../tracking/box_run.hpp"
#include "../tracking/counted_config.hpp"
#include "fingerprint.hpp"
#include "scene_run.hpp"

namespace survtrack {
namespace {

using Json = nlohmann::ordered_json;

/// All that is learned: sizes, vicinity, densities.
Config learning_config() {
  Config config = belief_config();
  auto& belief = std::get<BeliefOptions>(config.cost);
  belief.learn_after = 30;
  belief.velocity_break_point = 20.0;
  config.vicinity = GridVicinityOptions{.cell_px = 40};
  config.outputs.vicinity = true;
  return config;
}

/// Two objects that walk through a frame of 320x240, one of them of a class; every 40 frames there is a pause in which
/// all tracks end.
Detections walkers(int frame) {
  Detections detections = detections_of({}, 0.1 * frame, frame, 320, 240);
  const int k = frame % 40;
  if (k >= 30) return detections;
  for (const double side : {0.0, 1.0}) {
    Detection blob = blob_at(40.0 + (6.0 + side) * k + (k % 3), 60.0 + 90.0 * side + 2.0 * k, 80.0 + 40.0 * side + k % 5);
    blob.box = Box::around(blob.position, 14.0, 20.0 + 12.0 * side);
    blob.class_id = side == 0.0 ? -1 : 3;
    detections.items.push_back(blob);
  }
  return detections;
}

/// A tracker that has seen so many frames.
Tracker taught(int frames, const Config& config = learning_config()) {
  Tracker tracker(config);
  for (int frame = 0; frame < frames; ++frame) tracker.process(walkers(frame));
  return tracker;
}

std::string scene_of(int frames = 120) { return taught(frames).learned_scene(); }

/// The scene with something changed.
std::string changed(const std::function<void(Json&)>& change) {
  Json scene = Json::parse(scene_of());
  change(scene);
  return scene.dump();
}

std::string refusal(const std::string& scene, const Config& config = learning_config()) {
  Tracker tracker(config);
  return message_of<InputError>([&] { tracker.load_learned_scene(scene, "yard.json"); });
}

// ---------------------------------------------------------------- round trips

TEST(LearnedScene, IsTheSameAfterLoading) {
  const std::string scene = scene_of();
  Tracker tracker(learning_config());
  tracker.load_learned_scene(scene);
  const Json before = Json::parse(scene), after = Json::parse(tracker.learned_scene());
  for (const char* part : {"survtrack", "frame_size", "scale", "vicinity"}) EXPECT_EQ(after[part], before[part]) << part;
  EXPECT_EQ(before["frame_size"], (Json{320, 240}));
  EXPECT_EQ(before["vicinity"]["grids"].size(), 2U);
  // Densities are normalised again, which rounds.
  for (const char* axis : {"y", "x", "size"}) {
    EXPECT_EQ(after["densities"][axis]["samples"], before["densities"][axis]["samples"]);
    EXPECT_GT(before["densities"][axis]["samples"], 30.0);
    const Json& was = before["densities"][axis]["values"];
    const Json& is = after["densities"][axis]["values"];
    ASSERT_EQ(is.size(), was.size());
    for (std::size_t i = 0; i < was.size(); ++i) {
      EXPECT_NEAR(is[i].get<double>(), was[i].get<double>(), 1e-12 * was[i].get<double>());
    }
  }
}

/// Runs the two over some frames; they must say the same. Loaded densities are normalised again, which rounds.
void expect_same(Tracker& one, Tracker& other, int from, int to) {
  for (int frame = from; frame < to; ++frame) {
    const auto a = one.process(walkers(frame)), b = other.process(walkers(frame));
    ASSERT_EQ(a.matches.detection_of_track, b.matches.detection_of_track);
    ASSERT_EQ(a.beliefs.rows(), b.beliefs.rows());
    for (int r = 0; r < a.beliefs.rows(); ++r) {
      for (int c = 0; c < a.beliefs.columns(); ++c) ASSERT_NEAR(a.beliefs(r, c), b.beliefs(r, c), 1e-12);
    }
  }
  const Json a = Json::parse(one.learned_scene()), b = Json::parse(other.learned_scene());
  for (const char* part : {"frame_size", "scale", "vicinity"}) EXPECT_EQ(a[part], b[part]) << part;
}

TEST(LearnedScene, OfAFreshTrackerIsTheBeginning) {
  Tracker fresh(learning_config()), loaded(learning_config());
  loaded.load_learned_scene(Tracker(learning_config()).learned_scene());
  expect_same(fresh, loaded, 0, 60);
}

TEST(LearnedScene, GoesOnLikeARunThatWasNotInterrupted) {
  // At the end of a pause no track is open: nothing but what was learned goes on.
  Config config = learning_config();
  std::get<BeliefOptions>(config.cost).learn_after = 0;
  Tracker whole = taught(80, config);
  Tracker second(config);
  second.load_learned_scene(whole.learned_scene());
  expect_same(whole, second, 80, 200);
}

TEST(LearnedScene, LearnedDensitiesAreUsedAtOnce) {
  Tracker fresh(learning_config()), loaded(learning_config());
  loaded.load_learned_scene(scene_of());
  TrackingResult by_fresh, by_loaded;
  for (int frame = 0; frame < 6; ++frame) {
    by_fresh = fresh.process(walkers(frame));
    by_loaded = loaded.process(walkers(frame));
  }
  EXPECT_NE(by_fresh.beliefs(0, 0), by_loaded.beliefs(0, 0));
}

TEST(LearnedScene, OfAPipelineIsWhatItsTrackerLearned) {
  Config config = scene_config();
  config.vicinity = GridVicinityOptions{.cell_px = 30};
  config.blobs.merge = CloseMergeOptions{.vicinity_scaled = true};
  const SyntheticScene scene;
  const std::vector<double> times = steady_times(10.0, 40);
  Pipeline first(config);
  run_scene(first, scene, times);
  const std::string learned = first.learned_scene();
  EXPECT_GT(Json::parse(learned)["vicinity"]["grids"][0]["updates"], 5);
  Pipeline second(config), third(config);
  second.load_learned_scene(learned);
  third.load_learned_scene(learned);
  EXPECT_EQ(second.learned_scene(), learned);
  EXPECT_EQ(fingerprint(run_scene(second, scene, times)), fingerprint(run_scene(third, scene, times)));
  second.reset();
  EXPECT_EQ(second.learned_scene(), Pipeline(config).learned_scene());
}

// ---------------------------------------------------------------- other configs

TEST(LearnedScene, WhatAConfigDoesNotUseIsLeftAside) {
  const std::string scene = scene_of();
  for (const char* name : {"survtrack", "narayana2007"}) {
    Config config = preset(name);
    config.vicinity = NoVicinityOptions{};
    config.blobs.merge = NoMergeOptions{};
    Tracker tracker(config);
    EXPECT_NO_THROW(tracker.load_learned_scene(scene)) << name;
    EXPECT_EQ(Json::parse(tracker.learned_scene())["scale"], Json::parse(scene)["scale"]);
    EXPECT_NO_THROW(tracker.process(walkers(0))) << name;
  }
}

TEST(LearnedScene, WithoutGridsAndDensitiesTeachesOnlySizes) {
  Tracker plain = taught(120, counted_config());
  Tracker tracker(learning_config());
  EXPECT_NO_THROW(tracker.load_learned_scene(plain.learned_scene()));
  EXPECT_EQ(Json::parse(tracker.learned_scene())["scale"], Json::parse(plain.learned_scene())["scale"]);
}

TEST(LearnedScene, OfBoxesInAnUnknownFrameIsTaken) {
  Tracker tracker(scene_config());
  for (int frame = 0; frame < 5; ++frame) tracker.process(detections_of({{10.0 + frame, 10.0, 9.0, 9.0}}, frame, frame));
  Tracker other(scene_config());
  EXPECT_NO_THROW(other.load_learned_scene(tracker.learned_scene()));
  EXPECT_NO_THROW(other.process(detections_of({{10.0, 10.0, 9.0, 9.0}}, 0.0, 0)));
}

TEST(LearnedScene, OfAFrameThatIsKnownByHalfIsTaken) {
  Tracker tracker(scene_config());
  tracker.process(detections_of({{10.0, 10.0, 9.0, 9.0}}, 0.0, 0, 320, 0));
  Tracker other(scene_config());
  EXPECT_NO_THROW(other.load_learned_scene(tracker.learned_scene()));
}

TEST(LearnedScene, OfClassesBelowMinusOneIsTaken) {
  Tracker tracker(learning_config());
  for (int frame = 0; frame < 5; ++frame) {
    Detections detections = walkers(frame);
    for (Detection& item : detections.items) item.class_id = -2;
    tracker.process(detections);
  }
  Tracker other(learning_config());
  EXPECT_NO_THROW(other.load_learned_scene(tracker.learned_scene()));
}

TEST(LearnedScene, FramesOfAnotherSizeAreRefusedAfterwards) {
  Tracker tracker(learning_config());
  tracker.load_learned_scene(scene_of());
  EXPECT_TRUE(contains(message_of<InputError>([&] { tracker.process(detections_of({}, 0.0, 0, 640, 480)); }),
                       "frame: is 640x480", "320x240"));
  EXPECT_NO_THROW(tracker.process(detections_of({}, 0.0, 0, 320, 240)));
}

// ---------------------------------------------------------------- what is refused

TEST(LearnedScene, WhatWasMadeOtherwiseIsRefusedByName) {
  const std::string scene = scene_of();
  const auto with = [&](const std::function<void(Config&)>& change) {
    Config config = learning_config();
    change(config);
    return refusal(scene, config);
  };
  EXPECT_TRUE(contains(with([](Config& c) { std::get<GridVicinityOptions>(c.vicinity).cell_px = 30; }),
                       "yard.json.vicinity: cell_px is 40", "vicinity.cell_px is 30", "expected the same"));
  EXPECT_TRUE(contains(with([](Config& c) { std::get<GridVicinityOptions>(c.vicinity).max_factor = 4.0; }),
                       "yard.json.vicinity: max_factor is 5", "vicinity.max_factor is 4", "expected the same"));
  EXPECT_TRUE(contains(with([](Config& c) { std::get<BeliefOptions>(c.cost).color_space = ColorSpace::lab; }),
                       "yard.json.densities: color_space is \"bgr\"", "cost.color_space is \"lab\"", "expected the same"));
}

TEST(LearnedScene, ASceneOfOtherFramesIsRefusedByName) {
  Tracker tracker(learning_config());
  tracker.process(detections_of({}, 0.0, 0, 640, 480));
  EXPECT_TRUE(contains(message_of<InputError>([&] { tracker.load_learned_scene(scene_of(), "yard.json"); }),
                       "yard.json.frame_size: "));
}

TEST(LearnedScene, WhatIsNoJsonIsRefused) {
  const std::string scene = scene_of();
  for (const std::string& text : {std::string(), std::string("{"), std::string("\xff"), std::string("{\"scale\": nan}"),
                                  std::string("{\"scale\": 1e999}"), scene.substr(0, scene.size() / 2),
                                  scene.substr(0, scene.size() - 1), scene + "}"}) {
    EXPECT_TRUE(contains(refusal(text), "yard.json: ", "expected a learned scene"));
  }
}

TEST(LearnedScene, WhatIsNoSceneIsRefused) {
  for (const char* text : {"{}", "[]", "3", "null", "\"scale\"", R"({"frame_size": [320, 240]})", R"({"scale": null})"}) {
    EXPECT_TRUE(contains(refusal(text), "yard.json: is no learned scene"));
  }
}

using Change = std::pair<const char*, std::function<void(Json&)>>;

/// What each change is refused with.
const std::vector<Change>& spoilers() {
  static const std::vector<Change> all = {
      {"yard.json.frame_size: is not a list", [](Json& s) { s["frame_size"] = 5; }},
      {"yard.json.frame_size: has 3 entries; expected 2", [](Json& s) { s["frame_size"].push_back(1); }},
      {"yard.json.frame_size[0]: ", [](Json& s) { s["frame_size"][0] = 0; }},
      {"yard.json.frame_size[1]: ", [](Json& s) { s["frame_size"][1] = 240.5; }},
      {"yard.json: has vicinity grids, but no frame_size", [](Json& s) { s["frame_size"] = nullptr; }},
      {"yard.json.scale: has no \"samples\"", [](Json& s) { s["scale"] = "large"; }},
      {"yard.json.scale: has no \"spread\"", [](Json& s) { s["scale"].erase("spread"); }},
      {"yard.json.scale.samples: ", [](Json& s) { s["scale"]["samples"] = -1; }},
      {"yard.json.scale.samples: ", [](Json& s) { s["scale"]["samples"] = 1e15; }},
      {"yard.json.scale.sum_h: is not a number", [](Json& s) { s["scale"]["sum_h"] = "5"; }},
      {"yard.json.scale.sum_h: ", [](Json& s) { s["scale"]["sum_h"] = 1e200; }},
      {"yard.json.scale: has samples", [](Json& s) { s["scale"]["sum_1"] = 0.0; s["scale"]["samples"] = 7; }},
      {"yard.json.vicinity: has no \"grids\"", [](Json& s) { s["vicinity"] = 5; }},
      {"yard.json.vicinity.grids: is not a list", [](Json& s) { s["vicinity"]["grids"] = true; }},
      {"yard.json.vicinity.cell_px: is not a number", [](Json& s) { s["vicinity"]["cell_px"] = "40"; }},
      {"yard.json.vicinity: has no \"max_factor\"", [](Json& s) { s["vicinity"].erase("max_factor"); }},
      {"yard.json.vicinity.grids[0].class_id: ", [](Json& s) { s["vicinity"]["grids"][0]["class_id"] = 0.5; }},
      {"yard.json.vicinity.grids[1]: is a second grid", [](Json& s) { s["vicinity"]["grids"][1]["class_id"] = -1; }},
      {"yard.json.vicinity.grids[1].updates: ", [](Json& s) { s["vicinity"]["grids"][1]["updates"] = -3; }},
      {"yard.json.vicinity.grids[0].mean_displacement_px[1]: ",
       [](Json& s) { s["vicinity"]["grids"][0]["mean_displacement_px"][1] = nullptr; }},
      {"yard.json.vicinity.grids[0].cells: has 47 entries; expected 48",
       [](Json& s) { s["vicinity"]["grids"][0]["cells"].erase(0); }},
      {"yard.json.vicinity.grids[0].cells[2]: has 4 entries; expected 5",
       [](Json& s) { s["vicinity"]["grids"][0]["cells"][2].erase(0); }},
      {"yard.json.vicinity.grids[0].cells[2][0]: is 5.1", [](Json& s) { s["vicinity"]["grids"][0]["cells"][2][0] = 5.1; }},
      {"yard.json.vicinity.grids[0].cells[2][1]: is 0.9", [](Json& s) { s["vicinity"]["grids"][0]["cells"][2][1] = 0.9; }},
      {"yard.json.vicinity.grids[0].cells[2][4]: is -1", [](Json& s) { s["vicinity"]["grids"][0]["cells"][2][4] = -1; }},
      {"yard.json.densities.color: has 2 entries; expected 3", [](Json& s) { s["densities"]["color"].erase(0); }},
      {"yard.json.densities.color_space: is not a text", [](Json& s) { s["densities"]["color_space"] = 1; }},
      {"yard.json.densities: has no \"y\"", [](Json& s) { s["densities"].erase("y"); }},
      {"yard.json.densities.y.samples: ", [](Json& s) { s["densities"]["y"]["samples"] = -1; }},
      {"yard.json.densities.y.range: ", [](Json& s) { s["densities"]["y"]["range"] = 0.0; }},
      {"yard.json.densities.y", [](Json& s) { s["densities"]["y"]["range"] = 1.0; }},
      {"yard.json.densities.x.values[7]: is not a number", [](Json& s) { s["densities"]["x"]["values"][7] = "0"; }},
      {"yard.json.densities.x.values[7]: ", [](Json& s) { s["densities"]["x"]["values"][7] = -0.5; }},
      {"yard.json.densities.x.values: the integral", [](Json& s) { s["densities"]["x"]["values"][200] = 1e3; }},
      {"yard.json.densities.size.values: have no mass",
       [](Json& s) { for (Json& value : s["densities"]["size"]["values"]) value = 0.0; }},
      {"yard.json.densities.size.values: are 0; expected at least 3", [](Json& s) { s["densities"]["size"]["values"] = Json::array(); }},
      {"yard.json.densities.size: has 3 values",
       [](Json& s) { s["densities"]["size"]["values"] = {0.0, 0.5, 0.0}; }},  // three bins over -3 to 3
  };
  return all;
}

TEST(LearnedScene, EachWrongEntryIsRefusedByItsPath) {
  for (const auto& [message, change] : spoilers()) EXPECT_TRUE(contains(refusal(changed(change)), message));
}

TEST(LearnedScene, ARefusedSceneChangesNothing) {
  // The densities are the last to be read.
  const std::string bad = changed([](Json& s) {
    s["scale"]["sum_h"] = 1.0;
    s["vicinity"]["grids"][0]["cells"][2][0] = 4.5;
    s["densities"]["size"]["samples"] = "many";
  });
  Tracker disturbed = taught(60), quiet = taught(60);
  const std::string before = disturbed.learned_scene();
  for (int frame = 60; frame < 100; ++frame) {
    EXPECT_THROW(disturbed.load_learned_scene(bad), InputError);
    EXPECT_EQ(fingerprint(disturbed.process(walkers(frame))), fingerprint(quiet.process(walkers(frame))));
  }
  EXPECT_EQ(disturbed.learned_scene(), quiet.learned_scene());
  EXPECT_NE(before, quiet.learned_scene());
}

TEST(LearnedScene, ALawOfSizesThatNoSamplesGiveIsRefused) {
  // sum_s^2 <= sum_1 sum_ss for all that was ever seen; without it the law may be infinite.
  const std::string impossible = changed([](Json& s) {
    s["scale"] = {{"samples", 200}, {"frame_height", 240.0}, {"sum_1", 1.0},   {"sum_s", 0.044721359549995794},
                  {"sum_ss", 0.0},  {"sum_h", 1.0},          {"sum_sh", 1.0}, {"spread", 0.0}};
  });
  EXPECT_TRUE(contains(refusal(impossible), "yard.json.scale: "));
}

}  // namespace
}  // namespace survtrack
