// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <Eigen/Core>

#include "survtrack/filtering/nonlinear_model.hpp"

namespace survtrack {

/// How the 2n + 1 sigma points of an n-dimensional Gaussian are spread and weighted: Wan and van der Merwe 2000.
/// With lambda = alpha^2 (n + kappa) - n they are the mean, and the mean plus and minus each column of the root of
/// (n + lambda) P.
struct SigmaPoints {
  double alpha = 0.1;  ///< spread; above 0, at most 1
  double beta = 2.0;   ///< what is known of the distribution; 2 is best for a Gaussian; at least 0
  double kappa = 0.0;  ///< n + kappa must be above 0
};

/// The unscented Kalman filter: sigma points go through f and h, no derivatives are needed. The points are drawn anew
/// for the update, so that Q counts in it.
class UnscentedKalmanFilter {
 public:
  /// Starts at state x with covariance P. Throws `InputError` naming what is wrong; a callable's exceptions pass
  /// through, and leave the filter as it was.
  UnscentedKalmanFilter(NonlinearModel model, const Eigen::VectorXd& x, const Eigen::MatrixXd& P,
                        const SigmaPoints& points = {});

  void predict(const Eigen::VectorXd& u = {});
  void update(const Eigen::VectorXd& z);  ///< throws as `KalmanFilter::update` does

  const Correction<>& last() const { return last_; }  ///< of the last update; zero before the first
  double squared_mahalanobis(const Eigen::VectorXd& z) const;  ///< y' S^-1 y of a measurement, as things stand now

  const Eigen::VectorXd& x() const { return x_; }
  const Eigen::MatrixXd& P() const { return P_; }
  const NonlinearModel& model() const { return model_; }
  const SigmaPoints& points() const { return points_; }
  void set_x(const Eigen::VectorXd& x);
  void set_P(const Eigen::MatrixXd& P);
  void set_Q(const Eigen::MatrixXd& Q);
  void set_R(const Eigen::MatrixXd& R);

  /// The sigma points of the present state, a column each, the mean first.
  Eigen::MatrixXd sigma_points() const;

 private:
  struct Expected {
    Eigen::VectorXd z;   ///< mean of the measurement
    Eigen::MatrixXd S;   ///< its covariance with R
    Eigen::MatrixXd xz;  ///< covariance of state and measurement
  };
  Expected expected_measurement() const;
  double outer_weight() const;    ///< of each point but the mean, for means and covariances
  double central_weight() const;  ///< of the mean, for covariances

  NonlinearModel model_;
  SigmaPoints points_;
  Eigen::VectorXd x_;
  Eigen::MatrixXd P_;
  Correction<> last_;
};

}  // namespace survtrack
