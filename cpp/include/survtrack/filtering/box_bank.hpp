// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <memory>
#include <vector>

#include "survtrack/filtering/filter_bank.hpp"

namespace survtrack {

/// Kalman filters over boxes: see KalmanBoxOptions. Width and height are a second point that moves at constant velocity:
/// noises of the axes are independent, so one filter of eight states and two of four are the same.
/// The raw state is (x, y, w, h, vx, vy, vw, vh).
class BoxBank final : public FilterBank {
 public:
  explicit BoxBank(const KalmanBoxOptions& options);

  int size() const override { return center_->size(); }
  /// The box is a square until its size is given.
  int add(const Point& position, double object_size_px) override;
  void restart(int slot, const Point& position, double object_size_px) override;
  void remove(int slot) override;
  void clear() override;
  void predict(double dt) override;
  using FilterBank::correct;
  void correct(int slot, const Point& measured, const Symmetric2& extra_px2) override {
    center_->correct(slot, measured, extra_px2);
  }
  void set_object_size(int slot, double object_size_px) override;
  void start_size(int slot, const BoxSize& measured) override;
  void correct_size(int slot, const BoxSize& measured, const BoxSize& extra_px2) override;
  /// Each side between half and twice the one last measured: one that goes on shrinking unseen would be nothing in the end.
  std::optional<BoxSize> box_size(int slot) const override;
  Estimate estimate(int slot) const override { return center_->estimate(slot); }
  using FilterBank::innovation_covariance_px2;
  Symmetric2 innovation_covariance_px2(int slot, const Symmetric2& extra_px2) const override {
    return center_->innovation_covariance_px2(slot, extra_px2);
  }
  Eigen::VectorXd state(int slot) const override;
  Eigen::MatrixXd state_covariance(int slot) const override;

 private:
  std::unique_ptr<FilterBank> center_;
  std::unique_ptr<FilterBank> size_;
  std::vector<BoxSize> measured_;  ///< last, a slot
};

}  // namespace survtrack
