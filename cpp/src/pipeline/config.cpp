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

/// Options that would do nothing: contacts that are kept for ever do not end, and only those may start anew.
void check_contacts(const CountMedianOptions& contacts, const ReentryOptions& reentry) {
  if (contacts.restart_after_s > 0.0 && !contacts.keep_contacts) {
    throw ConfigError("lifecycle.restart_after_s: " + options_json::Json(contacts.restart_after_s).dump() +
                      " needs contacts that are kept, and lifecycle.keep_contacts is false; "
                      "expected lifecycle.keep_contacts true, or 0");
  }
  if (contacts.keep_contacts && std::holds_alternative<RememberOptions>(reentry)) {
    throw ConfigError("reentry.model: \"remember\" needs tracks that end, and lifecycle.keep_contacts is true; "
                      "expected lifecycle.keep_contacts false, or reentry.model none");
  }
}

template <class Options, class = void>
struct reads_regions : std::false_type {};
template <class Options>
struct reads_regions<Options, std::void_t<decltype(Options::reads_regions)>> : std::bool_constant<Options::reads_regions> {};

template <class Variant>
struct ModelsThatRead;
template <class... Options>
struct ModelsThatRead<std::variant<Options...>> {
  static std::string names() {
    std::string names;
    const auto add = [&](const char* name, bool reads) {
      if (reads) names += (names.empty() ? "" : " or ") + std::string(name);
    };
    (add(Options::model, reads_regions<Options>::value), ...);
    return names;
  }
};

struct CheckReadsRegions {
  template <class Options>
  void operator()(const Options&) const {
    if constexpr (!reads_regions<Options>::value) {
      throw ConfigError("regions.model: \"predicted\" needs a background model that can read parts of a frame, and segmenter.model is \"" +
                        std::string(Options::model) + "\"; expected segmenter.model " + ModelsThatRead<SegmenterOptions>::names() +
                        ", or regions.model none");
    }
  }
};

void check_regions(const PredictedRegionsOptions& regions, const Config& config) {
  std::visit(CheckReadsRegions{}, config.segmenter);
  if (regions.acquisition == Acquisition::strip && regions.refresh_frames == 0) {
    throw ConfigError("regions.refresh_frames: 0 reads no strip, and regions.acquisition is \"strip\": newcomers would never be seen; "
                      "expected 1 or more, or another regions.acquisition");
  }
  if (std::holds_alternative<MeanVelocityOptions>(config.filter)) {
    throw ConfigError("regions.model: \"predicted\" needs a filter with a covariance, and filter.model is \"mean_velocity\"; "
                      "expected another filter.model, or regions.model none");
  }
  const auto* discrete = std::get_if<KalmanDiscreteOptions>(&config.filter);
  if (discrete != nullptr && discrete->covariances == Covariances::as_published) {
    throw ConfigError("regions.model: \"predicted\" needs a covariance, and filter.covariances is \"as_published\"; "
                      "expected filter.covariances checked, or regions.model none");
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

const Config& Config::check() const {
  check_fields(*this);
  check_tiling(cleanup.tiling, "cleanup.tiling");
  check_filter(filter, "filter");
  if (std::holds_alternative<MeanVelocityOptions>(filter) && std::holds_alternative<GaussianCostOptions>(cost)) {
    throw ConfigError("cost.model: \"gaussian\" needs a filter with a covariance, and filter.model is \"mean_velocity\"; "
                      "expected cost.model match_matrix, belief or distance, or another filter.model");
  }
  const auto* discrete = std::get_if<KalmanDiscreteOptions>(&filter);
  if (discrete != nullptr && discrete->covariances == Covariances::as_published &&
      std::holds_alternative<GaussianCostOptions>(cost)) {
    throw ConfigError("cost.model: \"gaussian\" needs a covariance, and filter.covariances is \"as_published\"; expected "
                      "cost.model match_matrix, belief or distance, or filter.covariances checked");
  }
  if (std::holds_alternative<KalmanBoxOptions>(filter) && !std::holds_alternative<BoxCenterOptions>(measurement)) {
    throw ConfigError("measurement.model: \"centroid\" measures no box, and filter.model is \"kalman_box\"; expected "
                      "measurement.model box_center, or another filter.model");
  }
  const auto* close = std::get_if<CloseMergeOptions>(&blobs.merge);
  const bool has_grid = std::holds_alternative<GridVicinityOptions>(vicinity);
  if (close != nullptr && close->vicinity_scaled && !has_grid) {
    throw ConfigError("blobs.merge.vicinity_scaled: true needs a vicinity grid, and vicinity.model is \"none\"; "
                      "expected vicinity.model grid, or false");
  }
  if (outputs.vicinity && !has_grid) {
    throw ConfigError("outputs.vicinity: true needs a vicinity grid, and vicinity.model is \"none\"; "
                      "expected vicinity.model grid, or false");
  }
  if (outputs.background && std::holds_alternative<HornSchunckOptions>(segmenter)) {
    throw ConfigError("outputs.background: true needs a background picture, and segmenter.model is \"horn_schunck\"; "
                      "expected another segmenter.model, or false");
  }
  if (outputs.flow && !std::holds_alternative<HornSchunckOptions>(segmenter)) {
    throw ConfigError("outputs.flow: true needs a flow field, and segmenter.model is another; "
                      "expected segmenter.model horn_schunck, or false");
  }
  if (const auto* predicted = std::get_if<PredictedRegionsOptions>(&regions)) check_regions(*predicted, *this);
  if (const auto* colors = std::get_if<ColorHistogramOptions>(&appearance)) {
    if (colors->weight == 0.0 && colors->min_intersection == 0.0) {
      throw ConfigError("appearance.weight: 0 changes nothing with appearance.min_intersection 0; expected one of them above 0, "
                        "or appearance.model none");
    }
  }
  if (const auto* contacts = std::get_if<CountMedianOptions>(&lifecycle)) check_contacts(*contacts, reentry);
  return *this;
}

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
