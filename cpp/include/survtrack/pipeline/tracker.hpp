// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "survtrack/core/detection.hpp"
#include "survtrack/core/expectation.hpp"
#include "survtrack/pipeline/config.hpp"
#include "survtrack/tracking/convergence.hpp"
#include "survtrack/tracking/groups.hpp"
#include "survtrack/tracking/lifecycle.hpp"
#include "survtrack/tracking/matcher.hpp"
#include "survtrack/tracking/region_planner.hpp"
#include "survtrack/tracking/track_table.hpp"
#include "survtrack/tracking/tracking_result.hpp"
#include "survtrack/tracking/vicinity_learner.hpp"

namespace survtrack {

/// The second half: detections in, tracks out. Usable alone, on the boxes of any detector. Options used:
/// `time_unit_s`, `filter`, `measurement`, `cost`, `appearance`, `assignment`, `lifecycle`, `groups`, `reentry`, `vicinity`,
/// `regions`, `outputs`.
class Tracker {
 public:
  /// Throws `ConfigError`.
  explicit Tracker(const Config& config = {});

  /// `predict` and `update` in one, at `detections.time_s`. Throws `InputError` (times that do not increase,
  /// boxes that are not finite or not of positive size) and then keeps its state.
  TrackingResult process(const Detections& detections);

  /// Moves all tracks on to the coming frame's time and says what is expected there. The frame's size, px, is needed
  /// for regions only; 0: that of the frames before.
  const Expectation& predict(double time_s, int frame_width = 0, int frame_height = 0);

  /// Associates, filters, and decides births and ends; reuses the memory of `result`.
  /// Comes once after `predict` for the same time. Throws `InputError` and then keeps its state.
  void update(const Detections& detections, TrackingResult& result);

  /// Throws `InputError` for a frame of a size that what is learned of the scene, or was loaded, cannot be of, and while
  /// there are no paths for filters that need some; sides of 0 px: unknown.
  void check_frame_size(int width, int height) const;

  /// Where newcomers are looked for, px, with `regions.acquisition = zones`; before the first frame. Throws `InputError`
  /// for zones without size, for none, and when the config has no use for them.
  void load_zones(const std::vector<Box>& zones);

  /// Forgets all tracks and all that was learned; ids start at 1 again.
  void reset();

  /// What was learned of the scene, as JSON: the law of sizes, the vicinity grids, the densities of beliefs.
  std::string learned_scene() const;
  /// Starts from what an earlier run learned. What this config does not use is left aside. Throws `InputError`,
  /// naming `source` and the entry, for a text that is no such scene, or whose grid or densities are made otherwise
  /// than this config says; and then keeps its state.
  void load_learned_scene(const std::string& json, const std::string& source = "scene");

  /// The paths that filter.model kalman_path follows objects along; other filters leave them aside. `reset` keeps them.
  /// Throws `InputError` when there are none, they are drawn on frames of another size, or frames were processed already.
  void load_paths(const Paths& paths);

 private:
  void check(const Detections& detections) const;
  void report(const Detections& detections, TrackingResult& result);

  OutputOptions outputs_;
  TrackTable table_;
  Matcher matcher_;
  std::unique_ptr<Lifecycle> lifecycle_;
  bool histograms_ = false;
  std::optional<VicinityLearner> vicinity_;
  ConvergenceWatch convergence_;
  std::optional<GroupWatch> groups_;
  std::optional<RegionPlanner> regions_;
  Expectation expectation_;
  std::vector<char> believed_before_;  ///< a row, before this frame's decisions
  std::vector<char> was_lost_;         ///< a row, in the frame before
  std::optional<cv::Size> frame_size_;  ///< of the frames seen, or of the learned scene; none while unknown
  bool scene_loaded_ = false;
  std::optional<double> last_time_s_;
  bool predicted_ = false;  ///< to `last_time_s_`, and not yet updated
};

}  // namespace survtrack
