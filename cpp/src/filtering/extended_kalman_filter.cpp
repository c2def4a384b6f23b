// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "survtrack/filtering/extended_kalman_filter.hpp"

#include <utility>

namespace survtrack {

ExtendedKalmanFilter::ExtendedKalmanFilter(NonlinearModel model, const Eigen::VectorXd& x, const Eigen::MatrixXd& P,
                                           TransitionJacobian F, MeasureJacobian H)
    : model_(std::move(model)), F_(std::move(F)), H_(std::move(H)), x_(x), P_(P) {
  model_.check(x, P);
  const Eigen::Index n = x.size(), m = model_.R.rows();
  last_ = {Eigen::VectorXd::Zero(m), Eigen::MatrixXd::Zero(m, m), Eigen::MatrixXd::Zero(n, m), 0.0};
}

void ExtendedKalmanFilter::predict(const Eigen::VectorXd& u) {
  const Eigen::Index n = x_.size();
  // The derivative at the estimate before, not at the predicted one.
  const Eigen::MatrixXd F =
      F_ ? F_(x_, u) : numeric_jacobian([&](const Eigen::VectorXd& x) { return model_.moved(x, u); }, x_);
  check_matrix("F", F, n, n);
  const Eigen::VectorXd x = model_.moved(x_, u);
  const Eigen::MatrixXd P = F * P_ * F.transpose() + model_.Q;
  check_still_finite("predict", x, P);
  x_ = x;
  P_ = 0.5 * (P + P.transpose());
}

Eigen::MatrixXd ExtendedKalmanFilter::measure_jacobian() const {
  Eigen::MatrixXd H =
      H_ ? H_(x_) : numeric_jacobian([&](const Eigen::VectorXd& x) { return model_.measured(x); }, x_, model_.residual);
  check_matrix("H", H, model_.R.rows(), x_.size());
  return H;
}

void ExtendedKalmanFilter::update(const Eigen::VectorXd& z) {
  const Eigen::VectorXd y = model_.difference(z, model_.measured(x_));
  const Eigen::MatrixXd H = measure_jacobian();
  last_ = correct_linear<Eigen::Dynamic, Eigen::Dynamic>(x_, P_, y, H, model_.R, Covariances::checked);
}

double ExtendedKalmanFilter::squared_mahalanobis(const Eigen::VectorXd& z) const {
  const Eigen::VectorXd y = model_.difference(z, model_.measured(x_));
  const Eigen::MatrixXd H = measure_jacobian();
  return Ldl<Eigen::Dynamic>(H * P_ * H.transpose() + model_.R, Covariances::checked).squared_distance(y);
}

void ExtendedKalmanFilter::set_x(const Eigen::VectorXd& x) {
  check_matrix("x", x, x_.size(), 1);
  x_ = x;
}

void ExtendedKalmanFilter::set_P(const Eigen::MatrixXd& P) {
  check_covariance("P", P, x_.size());
  P_ = 0.5 * (P + P.transpose());
}

void ExtendedKalmanFilter::set_Q(const Eigen::MatrixXd& Q) {
  check_covariance("Q", Q, x_.size());
  model_.Q = Q;
}

void ExtendedKalmanFilter::set_R(const Eigen::MatrixXd& R) {
  check_covariance("R", R, model_.R.rows());
  model_.R = R;
}

}  // namespace survtrack
