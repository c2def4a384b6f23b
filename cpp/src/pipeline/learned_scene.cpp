// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

// What a tracker learned of its scene, as JSON and back.

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "pipeline/json_reader.hpp"
#include "survtrack/core/version.hpp"
#include "survtrack/pipeline/tracker.hpp"

namespace survtrack {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::int64_t most_updates = std::int64_t{1} << 53;
constexpr int most_side_px = 1'000'000;
constexpr double most = 1e18;  // squares and sums of it stay finite

// ---------------------------------------------------------------- law of sizes

Json to_json(const ScaleLearner::State& s) {
  return {{"samples", s.samples}, {"frame_height", s.frame_height}, {"sum_1", s.sum_1},   {"sum_s", s.sum_s},
          {"sum_ss", s.sum_ss},   {"sum_h", s.sum_h},               {"sum_sh", s.sum_sh}, {"spread", s.spread}};
}

ScaleLearner::State scale_of(const JsonReader& json) {
  ScaleLearner::State s;
  s.samples = static_cast<int>(json["samples"].integer(0, std::numeric_limits<int>::max()));
  s.frame_height = json["frame_height"].number(0.0, most_side_px);
  s.sum_1 = json["sum_1"].number(0.0, most);
  s.sum_s = json["sum_s"].number(-most, most);
  s.sum_ss = json["sum_ss"].number(0.0, most);
  s.sum_h = json["sum_h"].number(0.0, most);
  s.sum_sh = json["sum_sh"].number(-most, most);
  s.spread = json["spread"].number(0.0, 1.0);
  if (s.samples > 0 && !(s.frame_height > 0.0 && s.sum_1 > 0.0)) json.refuse("has samples, but no height or weight");
  if (s.sum_s * s.sum_s > s.sum_1 * s.sum_ss * (1.0 + 1e-9)) json.refuse("has sums that no samples give");
  return s;
}

// ---------------------------------------------------------------- vicinity grids

Json to_json(int class_id, const LearnedVicinity& learned) {
  Json cells = Json::array();
  for (const VicinityCell& c : learned.grid.cells) {
    cells.push_back({c.factor_y, c.factor_x, c.updates, c.mean_step_px, c.step_variance_px2});
  }
  return {{"class_id", class_id},
          {"updates", learned.motion.updates},
          {"mean_displacement_px", {learned.motion.mean_x_px, learned.motion.mean_y_px}},
          {"cells", cells}};
}

VicinityCell cell_of(const JsonReader& json, double max_factor) {
  const auto values = json.items(5);
  VicinityCell cell;
  cell.factor_y = values[0].number(1.0, max_factor);
  cell.factor_x = values[1].number(1.0, max_factor);
  cell.updates = values[2].integer(0, most_updates);
  cell.mean_step_px = values[3].number(0.0, most);
  cell.step_variance_px2 = values[4].number(0.0, most);
  return cell;
}

std::map<int, LearnedVicinity> vicinity_of(const JsonReader& json, const GridVicinityOptions& options, int width, int height) {
  const auto same = [&](const char* name, double value, double expected) {
    if (value == expected) return;
    json.refuse(std::string(name) + " is " + Json(value).dump() + ", and vicinity." + name + " is " + Json(expected).dump() +
                "; expected the same");
  };
  same("cell_px", json["cell_px"].number(), options.cell_px);
  same("max_factor", json["max_factor"].number(), options.max_factor);
  VicinityGrid grid;
  grid.cell_px = options.cell_px;
  grid.frame_width = width;
  grid.frame_height = height;
  grid.rows = (height + options.cell_px - 1) / options.cell_px;
  grid.columns = (width + options.cell_px - 1) / options.cell_px;
  grid.max_factor = options.max_factor;
  std::map<int, LearnedVicinity> learned;
  for (const JsonReader& entry : json["grids"].items()) {
    const int class_id = static_cast<int>(entry["class_id"].integer(-1'000'000'000, 1'000'000'000));
    if (learned.count(class_id) > 0) entry.refuse("is a second grid of class " + std::to_string(class_id));
    LearnedVicinity& one = learned[class_id] = {grid, {}};
    one.motion.updates = entry["updates"].integer(0, most_updates);
    const auto mean = entry["mean_displacement_px"].items(2);
    one.motion.mean_x_px = mean[0].number(0.0, most);
    one.motion.mean_y_px = mean[1].number(0.0, most);
    for (const JsonReader& cell : entry["cells"].items(static_cast<std::size_t>(grid.rows) * static_cast<std::size_t>(grid.columns))) {
      one.grid.cells.push_back(cell_of(cell, options.max_factor));
    }
  }
  return learned;
}

// ---------------------------------------------------------------- densities

const char* name_of(ColorSpace space) {
  for (const auto& [name, choice] : enum_names(space)) {
    if (choice == space) return name;
  }
  return "";
}

Json to_json(const DensityLearner& learner) {
  return {{"samples", learner.samples()},
          {"range", learner.density().range()},
          {"values", learner.density().values()}};
}

Json to_json(const BeliefDensities& d, ColorSpace space) {
  return {{"color_space", name_of(space)},
          {"color", {to_json(d.color[0]), to_json(d.color[1]), to_json(d.color[2])}},
          {"y", to_json(d.y)},
          {"x", to_json(d.x)},
          {"size", to_json(d.size)}};
}

void restore(DensityLearner& learner, const JsonReader& json) {
  std::vector<double> values;
  for (const JsonReader& value : json["values"].items()) values.push_back(value.number());
  const Density density = Density::from_values(json["range"].number(), values, json.path());
  learner.restore(density, json["samples"].number(0.0, most), json.path());
}

BeliefDensities densities_of(const JsonReader& json, const BeliefOptions& options) {
  const std::string space = name_of(options.color_space);
  if (json["color_space"].text() != space) {
    json.refuse("color_space is \"" + json["color_space"].text() + "\", and cost.color_space is \"" + space +
                "\"; expected the same");
  }
  BeliefDensities densities(options.color_space, options.learn_after);
  const auto color = json["color"].items(3);
  for (std::size_t i = 0; i < 3; ++i) restore(densities.color[i], color[i]);
  restore(densities.y, json["y"]);
  restore(densities.x, json["x"]);
  restore(densities.size, json["size"]);
  return densities;
}

}  // namespace

