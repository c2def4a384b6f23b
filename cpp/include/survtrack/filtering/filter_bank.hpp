// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <string>

#include "survtrack/core/geometry.hpp"
#include "survtrack/filtering/options.hpp"
#include "survtrack/filtering/path_state.hpp"

namespace survtrack {

/// Where a filter believes its object to be. Times in the config's time unit. All covariances are zero for filters without
/// one (`mean_velocity`); of `kalman_path` they are turned from the path's directions at the estimated place, as the
/// velocity is.
struct Estimate {
  Point position;                ///< px
  Point velocity;                ///< px per time unit
  Symmetric2 covariance_px2;     ///< of the position
  Symmetric2 velocity_covariance;  ///< px^2 per time unit^2
  Matrix2 cross_covariance;      ///< of position (rows) and velocity (columns), px^2 per time unit
  /// Density q of the process noise in the velocity, px^2 per time unit^3: over a time t it adds t q to the velocity's
  /// covariance and, by way of that, t^3 / 3 q to the position's. Of `kalman_discrete` and `kalman_path` the share of a
  /// time unit in their noise of a step. Zero for `kalman_ca` with continuous noise, which is in the acceleration.
  Symmetric2 velocity_noise;
};

struct BoxSize {
  double width_px = 0.0;
  double height_px = 0.0;
};

/// The filters of all tracks, one slot a track in order of birth. All slots are predicted together to the
/// time of the coming frame; then those with a measurement are corrected, the others missed.
class FilterBank {
 public:
  virtual ~FilterBank() = default;

  virtual int size() const = 0;
  /// Starts a filter at a measured position; returns its slot, size() - 1. `object_size_px` (root of the box
  /// area) is the unit of noises that are relative to the object's size.
  virtual int add(const Point& position, double object_size_px) = 0;
  /// Starts a filter anew, as `add` does, in its slot.
  virtual void restart(int slot, const Point& position, double object_size_px) = 0;
  /// Ends a filter; later slots move down by one.
  virtual void remove(int slot) = 0;
  virtual void clear() = 0;

  /// Moves all filters on by `dt` time units (above 0).
  virtual void predict(double dt) = 0;
  /// Corrects one filter by its measurement, whose variances are larger than usual by `extra_px2`.
  virtual void correct(int slot, const Point& measured, const Symmetric2& extra_px2) = 0;
  void correct(int slot, const Point& measured) { correct(slot, measured, Symmetric2{}); }
  virtual void set_object_size(int slot, double object_size_px) = 0;

  /// Filters over boxes also take the box's size: after `add` and `restart`, and, with variances that are larger than
  /// usual by `extra_px2`, after `correct`. The others leave it aside.
  virtual void start_size(int /*slot*/, const BoxSize& /*measured*/) {}
  virtual void correct_size(int /*slot*/, const BoxSize& /*measured*/, const BoxSize& /*extra_px2*/) {}
  /// The size that is believed now; nothing of filters over positions.
  virtual std::optional<BoxSize> box_size(int /*slot*/) const { return std::nullopt; }

  /// Throws `InputError` for frames that this filter cannot work on; sides of 0 px: unknown.
  virtual void check_frame_size(int /*width*/, int /*height*/) const {}
  virtual void set_frame_size(int /*width*/, int /*height*/) {}
  /// Whether something at this position can be an object at all.
  virtual bool accepts(const Point& /*measured*/) const { return true; }

  /// What is believed now: after `correct` with the measurement, otherwise without it.
  virtual Estimate estimate(int slot) const = 0;
  /// Where, after `predict`, the measurement is expected. The same as the estimate, but for filters that leave
  /// an unmatched track where it was.
  virtual Point predicted_position(int slot) const { return estimate(slot).position; }
  /// How the measured position differs from the one that is expected, in px.
  virtual Point innovation(int slot, const Point& measured) const { return measured - predicted_position(slot); }
  /// Covariance S of the innovation: of the measured minus the predicted position, in px^2.
  virtual Symmetric2 innovation_covariance_px2(int slot, const Symmetric2& extra_px2) const = 0;
  Symmetric2 innovation_covariance_px2(int slot) const { return innovation_covariance_px2(slot, Symmetric2{}); }

  /// The raw state, and its covariance row by row (empty for filters without one).
  virtual Eigen::VectorXd state(int slot) const = 0;
  virtual Eigen::MatrixXd state_covariance(int slot) const = 0;
  /// What is believed by the path that the object is on; nothing of filters without one.
  virtual std::optional<PathState> path_state(int /*slot*/) const { return std::nullopt; }
};

/// Throws `ConfigError` unless all bounds hold and the covariances are some; `path` is that of the options.
void check_filter(const FilterOptions& options, const std::string& path);

/// Throws `ConfigError`, also for filters along a path: see `PathBank`.
std::unique_ptr<FilterBank> make_filter_bank(const FilterOptions& options);

}  // namespace survtrack
