// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <memory>
#include <opencv2/core/mat.hpp>
#include <optional>
#include <string>

#include "survtrack/segmentation/scene_change_options.hpp"

namespace survtrack {

/// How a scene changed.
enum class SceneChangeKind {
  cut,         ///< suddenly, to another scene
  gradual,     ///< slowly: each frame is like those shortly before, and no longer like the long-term reference
  brightness,  ///< suddenly, and the scene is still the same: a lamp
  infrared,    ///< its colour went or came back
  black,       ///< a black frame: the background is kept
};

/// Name of a kind, as in the events: "cut", ...
const char* to_string(SceneChangeKind kind);

/// A change, with what showed it.
struct SceneChange {
  SceneChangeKind kind = SceneChangeKind::cut;
  std::string measure;     ///< "blocks", ..., "color_part" or "black_part"
  double value = 0.0;      ///< what was measured
  double threshold = 0.0;  ///< what it passed
};

/// What one look at a frame found. All but `change` are for those who choose thresholds.
struct SceneLook {
  std::optional<SceneChange> change;
  bool black = false;              ///< the frame is black, and the scene was not
  double against_reference = 0.0;  ///< the measure between the frame and the long-term reference, 0 to 1
  double against_before = 0.0;     ///< the same, and the frame `frames_back` before
  double correlation = 1.0;        ///< of grey levels with those of the reference, -1 to 1
  double color = 0.0;              ///< mean of largest less smallest channel, grey levels
  double reference_color = 0.0;    ///< the same of the reference
  double black_part = 0.0;         ///< part of the samples that are black, 0 to 1
};

/// Watches a scene as a whole (Nashenda 2011, 3.1.1), on a grid of samples.
class SceneGuard {
 public:
  /// Throws `ConfigError` for options out of their ranges.
  explicit SceneGuard(const GuardOptions& options = {});
  ~SceneGuard();
  SceneGuard(SceneGuard&&) noexcept;
  SceneGuard& operator=(SceneGuard&&) noexcept;

  /// Looks at the next frame: HxW or HxWx3 (BGR) uint8, all of one size; `time_s` increases. After a change that is
  /// not `black` the frame is the new reference, so that each change is told once; `black` is told in the first
  /// black frame. Throws `InputError` and then keeps its state.
  SceneLook look(const cv::Mat& frame, double time_s);

  /// Number of pixels that are samples; 0 before the first frame.
  int sample_count() const;

  /// Forgets everything: the next frame is a first frame.
  void reset();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// One readable sentence: the kind, the measure, its value and threshold, and what is done.
std::string describe(const SceneChange& change, SceneAction action);

}  // namespace survtrack
