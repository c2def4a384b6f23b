// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <Eigen/Core>
#include <functional>

#include "survtrack/filtering/nonlinear_model.hpp"

namespace survtrack {

/// The extended Kalman filter: a non-linear model, linearised where the estimate is. Equations: Bar-Shalom, Li and
/// Kirubarajan 2001, 10.3.
class ExtendedKalmanFilter {
 public:
  /// Derivatives of f by x (n x n) and of h by x (m x n).
  using TransitionJacobian = std::function<Eigen::MatrixXd(const Eigen::VectorXd& x, const Eigen::VectorXd& u)>;
  using MeasureJacobian = std::function<Eigen::MatrixXd(const Eigen::VectorXd& x)>;

  /// Starts at state x with covariance P. A Jacobian that is empty is taken by central differences. Throws `InputError`
  /// naming what is wrong; a callable's exceptions pass through, and leave the filter as it was.
  ExtendedKalmanFilter(NonlinearModel model, const Eigen::VectorXd& x, const Eigen::MatrixXd& P,
                       TransitionJacobian F = {}, MeasureJacobian H = {});

  /// x = f(x, u), P = F P F' + Q with F the derivative at the estimate before.
  void predict(const Eigen::VectorXd& u = {});
  /// Corrects with H, the derivative of h at the predicted state. Throws as `KalmanFilter::update` does.
  void update(const Eigen::VectorXd& z);

  const Correction<>& last() const { return last_; }  ///< of the last update; zero before the first
  double squared_mahalanobis(const Eigen::VectorXd& z) const;  ///< y' S^-1 y of a measurement, as things stand now

  const Eigen::VectorXd& x() const { return x_; }
  const Eigen::MatrixXd& P() const { return P_; }
  const NonlinearModel& model() const { return model_; }
  void set_x(const Eigen::VectorXd& x);
  void set_P(const Eigen::MatrixXd& P);
  void set_Q(const Eigen::MatrixXd& Q);
  void set_R(const Eigen::MatrixXd& R);

 private:
  Eigen::MatrixXd measure_jacobian() const;

  NonlinearModel model_;
  TransitionJacobian F_;
  MeasureJacobian H_;
  Eigen::VectorXd x_;
  Eigen::MatrixXd P_;
  Correction<> last_;
};

}  // namespace survtrack
