// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

// Paths as JSON and back.

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "pipeline/json_reader.hpp"
#include "survtrack/core/errors.hpp"
#include "survtrack/core/version.hpp"
#include "survtrack/tracking/paths.hpp"

namespace survtrack {
namespace {

using Json = nlohmann::ordered_json;

constexpr int most_side_px = 1'000'000;
constexpr std::size_t most_name_bytes = 100;

void put(Json& entry, const Path& path) {
  entry["closed"] = path.closed();
  entry["kind"] = to_string(path.kind());
  if (std::isfinite(path.max_distance_px())) entry["max_distance_px"] = path.max_distance_px();
  entry["points"] = Json::array();
  for (const Point& point : path.points()) entry["points"].push_back({point.x, point.y});
}

PathKind kind_of(const JsonReader& json) {
  const std::string name = json.text();
  for (const PathKind kind : {PathKind::line, PathKind::curve}) {
    if (name == to_string(kind)) return kind;
  }
  json.refuse("is " + Json(name).dump() + "; expected line or curve");
}

Path path_of(const JsonReader& json) {
  std::vector<Point> points;
  for (const JsonReader& entry : json["points"].items()) {
    const auto place = entry.items(2);
    points.push_back({place[0].number(-Path::most_px, Path::most_px), place[1].number(-Path::most_px, Path::most_px)});
  }
  const bool closed = json.has("closed") && json["closed"].boolean();
  const PathKind kind = json.has("kind") ? kind_of(json["kind"]) : PathKind::line;
  const double most_distance_px =
      json.has("max_distance_px") ? json["max_distance_px"].number() : std::numeric_limits<double>::infinity();
  try {
    return Path(std::move(points), closed, kind, most_distance_px);
  } catch (const InputError& error) {
    throw InputError(json.path() + "." + error.what());
  }
}

}  // namespace

std::string Path::to_json() const {
  Json entry;
  put(entry, *this);
  return entry.dump(1);
}

Path Path::from_json(const std::string& json, const std::string& source) {
  const Json parsed = parse_json(json, source, "a path");
  const JsonReader entry(parsed, source);
  entry.allow_only({"closed", "kind", "max_distance_px", "points"});
  return path_of(entry);
}

void Paths::add(const std::string& name, const Path& path) {
  const auto is_control = [](char c) { return static_cast<unsigned char>(c) < 32 || c == 127; };
  std::string shown;
  try {
    shown = Json(name).dump();
  } catch (const Json::exception&) {
    throw InputError("name: is not UTF-8; expected the name of a path");
  }
  if (name.empty() || name.size() > most_name_bytes || std::any_of(name.begin(), name.end(), is_control)) {
    throw InputError("name: " + shown + " is not allowed; expected 1 to 100 bytes without control characters");
  }
  for (const NamedPath& item : items_) {
    if (item.name == name) throw InputError("name: " + shown + " is the name of two paths; expected each once");
  }
  items_.push_back({name, path});
}

std::string Paths::to_json() const {
  Json file = {{"survtrack", version()}, {"frame_size", nullptr}};
  if (frame_width > 0 && frame_height > 0) file["frame_size"] = {frame_width, frame_height};
  file["paths"] = Json::array();
  for (const NamedPath& item : items_) {
    Json entry = {{"name", item.name}};
    put(entry, item.path);
    file["paths"].push_back(entry);
  }
  return file.dump(1);
}

Paths Paths::from_json(const std::string& json, const std::string& source) {
  const Json parsed = parse_json(json, source, "paths");
  const JsonReader file(parsed, source);
  file.allow_only({"survtrack", "frame_size", "paths"});
  Paths paths;
  if (file.has("frame_size")) {
    const auto sides = file["frame_size"].items(2);
    paths.frame_width = static_cast<int>(sides[0].integer(1, most_side_px));
    paths.frame_height = static_cast<int>(sides[1].integer(1, most_side_px));
  }
  for (const JsonReader& entry : file["paths"].items()) {
    entry.allow_only({"name", "closed", "kind", "max_distance_px", "points"});
    const Path path = path_of(entry);
    try {
      paths.add(entry["name"].text(), path);
    } catch (const InputError& error) {
      const std::string message = error.what();
      // A reader's own message begins with the path already.
      throw InputError(message.rfind(entry.path(), 0) == 0 ? message : entry.path() + "." + message);
    }
  }
  return paths;
}

}  // namespace survtrack
