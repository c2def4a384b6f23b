// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "survtrack/core/detection.hpp"
#include "survtrack/core/expectation.hpp"
#include "survtrack/filtering/filter_bank.hpp"
#include "survtrack/tracking/measurement.hpp"
#include "survtrack/tracking/paths.hpp"
#include "survtrack/tracking/reentry.hpp"
#include "survtrack/tracking/scale_learner.hpp"

namespace survtrack {

/// All open tracks in order of birth, with their filters: the only maker of tracks and of ids.
/// A lifecycle decides; the table carries out and keeps the books.
class TrackTable {
 public:
  TrackTable(const FilterOptions& filter, const MeasurementOptions& measurement, const ReentryOptions& reentry,
             double time_unit_s);

  int size() const { return static_cast<int>(rows_.size()); }
  const OpenTrack& row(int i) const { return rows_[static_cast<std::size_t>(i)]; }
  const ScaleLearner& scale() const { return scale_; }
  void restore(const ScaleLearner::State& scale) { scale_.restore(scale); }
  /// From here on each row has a colour histogram, which moves towards its detections' by `rate`.
  void keep_histograms(double rate) { histogram_rate_ = rate; }
  const ColorHistogram& histogram(int i) const { return histograms_[static_cast<std::size_t>(i)]; }
  double time_unit_s() const { return time_unit_s_; }

  /// Where row `i` is expected to be measured, after `predict`.
  Point predicted_position(int i) const { return filters_->predicted_position(i); }
  Box predicted_box(int i) const { return box_at(measurement_, row(i), predicted_position(i)); }
  /// For how long row `i` was not found, up to the frame before the one that was predicted.
  double lost_s(int i) const { return row(i).track.lost_frames == 0 ? 0.0 : time_s_ - dt_s_ - row(i).track.end_time_s; }
  /// Covariance of that position, without the measurement's.
  Symmetric2 predicted_covariance_px2(int i) const { return filters_->estimate(i).covariance_px2; }
  Symmetric2 innovation_covariance_px2(int i, const Symmetric2& extra_px2 = {}) const {
    return filters_->innovation_covariance_px2(i, extra_px2);
  }
  Observation observe(int i, const Detection& detection) const;
  /// How a position measured of row `i` differs from the predicted one, px.
  Point innovation(int i, const Point& measured) const { return filters_->innovation(i, measured); }
  /// Whether the filters can take a detection for an object at all.
  bool accepts(const Detection& detection) const { return filters_->accepts(measured(detection)); }
  /// By the path that row `i` is on; nothing with filters that have none.
  std::optional<PathState> path_state(int i) const { return filters_->path_state(i); }
  /// What a detection that is not shared measures, whichever the row.
  Point measured(const Detection& detection) const { return measured_position(measurement_, detection); }
  /// A row's velocity, to be compared with those that measurements would imply (Narayana 2007, 4.2).
  struct Motion {
    bool known = false;
    Point from;               ///< last measured position, px
    Point velocity;           ///< px per time unit
    double per_elapsed = 0.0;  ///< 1 / time units since then

    /// Length of the difference when the row is measured at `position` now, px per time unit; nothing for a track
    /// that has no velocity yet.
    std::optional<double> difference(const Point& position) const {
      if (!known) return std::nullopt;
      const Point d = per_elapsed * (position - from) - velocity;
      return std::sqrt(d.x * d.x + d.y * d.y);
    }
  };
  Motion motion(int i) const;

  /// The paths of filters along paths; see PathBank. Others leave them aside.
  void set_paths(const Paths& paths);
  /// Throws `InputError` for frames that the filters cannot work on; sides of 0 px: unknown.
  void check_frame_size(int width, int height) const { filters_->check_frame_size(width, height); }
  void set_frame_size(int width, int height) { filters_->set_frame_size(width, height); }

  /// Moves all filters on to the time of the coming frame.
  void predict(double time_s);

  /// Corrects row `i` by its detection.
  void match(int i, int detection, const Detections& detections);
  void miss(int i);
  /// Row `i` is somewhere in a detection that it shares with others of its group: its prediction stays where it is, or is
  /// moved into that box if it lies outside. Of its size, colour and displacement this says nothing.
  void share(int i, int detection, const Detections& detections);
  /// The id of the oldest track of its group; 0: none.
  void set_group(int i, std::int64_t group) { rows_[static_cast<std::size_t>(i)].track.group = group; }
  /// Forgets how row `i`, matched now, moved before: its filter starts anew where it is.
  void restart(int i);
  /// A new tentative track at the end of the table.
  int start(int detection, const Detections& detections);
  /// Gives a tentative track its number: from here on it is believed.
  void believe(int i);
  /// After all that are new in this frame have their numbers: those that continue a track that ended get its number
  /// instead, and the others' close up, so that there are no gaps.
  void recognize();
  void set_status(int i, TrackStatus status) { rows_[static_cast<std::size_t>(i)].track.status = status; }
  void set_reported(int i, bool reported) { rows_[static_cast<std::size_t>(i)].track.reported = reported; }
  /// Takes closed tracks out; order stays. Those that were believed may come back.
  void remove_closed();
  void clear();

 private:
  /// Marks which believed tracks stand so near to another that edges may be hidden.
  void find_near();
  void refresh(int i);
  /// Takes a row's size over from a filter that has one.
  void follow_size(int i);

  MeasurementOptions measurement_;
  std::unique_ptr<FilterBank> filters_;
  double time_unit_s_;
  std::vector<OpenTrack> rows_;
  std::optional<double> histogram_rate_;
  std::vector<ColorHistogram> histograms_;  ///< a row; none without a rate
  ScaleLearner scale_;
  std::optional<ReentryMemory> memory_;
  std::int64_t last_id_ = 0;
  std::int64_t last_known_id_ = 0;  ///< when the last frame was over
  double time_s_ = 0.0;
  double dt_s_ = 0.0;
  bool started_ = false;
};

}  // namespace survtrack
