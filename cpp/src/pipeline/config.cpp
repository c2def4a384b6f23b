// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "survtrack/pipeline/config.hpp"

#include <algorithm>

#include "core/options_json.hpp"
#include "core/toml.hpp"
#include "pipeline/embedded_presets.hpp"
#include "survtrack/filtering/filter_bank.hpp"

namespace survtrack {
namespace {

using options_json::Json;

/// A `base` puts a preset under the options that stand beside it.
void update(Config& config, Json object) {
  Config changed = config;
  if (const auto base = object.find("base"); object.is_object() && base != object.end()) {
    if (!base->is_string()) options_json::refuse("base", *base, "one of: " + options_json::quoted_choices(preset_names()));
    const std::string name = base->get<std::string>();
    const std::vector<std::string> names = preset_names();
    if (std::find(names.begin(), names.end(), name) == names.end()) {
      throw ConfigError("base: unknown \"" + name + "\"; one of: " + options_json::quoted_choices(names));
    }
    changed = preset(name);
    object.erase("base");
  }
  options_json::assign_struct(changed, object, "");
  check_fields(changed);
  config = changed;
}

Json parse_json(const std::string& text, const std::string& source) {
  try {
    return Json::parse(text);
  } catch (const Json::parse_error& error) {
    throw ConfigError(source + ": is not JSON, at byte " + std::to_string(error.byte));
  } catch (const Json::out_of_range&) {
    throw ConfigError(source + ": holds a number that is too large");
  }
}

constexpr const char* default_preset = "survtrack";

}  // namespace

Config Config::from_toml(const std::string& text, const std::string& source) {
  Config config;
  config.update_from_toml(text, source);
  return config;
}

Config Config::from_json(const std::string& text, const std::string& source) {
  Config config;
  config.update_from_json(text, source);
  return config;
}

void Config::update_from_toml(const std::string& text, const std::string& source) {
  const Json object = json_from_toml(text, source);
  try {
    update(*this, object);
  } catch (const ConfigError& error) {
    throw ConfigError(source + ": " + error.what());
  }
}

void Config::update_from_json(const std::string& text, const std::string& source) {
  const Json object = parse_json(text, source);
  try {
    update(*this, object);
  } catch (const ConfigError& error) {
    throw ConfigError(source + ": " + error.what());
  }
}

void Config::set(const std::string& option_and_value) {
  const auto trimmed = [](const std::string& text) {
    const std::size_t first = text.find_first_not_of(" \t");
    if (first == std::string::npos) return std::string{};
    return text.substr(first, text.find_last_not_of(" \t") - first + 1);
  };
  const std::size_t equals = option_and_value.find('=');
  std::string path = equals == std::string::npos ? "" : trimmed(option_and_value.substr(0, equals));
  if (path.empty() || path.front() == '.') {
    throw ConfigError("\"" + option_and_value + "\" is not allowed; expected option=value, such as filter.model=kalman_cv");
  }
  Json object = json_from_toml_value(trimmed(option_and_value.substr(equals + 1)));
  while (!path.empty()) {
    const std::size_t dot = path.rfind('.');
    const std::string key = dot == std::string::npos ? path : path.substr(dot + 1);
    object = Json{{key, object}};
    path = dot == std::string::npos ? "" : path.substr(0, dot);
  }
  update(*this, object);
}

std::string Config::to_json() const { return options_json::struct_to_json(*this).dump(2); }

std::vector<std::string> preset_names() {
  std::vector<std::string> names = {default_preset};
  for (const EmbeddedPreset& preset : embedded_presets()) {
    if (names.front() != preset.name) names.emplace_back(preset.name);
  }
  return names;
}

std::string preset_text(const std::string& name) {
  for (const EmbeddedPreset& preset : embedded_presets()) {
    if (name == preset.name) return preset.text;
  }
  throw ConfigError("preset: unknown \"" + name + "\"; one of: " + options_json::quoted_choices(preset_names()));
}

Config preset(const std::string& name) { return Config::from_toml(preset_text(name), "preset " + name); }

}  // namespace survtrack
