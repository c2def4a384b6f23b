// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <string>
#include <vector>

#include "survtrack/association/appearance_options.hpp"
#include "survtrack/association/options.hpp"
#include "survtrack/blobs/options.hpp"
#include "survtrack/core/fields.hpp"
#include "survtrack/filtering/options.hpp"
#include "survtrack/segmentation/cleanup_options.hpp"
#include "survtrack/segmentation/options.hpp"
#include "survtrack/segmentation/scene_change_options.hpp"
#include "survtrack/tracking/identity_options.hpp"
#include "survtrack/tracking/options.hpp"
#include "survtrack/tracking/region_options.hpp"

namespace survtrack {

/// Extras of a result that cost something.
struct OutputOptions {
  bool background = false;
  bool contours = false;
  bool cost_matrix = false;
  bool vicinity = false;
  bool flow = false;

  static constexpr auto fields() {
    using O = OutputOptions;
    return std::make_tuple(
        field("background", &O::background, "", "the background picture of every frame"),
        field("contours", &O::contours, "", "the outer contour of every blob"),
        field("cost_matrix", &O::cost_matrix, "", "the whole matrix of costs, tracks by detections, and that of beliefs; at most a million entries"),
        field("vicinity", &O::vicinity, "", "the vicinity grids, with vicinity.model grid"),
        field("flow", &O::flow, "", "the flow field of every frame, with segmenter.model horn_schunck"));
  }
};

/// All options of a pipeline. The defaults are the preset `survtrack`.
struct Config {
  double time_unit_s = 1.0;
  SceneChangeOptions scene_change;
  SegmenterOptions segmenter;
  CleanupOptions cleanup;
  BlobOptions blobs;
  FilterOptions filter;
  MeasurementOptions measurement;
  CostOptions cost;
  AppearanceOptions appearance;
  AssignmentOptions assignment;
  LifecycleOptions lifecycle;
  GroupOptions groups;
  ReentryOptions reentry;
  VicinityOptions vicinity;
  RegionOptions regions;
  OutputOptions outputs;

  static constexpr auto fields() {
    using O = Config;
    return std::make_tuple(
        field("time_unit_s", &O::time_unit_s, "s",
              "the filters' unit of time; published presets: the nominal frame period", between(1e-6, 3600)),
        field("scene_change", &O::scene_change, "", "what is done when the whole scene changes"),
        field("segmenter", &O::segmenter, "", "frame to foreground mask"),
        field("cleanup", &O::cleanup, "", "noise removal on the mask"),
        field("blobs", &O::blobs, "", "mask to detections"),
        field("filter", &O::filter, "", "how tracks move"),
        field("measurement", &O::measurement, "", "what of a detection a track follows"),
        field("cost", &O::cost, "", "how well a detection fits a track"),
        field("appearance", &O::appearance, "", "what else makes a detection fit a track"),
        field("assignment", &O::assignment, "", "who gets which detection"),
        field("lifecycle", &O::lifecycle, "", "when tracks are born, believed, lost and closed"),
        field("groups", &O::groups, "", "tracks that merge into one blob"),
        field("reentry", &O::reentry, "", "tracks that ended and come back"),
        field("vicinity", &O::vicinity, "", "what the scene teaches about sizes and speeds"),
        field("regions", &O::regions, "", "which parts of a frame are read"),
        field("outputs", &O::outputs, "", "extras of a result that cost something"));
  }

  /// Reads options from TOML on top of the defaults, or of the preset that its `base` names; `source` names the text in errors.
  /// Throws `ConfigError` with the option's full path, the value and what is allowed.
  static Config from_toml(const std::string& text, const std::string& source = "config");
  static Config from_json(const std::string& text, const std::string& source = "config");

  /// Reads options on top of the present ones. Choosing a variant (`model = ...`) resets it. An error leaves
  /// the config as it was.
  void update_from_toml(const std::string& text, const std::string& source = "config");
  void update_from_json(const std::string& text, const std::string& source = "config");

  /// Sets one option: "filter.velocity_noise=30", "filter.model=kalman_ca".
  void set(const std::string& option_and_value);

  /// All options, each with its unit and meaning as a comment; `from_toml` gives the same config.
  std::string to_toml() const;
  std::string to_json() const;

  /// Checks all bounds and the rules between sections, as `Detector` and `Tracker` do. The rules wait for this, because
  /// options are set one after the other. Returns the config. Throws `ConfigError`.
  const Config& check() const;

  bool operator==(const Config& other) const { return to_json() == other.to_json(); }
};

/// Names of the presets, the default one first.
std::vector<std::string> preset_names();
/// A preset's TOML file: what differs from the defaults, with the reasons. Throws `ConfigError`.
std::string preset_text(const std::string& name);
/// The config of a preset. Throws `ConfigError` naming the presets there are.
Config preset(const std::string& name);

/// The reference of all options in Markdown, made from their fields().
std::string options_reference();

}  // namespace survtrack
