// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <deque>
#include <vector>

#include "survtrack/filtering/filter_bank.hpp"

namespace survtrack {

/// Position, velocity and prediction of Narayana 2007, 3.4: the velocity is the mean over the last steps
/// between matches; a track that is not matched stays frozen, or moves on with its velocity.
class MeanVelocityBank final : public FilterBank {
 public:
  explicit MeanVelocityBank(const MeanVelocityOptions& options) : options_(options) {}

  int size() const override { return static_cast<int>(slots_.size()); }
  int add(const Point& position, double object_size_px) override;
  void restart(int slot, const Point& position, double object_size_px) override;
  void remove(int slot) override { slots_.erase(slots_.begin() + slot); }
  void clear() override { slots_.clear(); }
  void predict(double dt) override;
  using FilterBank::correct;
  void correct(int slot, const Point& measured, const Symmetric2& extra_px2) override;
  void set_object_size(int, double) override {}
  Estimate estimate(int slot) const override;
  Point predicted_position(int slot) const override { return at(slot).predicted; }
  using FilterBank::innovation_covariance_px2;
  Symmetric2 innovation_covariance_px2(int, const Symmetric2&) const override { return {}; }
  Eigen::VectorXd state(int slot) const override;
  Eigen::MatrixXd state_covariance(int) const override { return {}; }

 private:
  struct Step {
    Point displacement;  ///< px
    double dt;           ///< time units
  };
  struct Slot {
    Point measured;       ///< last measured position
    Point predicted;      ///< where the next one is expected
    Point velocity;       ///< px per time unit
    double waited = 0.0;  ///< time units since `measured`
    std::deque<Step> steps;
  };
  static Slot started_at(const Point& position);
  const Slot& at(int slot) const { return slots_[static_cast<std::size_t>(slot)]; }

  MeanVelocityOptions options_;
  std::vector<Slot> slots_;
};

}  // namespace survtrack
