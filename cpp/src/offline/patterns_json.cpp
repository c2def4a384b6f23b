// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

// Learned patterns as JSON and back.

#include <limits>
#include <nlohmann/json.hpp>

#include "core/options_json.hpp"
#include "pipeline/json_reader.hpp"
#include "survtrack/core/version.hpp"
#include "survtrack/offline/patterns.hpp"

namespace survtrack {
namespace {

using Json = nlohmann::ordered_json;

constexpr int most_side_px = 1'000'000;
constexpr double most_px = 1e9, most_s = 1e13;
constexpr double least = 1e-30, most = 1e30;  // ratios stay finite
constexpr std::int64_t most_tracks = std::int64_t{1} << 53;

Json to_json(const Pattern& p) {
  Json way = Json::array();
  for (const Point& point : p.way) way.push_back({point.x, point.y});
  return {{"id", p.id},
          {"count", p.count},
          {"size_px", p.size_px},
          {"speed_px_per_s", p.speed_px_per_s},
          {"speed_deviation_px_per_s", p.speed_deviation_px_per_s},
          {"duration_s", p.duration_s},
          {"duration_deviation_s", p.duration_deviation_s},
          {"way", way},
          {"spread_px", p.spread_px},
          {"time_s", p.time_s}};
}

std::vector<Point> way_of(const JsonReader& json) {
  std::vector<Point> way;
  for (const JsonReader& entry : json.items()) {
    const auto place = entry.items(2);
    way.push_back({place[0].number(-most_px, most_px), place[1].number(-most_px, most_px)});
  }
  if (way.size() < 2) json.refuse("has " + std::to_string(way.size()) + " points; expected at least 2");
  return way;
}

Pattern pattern_of(const JsonReader& json, int id) {
  Pattern p;
  p.id = static_cast<int>(json["id"].integer(1, std::numeric_limits<int>::max()));
  if (p.id != id) json["id"].refuse("is " + std::to_string(p.id) + "; expected " + std::to_string(id));
  p.count = json["count"].integer(1, most_tracks);
  p.size_px = json["size_px"].number(least, most_px);
  p.speed_px_per_s = json["speed_px_per_s"].number(least, most);
  p.speed_deviation_px_per_s = json["speed_deviation_px_per_s"].number(0.0, most);
  p.duration_s = json["duration_s"].number(0.0, most_s);
  p.duration_deviation_s = json["duration_deviation_s"].number(0.0, most_s);
  p.way = way_of(json["way"]);
  for (const JsonReader& spread : json["spread_px"].items(p.way.size())) p.spread_px.push_back(spread.number(0.0, most));
  for (const JsonReader& time : json["time_s"].items(p.way.size())) {
    p.time_s.push_back(time.number(p.time_s.empty() ? 0.0 : p.time_s.back(), most_s));
  }
  return p;
}

PatternOptions options_of(const JsonReader& file, const Json& options) {
  PatternOptions read;
  try {
    options_json::assign_struct(read, options, file["options"].path());
  } catch (const ConfigError& error) {
    throw InputError(error.what());
  }
  return read;
}

}  // namespace

std::string Patterns::to_json() const {
  Json file = {{"survtrack", version()}, {"frame_size", nullptr}};
  if (frame_width > 0 && frame_height > 0) file["frame_size"] = {frame_width, frame_height};
  file["options"] = options_json::struct_to_json(options);
  file["patterns"] = Json::array();
  for (const Pattern& pattern : patterns) file["patterns"].push_back(survtrack::to_json(pattern));
  return file.dump(1);
}

Patterns Patterns::from_json(const std::string& json, const std::string& source) {
  const Json parsed = parse_json(json, source, "learned patterns");
  const JsonReader file(parsed, source);
  Patterns learned;
  learned.options = options_of(file, file.has("options") ? parsed["options"] : Json());
  if (file.has("frame_size")) {
    const auto sides = file["frame_size"].items(2);
    learned.frame_width = static_cast<int>(sides[0].integer(1, most_side_px));
    learned.frame_height = static_cast<int>(sides[1].integer(1, most_side_px));
  }
  for (const JsonReader& entry : file["patterns"].items()) {
    learned.patterns.push_back(pattern_of(entry, static_cast<int>(learned.patterns.size()) + 1));
  }
  return learned;
}

}  // namespace survtrack
