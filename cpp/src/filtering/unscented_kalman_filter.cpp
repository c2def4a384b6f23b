// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "survtrack/filtering/unscented_kalman_filter.hpp"

#include <cmath>
#include <string>
#include <utility>

#include "survtrack/core/errors.hpp"

namespace survtrack {
namespace {

void check_points(const SigmaPoints& points, Eigen::Index n) {
  const auto refuse = [](const char* name, double value, const std::string& expected) {
    throw InputError(std::string(name) + ": is " + std::to_string(value) + "; expected " + expected);
  };
  // Below 1e-4 the weights are so large that rounding takes over.
  if (!(points.alpha >= 1e-4 && points.alpha <= 1.0)) refuse("alpha", points.alpha, "1e-4 to 1");
  if (!(points.beta >= 0.0 && points.beta <= 1e6)) refuse("beta", points.beta, "0 to 1e6");
  if (!(static_cast<double>(n) + points.kappa > 0.0 && points.kappa <= 1e6)) {
    refuse("kappa", points.kappa, "a number above -" + std::to_string(n) + " (minus the number of states), at most 1e6");
  }
}

}  // namespace

UnscentedKalmanFilter::UnscentedKalmanFilter(NonlinearModel model, const Eigen::VectorXd& x, const Eigen::MatrixXd& P,
                                             const SigmaPoints& points)
    : model_(std::move(model)), points_(points), x_(x), P_(P) {
  model_.check(x, P);
  check_points(points, x.size());
  const Eigen::Index n = x.size(), m = model_.R.rows();
  last_ = {Eigen::VectorXd::Zero(m), Eigen::MatrixXd::Zero(m, m), Eigen::MatrixXd::Zero(n, m), 0.0};
}

double UnscentedKalmanFilter::outer_weight() const {
  return 0.5 / (points_.alpha * points_.alpha * (static_cast<double>(x_.size()) + points_.kappa));
}

double UnscentedKalmanFilter::central_weight() const {
  const double of_mean = 1.0 - 2.0 * static_cast<double>(x_.size()) * outer_weight();
  return of_mean + 1.0 - points_.alpha * points_.alpha + points_.beta;
}

Eigen::MatrixXd UnscentedKalmanFilter::sigma_points() const {
  const Eigen::Index n = x_.size();
  const Eigen::MatrixXd root = std::sqrt(0.5 / outer_weight()) * covariance_root("P", P_);
  Eigen::MatrixXd points = x_.replicate(1, 2 * n + 1);
  points.middleCols(1, n) += root;
  points.rightCols(n) -= root;
  return points;
}

void UnscentedKalmanFilter::predict(const Eigen::VectorXd& u) {
  Eigen::MatrixXd points = sigma_points();
  for (Eigen::Index i = 0; i < points.cols(); ++i) points.col(i) = model_.moved(points.col(i), u);
  // The weights sum to 1, so the mean may be taken relative to the central point: with a small alpha the plain sum
  // would be the difference of huge numbers.
  const Eigen::VectorXd center = points.col(0);
  points.colwise() -= center;
  const double outer = outer_weight();
  const Eigen::VectorXd shift = outer * points.rowwise().sum();
  points.colwise() -= shift;
  const auto others = points.rightCols(points.cols() - 1);
  const Eigen::VectorXd x = center + shift;
  const Eigen::MatrixXd P =
      outer * (others * others.transpose()) + central_weight() * (shift * shift.transpose()) + model_.Q;
  check_still_finite("predict", x, P);
  x_ = x;
  P_ = 0.5 * (P + P.transpose());
}

UnscentedKalmanFilter::Expected UnscentedKalmanFilter::expected_measurement() const {
  const Eigen::MatrixXd points = sigma_points();
  const double outer = outer_weight();
  const Eigen::VectorXd center = model_.measured(points.col(0));
  Eigen::MatrixXd z(model_.R.rows(), points.cols());
  // Relative to the central one, as above; by the residual, so that measurements that wrap have their mean too.
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    z.col(i) = i == 0 ? Eigen::VectorXd(center - center) : model_.difference(model_.measured(points.col(i)), center);
  }
  const Eigen::VectorXd shift = outer * z.rowwise().sum();
  z.colwise() -= shift;
  const auto others = z.rightCols(z.cols() - 1);
  const Eigen::MatrixXd away = points.rightCols(points.cols() - 1).colwise() - x_;
  return {center + shift,
          outer * (others * others.transpose()) + central_weight() * (shift * shift.transpose()) + model_.R,
          outer * (away * others.transpose())};
}

void UnscentedKalmanFilter::update(const Eigen::VectorXd& z) {
  const Expected expected = expected_measurement();
  const Eigen::VectorXd y = model_.difference(z, expected.z);
  const Ldl<Eigen::Dynamic> factors(expected.S, Covariances::checked);
  Eigen::MatrixXd K = expected.xz;
  factors.solve_from_right(K);
  const Eigen::VectorXd x = x_ + K * y;
  const Eigen::MatrixXd P = P_ - K * expected.S * K.transpose();
  check_still_finite("update", x, P);
  x_ = x;
  P_ = 0.5 * (P + P.transpose());
  last_ = {y, expected.S, K, factors.squared_distance(y)};
}

double UnscentedKalmanFilter::squared_mahalanobis(const Eigen::VectorXd& z) const {
  const Expected expected = expected_measurement();
  return Ldl<Eigen::Dynamic>(expected.S, Covariances::checked).squared_distance(model_.difference(z, expected.z));
}

void UnscentedKalmanFilter::set_x(const Eigen::VectorXd& x) {
  check_matrix("x", x, x_.size(), 1);
  x_ = x;
}

void UnscentedKalmanFilter::set_P(const Eigen::MatrixXd& P) {
  check_covariance("P", P, x_.size());
  P_ = 0.5 * (P + P.transpose());
}

void UnscentedKalmanFilter::set_Q(const Eigen::MatrixXd& Q) {
  check_covariance("Q", Q, x_.size());
  model_.Q = Q;
}

void UnscentedKalmanFilter::set_R(const Eigen::MatrixXd& R) {
  check_covariance("R", R, model_.R.rows());
  model_.R = R;
}

}  // namespace survtrack