std::string Tracker::learned_scene() const {
  Json scene = {{"survtrack", version()}, {"frame_size", nullptr}};
  if (frame_size_) scene["frame_size"] = {frame_size_->width, frame_size_->height};
  scene["scale"] = to_json(table_.scale().state());
  if (vicinity_) {
    Json grids = Json::array();
    for (const auto& [class_id, learned] : vicinity_->learned()) grids.push_back(to_json(class_id, learned));
    scene["vicinity"] = {
        {"cell_px", vicinity_->options().cell_px}, {"max_factor", vicinity_->options().max_factor}, {"grids", grids}};
  }
  if (const auto& belief = matcher_.belief()) {
    scene["densities"] = to_json(belief->densities(), belief->options().color_space);
  }
  return scene.dump(1);
}

void Tracker::load_learned_scene(const std::string& json, const std::string& source) {
  const Json parsed = parse_json(json, source, "a learned scene");
  const JsonReader scene(parsed, source);
  if (!scene.has("scale") && !scene.has("vicinity") && !scene.has("densities")) {
    scene.refuse("is no learned scene: has none of scale, vicinity and densities");
  }
  // All is read before anything is taken over.
  std::optional<cv::Size> size;
  if (scene.has("frame_size")) {
    const auto sides = scene["frame_size"].items(2);
    size = cv::Size(static_cast<int>(sides[0].integer(1, most_side_px)), static_cast<int>(sides[1].integer(1, most_side_px)));
  }
  if (size && frame_size_ && *size != *frame_size_) {
    scene["frame_size"].refuse("is not that of the frames seen so far");
  }
  std::optional<ScaleLearner::State> scale;
  if (scene.has("scale")) scale = scale_of(scene["scale"]);
  std::map<int, LearnedVicinity> grids;
  if (vicinity_ && scene.has("vicinity") && !scene["vicinity"]["grids"].items().empty()) {
    if (!size) scene.refuse("has vicinity grids, but no frame_size");
    grids = vicinity_of(scene["vicinity"], vicinity_->options(), size->width, size->height);
  }
  std::optional<BeliefDensities> densities;
  if (matcher_.belief() && scene.has("densities")) densities = densities_of(scene["densities"], matcher_.belief()->options());

  if (size) frame_size_ = size;
  scene_loaded_ = true;
  if (scale) table_.restore(*scale);
  if (!grids.empty()) vicinity_->restore(grids);
  if (densities) matcher_.belief()->restore(*densities);
}

}  // namespace survtrack
