// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "survtrack/pipeline/detector.hpp"
#include "survtrack/pipeline/frame_result.hpp"
#include "survtrack/pipeline/tracker.hpp"

namespace survtrack {

/// The whole system: frame in, tracks and events out. One object a camera; two objects in two threads do
/// not meet. Same frames, times and config: the same bytes.
class Pipeline {
 public:
  /// Throws `ConfigError`.
  explicit Pipeline(const Config& config = {});
  static Pipeline from_preset(const std::string& name);

  const Config& config() const { return config_; }
  /// Frames by which results come late (75 for the centred average of 150 frames).
  int delay_frames() const { return detector_.delay_frames(); }

  /// One frame on. `image`: HxW (grey) or HxWx3 (BGR) uint8, one size for the whole run; `time_s`: increasing;
  /// `index`: the frame's index in its source, increasing, counts on from the last by default. Gives nothing
  /// while a delayed pipeline fills. Throws `InputError` and then keeps its state.
  std::optional<FrameResult> process(const cv::Mat& image, double time_s, std::optional<std::int64_t> index = {});

  /// The same, reusing the memory of `result`; false while a delayed pipeline fills.
  bool process(const cv::Mat& image, double time_s, FrameResult& result, std::optional<std::int64_t> index = {});

  /// The source has ended: the results still due, in order. After it only `reset` is allowed.
  std::vector<FrameResult> finish();

  /// The same one by one, reusing the memory of `result`; false when all is given.
  bool finish(FrameResult& result);

  /// See Detector::load_background: a picture of the empty scene.
  void load_background(const cv::Mat& picture) { detector_.load_background(picture); }

  /// See Detector::relearn_background.
  void relearn_background() { detector_.relearn_background(); }

  /// Forgets frames, tracks and all that was learned, but no picture that was loaded; the next frame is a first frame
  /// and ids start at 1.
  void reset();

  /// See Tracker::learned_scene and Tracker::load_learned_scene: a camera starts with what it knows.
  std::string learned_scene() const { return tracker_.learned_scene(); }
  void load_learned_scene(const std::string& json, const std::string& source = "scene") {
    tracker_.load_learned_scene(json, source);
  }
  /// See Tracker::load_paths.
  void load_paths(const Paths& paths) { tracker_.load_paths(paths); }

  /// See Tracker::load_zones.
  void load_zones(const std::vector<Box>& zones) { tracker_.load_zones(zones); }

 private:
  void step(FrameResult& result);

  Config config_;
  Detector detector_;
  Tracker tracker_;
};

}  // namespace survtrack
