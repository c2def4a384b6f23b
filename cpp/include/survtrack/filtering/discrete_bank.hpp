// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "survtrack/filtering/filter_bank.hpp"
#include "survtrack/filtering/kalman_bank.hpp"

namespace survtrack {

struct DiscreteStep;

/// Kalman filters whose covariances are given for a step: see KalmanDiscreteOptions. One whose numbers grow beyond 1e100,
/// as they can with `as_published`, starts anew.
class DiscreteBank final : public FilterBank {
 public:
  explicit DiscreteBank(const KalmanDiscreteOptions& options);

  int size() const override { return bank_.size(); }
  int add(const Point& position, double object_size_px) override;
  void restart(int slot, const Point& position, double object_size_px) override;
  void remove(int slot) override { bank_.remove(slot); }
  void clear() override { bank_.clear(); }
  void predict(double dt) override;
  using FilterBank::correct;
  void correct(int slot, const Point& measured, const Symmetric2& extra_px2) override;
  void set_object_size(int, double) override {}
  void check_frame_size(int width, int height) const override;
  void set_frame_size(int width, int height) override;
  Estimate estimate(int slot) const override;
  using FilterBank::innovation_covariance_px2;
  Symmetric2 innovation_covariance_px2(int slot, const Symmetric2& extra_px2) const override;
  Eigen::VectorXd state(int slot) const override { return bank_.x(slot); }
  Eigen::MatrixXd state_covariance(int slot) const override { return bank_.P(slot); }

 private:
  using Bank = KalmanBank<4, 2>;

  void start_at(int slot, const Point& position);
  void move(int slot, const DiscreteStep& step);
  bool in_range(int slot) const;
  Eigen::Matrix2d R(const Symmetric2& extra_px2) const;

  KalmanDiscreteOptions options_;
  Bank::MeasurementMatrix H_ = Bank::MeasurementMatrix::Identity();
  Bank bank_;
  Point frame_center_;
};

}  // namespace survtrack
