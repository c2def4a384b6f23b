// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <vector>

#include "survtrack/filtering/filter_bank.hpp"
#include "survtrack/filtering/kalman_bank.hpp"
#include "survtrack/tracking/paths.hpp"

namespace survtrack {

/// Kalman filters along paths: see KalmanPathOptions. A filter stays on the path that is nearest when it starts. What is
/// farther off every path than its max_distance_px is no object. On a closed path S wraps: the innovation is the shorter
/// way round. Estimates are turned into px by the path's tangent and normal; the raw state is (S, T, vS, vT).
class PathBank final : public FilterBank {
 public:
  explicit PathBank(const KalmanPathOptions& options);

  /// The paths from now on. Throws `InputError` when there are none, or while filters run.
  void set_paths(const Paths& paths);
  const Paths& paths() const { return paths_; }

  int size() const override { return bank_.size(); }
  /// Throws `InputError` for a position that is not accepted.
  int add(const Point& position, double object_size_px) override;
  void restart(int slot, const Point& position, double object_size_px) override;
  void remove(int slot) override;
  void clear() override;
  void predict(double dt) override;
  using FilterBank::correct;
  void correct(int slot, const Point& measured, const Symmetric2& extra_px2) override;
  void set_object_size(int, double) override {}
  /// Also throws while there are no paths.
  void check_frame_size(int width, int height) const override;
  bool accepts(const Point& measured) const override { return nearest_path(measured) >= 0; }
  Estimate estimate(int slot) const override;
  Point predicted_position(int slot) const override { return path_of(slot).to_image(place(slot)); }
  Point innovation(int slot, const Point& measured) const override;
  using FilterBank::innovation_covariance_px2;
  Symmetric2 innovation_covariance_px2(int slot, const Symmetric2& extra_px2) const override;
  Eigen::VectorXd state(int slot) const override { return bank_.x(slot); }
  Eigen::MatrixXd state_covariance(int slot) const override { return bank_.P(slot); }
  std::optional<PathState> path_state(int slot) const override;

 private:
  using Bank = KalmanBank<4, 2>;
  struct Slot {
    std::size_t path = 0;
    PathPosition before;  ///< estimate before the last prediction
  };

  int nearest_path(const Point& position) const;
  void start(int slot, const Point& position);
  void settle(int slot);
  const Slot& at(int slot) const { return slots_[static_cast<std::size_t>(slot)]; }
  const Path& path_of(int slot) const { return paths_.items()[at(slot).path].path; }
  PathPosition place(int slot) const { return {bank_.x(slot)(0), bank_.x(slot)(1)}; }
  /// From the estimated to the measured place, along and across.
  Eigen::Vector2d difference(int slot, const Point& measured) const;
  /// How x and y change with S and T, at the estimated place.
  Eigen::Matrix2d directions(int slot) const;
  Eigen::Matrix2d R(int slot, const Symmetric2& extra_px2) const;

  KalmanPathOptions options_;
  Bank::MeasurementMatrix H_ = Bank::MeasurementMatrix::Identity();
  Bank bank_;
  std::vector<Slot> slots_;
  Paths paths_;
  std::vector<Path> endless_;  ///< the same without a max_distance_px: an object may be led farther off than it began
};

}  // namespace survtrack
