// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <Eigen/Core>
#include <vector>

#include "survtrack/filtering/covariance.hpp"

namespace survtrack {

struct KalmanLanes;
struct LaneFaults;

/// Many Kalman filters with one model between them, predicted and updated all together: `KalmanBank` in Python. The
/// numbers lie by component, filters side by side, so that each instruction works on several filters. The same
/// equations as `KalmanFilter`, up to rounding; the same bytes at every SIMD level.
class KalmanArray {
 public:
  struct Model {
    Eigen::MatrixXd F;             ///< n x n transition
    Eigen::MatrixXd H;             ///< m x n measured of state
    Eigen::MatrixXd Q;             ///< n x n, of a step
    Eigen::MatrixXd R;             ///< m x m
    Eigen::MatrixXd B = {};        ///< n x k, effect of the control input; empty: there is none
    Eigen::VectorXd periods = {};  ///< m, the lengths after which measurements wrap, 0: never; empty: none do
  };

  /// Has no filters at first. Throws `InputError` naming what is wrong in the model.
  explicit KalmanArray(Model model, Covariances covariances = Covariances::checked);

  int size() const { return size_; }
  /// Adds a filter; its slot is size() - 1. Throws `InputError`.
  int add(const Eigen::VectorXd& x, const Eigen::MatrixXd& P);
  /// Removes a filter; later slots move down by one. Throws `InputError` where there is none.
  void remove(int slot);

  /// x = F x + B u, P = F P F' + Q. `u`: nothing, one column for all, or a column a filter.
  void predict(const Eigen::MatrixXd& u = {});
  /// Corrects by a column a filter; one of NaN is missing, its filter stays as predicted. Joseph form. Throws
  /// `InputError` naming the slot where a column is neither finite nor missing, or S is singular; nothing changes then.
  void update(const Eigen::MatrixXd& z);

  Eigen::MatrixXd states() const;  ///< n x size, a column a filter
  Eigen::MatrixXd covariance(int slot) const;  ///< n x n; of a slot that is there
  Eigen::MatrixXd innovations() const;  ///< m x size; of the last update, NaN where z was missing
  Eigen::MatrixXd innovation_covariance(int slot) const;  ///< m x m of the last update; NaN where z was missing
  Eigen::VectorXd nis() const;              ///< y' S^-1 y of the last update; NaN where z was missing
  Eigen::VectorXd log_likelihoods() const;  ///< of the last innovations, likewise
  /// (z - H x)' S^-1 (z - H x) of each filter (row) for each column of z, which must be finite.
  Eigen::MatrixXd squared_mahalanobis(const Eigen::MatrixXd& z) const;

  const Model& model() const { return model_; }
  Covariances covariances() const { return covariances_; }
  void set_F(const Eigen::MatrixXd& F);
  void set_H(const Eigen::MatrixXd& H);
  void set_Q(const Eigen::MatrixXd& Q);
  void set_R(const Eigen::MatrixXd& R);

  /// The plain arrays, for those who copy them all at once: component c of filter i is at [c * stride() + i], covariances
  /// by rows of their upper triangle.
  const double* state_data() const { return x_.data(); }
  const double* covariance_data() const { return P_.data(); }
  Eigen::Index stride() const { return stride_; }

 private:
  Eigen::Index n() const { return model_.F.rows(); }
  Eigen::Index m() const { return model_.H.rows(); }
  void reserve(int filters);
  void check_slot(int slot) const;
  Eigen::Index nis_row() const { return m() + m() * (m() + 1) / 2; }
  Eigen::MatrixXd rows_of(const std::vector<double>& values, Eigen::Index first, Eigen::Index rows) const;
  Eigen::MatrixXd symmetric_of(const std::vector<double>& values, Eigen::Index first, Eigen::Index order, int slot) const;
  Eigen::MatrixXd expected_covariance(int slot) const;  ///< of its innovation
  KalmanLanes lanes();
  LaneFaults first_faults() const;

  Model model_;
  Covariances covariances_;
  int size_ = 0;
  Eigen::Index stride_ = 0;  ///< filters that there is room for, a multiple of the lanes of a pass
  std::vector<double> x_, P_;  ///< n and n (n + 1) / 2 rows of stride_
  std::vector<double> last_;   ///< of the last update: m rows of y, m (m + 1) / 2 of S, one of NIS
  std::vector<double> next_x_, next_P_, next_last_;  ///< written first, so that nothing changes where something is wrong
  std::vector<double> z_, faults_;
};

}  // namespace survtrack
