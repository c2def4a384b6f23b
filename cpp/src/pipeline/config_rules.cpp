// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

// The rules between the sections of a config: combinations in which an option would do nothing, or could not work.

#include <string>
#include <type_traits>
#include <variant>

#include "core/options_json.hpp"
#include "survtrack/filtering/filter_bank.hpp"
#include "survtrack/pipeline/config.hpp"

namespace survtrack {
namespace {

/// Refuses an option that needs a filter with a covariance; `instead` says what else the option may be.
void check_covariance(const Config& config, const std::string& option, const std::string& instead) {
  const auto refuse = [&](const char* why, const char* other) {
    throw ConfigError(option + " needs a filter with a covariance, and " + why + "; expected " + instead + ", or " + other);
  };
  if (std::holds_alternative<MeanVelocityOptions>(config.filter)) {
    refuse("filter.model is \"mean_velocity\"", "another filter.model");
  }
  const auto* discrete = std::get_if<KalmanDiscreteOptions>(&config.filter);
  if (discrete != nullptr && discrete->covariances == Covariances::as_published) {
    refuse("filter.covariances is \"as_published\"", "filter.covariances checked");
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
struct reads_regions<Options, std::void_t<decltype(Options::reads_regions)>>
    : std::bool_constant<Options::reads_regions> {};

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
      throw ConfigError("regions.model: \"predicted\" needs a background model that can read parts of a frame, and "
                        "segmenter.model is \"" + std::string(Options::model) + "\"; expected segmenter.model " +
                        ModelsThatRead<SegmenterOptions>::names() + ", or regions.model none");
    }
  }
};

void check_regions(const PredictedRegionsOptions& regions, const Config& config) {
  std::visit(CheckReadsRegions{}, config.segmenter);
  if (regions.acquisition == Acquisition::strip && regions.refresh_frames == 0) {
    throw ConfigError("regions.refresh_frames: 0 reads no strip, and regions.acquisition is \"strip\": newcomers would "
                      "never be seen; expected 1 or more, or another regions.acquisition");
  }
  check_covariance(config, "regions.model: \"predicted\"", "regions.model none");
}

void check_cost(const Config& config) {
  if (!std::holds_alternative<GaussianCostOptions>(config.cost)) return;
  check_covariance(config, "cost.model: \"gaussian\"", "cost.model match_matrix, belief or distance");
}

void check_measurement(const Config& config) {
  if (!std::holds_alternative<KalmanBoxOptions>(config.filter)) return;
  if (std::holds_alternative<BoxCenterOptions>(config.measurement)) return;
  throw ConfigError("measurement.model: \"centroid\" measures no box, and filter.model is \"kalman_box\"; expected "
                    "measurement.model box_center, or another filter.model");
}

void check_vicinity(const Config& config) {
  if (std::holds_alternative<GridVicinityOptions>(config.vicinity)) return;
  const auto* close = std::get_if<CloseMergeOptions>(&config.blobs.merge);
  const char* option = close != nullptr && close->vicinity_scaled ? "blobs.merge.vicinity_scaled"
                       : config.outputs.vicinity                  ? "outputs.vicinity"
                                                                  : nullptr;
  if (option == nullptr) return;
  throw ConfigError(std::string(option) + ": true needs a vicinity grid, and vicinity.model is \"none\"; "
                    "expected vicinity.model grid, or false");
}

void check_pictures(const Config& config) {
  const bool flow = std::holds_alternative<HornSchunckOptions>(config.segmenter);
  if (config.outputs.background && flow) {
    throw ConfigError("outputs.background: true needs a background picture, and segmenter.model is \"horn_schunck\"; "
                      "expected another segmenter.model, or false");
  }
  if (config.outputs.flow && !flow) {
    throw ConfigError("outputs.flow: true needs a flow field, and segmenter.model is another; "
                      "expected segmenter.model horn_schunck, or false");
  }
}

void check_colors(const ColorHistogramOptions& colors) {
  if (colors.weight > 0.0 || colors.min_intersection > 0.0) return;
  throw ConfigError("appearance.weight: 0 changes nothing with appearance.min_intersection 0; expected one of them "
                    "above 0, or appearance.model none");
}

}  // namespace

const Config& Config::check() const {
  check_fields(*this);
  check_tiling(cleanup.tiling, "cleanup.tiling");
  check_filter(filter, "filter");
  check_cost(*this);
  check_measurement(*this);
  check_vicinity(*this);
  check_pictures(*this);
  if (const auto* predicted = std::get_if<PredictedRegionsOptions>(&regions)) check_regions(*predicted, *this);
  if (const auto* colors = std::get_if<ColorHistogramOptions>(&appearance)) check_colors(*colors);
  if (const auto* contacts = std::get_if<CountMedianOptions>(&lifecycle)) check_contacts(*contacts, reentry);
  return *this;
}

}  // namespace survtrack
