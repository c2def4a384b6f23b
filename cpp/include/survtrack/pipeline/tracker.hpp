// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "survtrack/core/detection.hpp"
#include "survtrack/core/expectation.hpp"
#include "survtrack/pipeline/config.hpp"
#include "survtrack/tracking/lifecycle.hpp"
#include "survtrack/tracking/matcher.hpp"
#include "survtrack/tracking/track_table.hpp"
#include "survtrack/tracking/tracking_result.hpp"

namespace survtrack {

/// The second half: detections in, tracks out. Usable alone, on the boxes of any detector. Options used:
/// `time_unit_s`, `filter`, `measurement`, `cost`, `assignment`, `lifecycle`, `outputs`.
class Tracker {
 public:
  /// Throws `ConfigError`.
  explicit Tracker(const Config& config = {});

  /// `predict` and `update` in one, at `detections.time_s`. Throws `InputError` (times that do not increase,
  /// boxes that are not finite or not of positive size) and then keeps its state.
  TrackingResult process(const Detections& detections);

  /// Moves all tracks on to the coming frame's time and says what is expected there.
  const Expectation& predict(double time_s);

  /// Associates, filters, and decides births and ends; reuses the memory of `result`.
  /// Comes once after `predict` for the same time. Throws `InputError` and then keeps its state.
  void update(const Detections& detections, TrackingResult& result);

  /// Forgets all tracks; ids start at 1 again.
  void reset();

 private:
  void check(const Detections& detections) const;
  void report(const Detections& detections, TrackingResult& result);

  OutputOptions outputs_;
  TrackTable table_;
  Matcher matcher_;
  std::unique_ptr<Lifecycle> lifecycle_;
  Expectation expectation_;
  std::vector<char> believed_before_;  ///< a row, before this frame's decisions
  std::vector<char> was_lost_;         ///< a row, in the frame before
  std::optional<double> last_time_s_;
  bool predicted_ = false;  ///< to `last_time_s_`, and not yet updated
};

}  // namespace survtrack
