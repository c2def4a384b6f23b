// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "survtrack/core/detection.hpp"
#include "survtrack/core/expectation.hpp"
#include "survtrack/filtering/filter_bank.hpp"
#include "survtrack/tracking/measurement.hpp"
#include "survtrack/tracking/scale_learner.hpp"

namespace survtrack {

/// All open tracks in order of birth, with their filters: the only maker of tracks and of ids.
/// A lifecycle decides; the table carries out and keeps the books.
class TrackTable {
 public:
  TrackTable(const FilterOptions& filter, const MeasurementOptions& measurement, double time_unit_s);

  int size() const { return static_cast<int>(rows_.size()); }
  const OpenTrack& row(int i) const { return rows_[static_cast<std::size_t>(i)]; }
  const SceneScale& scale() const { return scale_.scale(); }

  /// Where row `i` is expected to be measured, after `predict`.
  Point predicted_position(int i) const { return filters_->predicted_position(i); }
  Box predicted_box(int i) const { return box_at(measurement_, row(i), predicted_position(i)); }
  Symmetric2 innovation_covariance_px2(int i, const Symmetric2& extra_px2 = {}) const {
    return filters_->innovation_covariance_px2(i, extra_px2);
  }
  Observation observe(int i, const Detection& detection) const;

  /// Moves all filters on to the time of the coming frame.
  void predict(double time_s);

  /// Corrects row `i` by its detection.
  void match(int i, int detection, const Detections& detections);
  void miss(int i);
  /// A new tentative track at the end of the table.
  int start(int detection, const Detections& detections);
  /// Gives a tentative track its number: from here on it is believed.
  void believe(int i);
  void set_status(int i, TrackStatus status) { rows_[static_cast<std::size_t>(i)].track.status = status; }
  void set_reported(int i, bool reported) { rows_[static_cast<std::size_t>(i)].track.reported = reported; }
  /// Takes closed tracks out; order stays.
  void remove_closed();
  void clear();

 private:
  /// Marks which believed tracks stand so near to another that edges may be hidden.
  void find_groups();
  void refresh(int i);

  MeasurementOptions measurement_;
  std::unique_ptr<FilterBank> filters_;
  double time_unit_s_;
  std::vector<OpenTrack> rows_;
  ScaleLearner scale_;
  std::int64_t last_id_ = 0;
  double time_s_ = 0.0;
  double dt_s_ = 0.0;
  bool started_ = false;
};

}  // namespace survtrack
