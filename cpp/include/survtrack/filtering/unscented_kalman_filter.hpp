// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <Eigen/Core>
#include <cmath>
#include <utility>

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

/// Throws `InputError` for what is out of its range, with n states.
void check_sigma_points(const SigmaPoints& points, Eigen::Index n);

/// The unscented Kalman filter: sigma points go through f and h, no derivatives are needed. The points are drawn anew
/// for the update, so that Q counts in it.
/// `UnscentedKalmanFilter<4, 2>` has 4 states and 2 measured numbers and allocates nothing; `UnscentedKalmanFilter<>`
/// takes its sizes from the model.
template <int N = Eigen::Dynamic, int M = Eigen::Dynamic>
class UnscentedKalmanFilter {
 public:
  using Model = NonlinearModel<N, M>;
  using State = typename Model::State;
  using StateMatrix = typename Model::StateMatrix;
  using Measurement = typename Model::Measurement;
  using MeasurementCovariance = typename Model::MeasurementCovariance;
  static constexpr int columns = N == Eigen::Dynamic ? Eigen::Dynamic : 2 * N + 1;
  using Points = Eigen::Matrix<double, N, columns>;

  /// Starts at state x with covariance P. Throws `InputError` naming what is wrong; a callable's exceptions pass
  /// through, and leave the filter as it was.
  UnscentedKalmanFilter(Model model, const State& x, const StateMatrix& P, const SigmaPoints& points = {})
      : model_(std::move(model)), points_(points), x_(x), P_(P) {
    model_.check(x, P);
    check_sigma_points(points, x.size());
    const Eigen::Index n = x.size(), m = model_.R.rows();
    last_ = {Measurement::Zero(m), MeasurementCovariance::Zero(m, m), Eigen::Matrix<double, N, M>::Zero(n, m), 0.0};
  }

  void predict(const Eigen::VectorXd& u = {}) {
    Points points = sigma_points();
    for (Eigen::Index i = 0; i < points.cols(); ++i) points.col(i) = model_.moved(points.col(i), u);
    // The weights sum to 1, so the mean may be taken relative to the central point: with a small alpha the plain sum
    // would be the difference of huge numbers.
    const State center = points.col(0);
    points.colwise() -= center;
    const double outer = outer_weight();
    const State shift = outer * points.rowwise().sum();
    points.colwise() -= shift;
    const auto others = points.rightCols(points.cols() - 1);
    const State x = center + shift;
    const StateMatrix P = outer * (others * others.transpose()) + central_weight() * (shift * shift.transpose()) + model_.Q;
    check_still_finite("predict", x, P);
    x_ = x;
    P_ = 0.5 * (P + P.transpose());
  }
  /// Throws as `KalmanFilter::update` does.
  void update(const Measurement& z) {
    const Expected expected = expected_measurement();
    const Measurement y = model_.difference(z, expected.z);
    const Ldl<M> factors(expected.S, Covariances::checked);
    Eigen::Matrix<double, N, M> K = expected.xz;
    factors.solve_from_right(K);
    const State x = x_ + K * y;
    const StateMatrix P = P_ - K * expected.S * K.transpose();
    check_still_finite("update", x, P);
    x_ = x;
    P_ = 0.5 * (P + P.transpose());
    last_ = {y, expected.S, K, factors.squared_distance(y)};
  }

  const Correction<N, M>& last() const { return last_; }  ///< of the last update; zero before the first
  /// y' S^-1 y of a measurement, as things stand now.
  double squared_mahalanobis(const Measurement& z) const {
    const Expected expected = expected_measurement();
    return Ldl<M>(expected.S, Covariances::checked).squared_distance(model_.difference(z, expected.z));
  }

  const State& x() const { return x_; }
  const StateMatrix& P() const { return P_; }
  const Model& model() const { return model_; }
  const SigmaPoints& points() const { return points_; }
  void set_x(const State& x) { check_matrix("x", x, x_.size(), 1), x_ = x; }
  void set_P(const StateMatrix& P) { check_covariance("P", P, x_.size()), P_ = 0.5 * (P + P.transpose()); }
  void set_Q(const StateMatrix& Q) { check_covariance("Q", Q, x_.size()), model_.Q = Q; }
  void set_R(const MeasurementCovariance& R) { check_covariance("R", R, model_.R.rows()), model_.R = R; }

  /// The sigma points of the present state, a column each, the mean first.
  Points sigma_points() const {
    const Eigen::Index n = x_.size();
    const StateMatrix root = std::sqrt(0.5 / outer_weight()) * covariance_root("P", P_);
    Points points = x_.replicate(1, 2 * n + 1);
    points.middleCols(1, n) += root;
    points.rightCols(n) -= root;
    return points;
  }

 private:
  struct Expected {
    Measurement z;                   ///< mean of the measurement
    MeasurementCovariance S;         ///< its covariance with R
    Eigen::Matrix<double, N, M> xz;  ///< covariance of state and measurement
  };
  Expected expected_measurement() const {
    const Points points = sigma_points();
    const double outer = outer_weight();
    const Measurement center = model_.measured(points.col(0));
    Eigen::Matrix<double, M, columns> z(model_.R.rows(), points.cols());
    // Relative to the central one, as above; by the residual, so that measurements that wrap have their mean too.
    z.col(0).setZero();
    for (Eigen::Index i = 1; i < points.cols(); ++i) z.col(i) = model_.difference(model_.measured(points.col(i)), center);
    const Measurement shift = outer * z.rowwise().sum();
    z.colwise() -= shift;
    const auto others = z.rightCols(z.cols() - 1);
    const auto away = points.rightCols(points.cols() - 1).colwise() - x_;
    return {center + shift,
            outer * (others * others.transpose()) + central_weight() * (shift * shift.transpose()) + model_.R,
            outer * (away * others.transpose())};
  }
  /// Of each point but the mean, for means and covariances.
  double outer_weight() const { return 0.5 / (points_.alpha * points_.alpha * (static_cast<double>(x_.size()) + points_.kappa)); }
  /// Of the mean, for covariances.
  double central_weight() const {
    const double of_mean = 1.0 - 2.0 * static_cast<double>(x_.size()) * outer_weight();
    return of_mean + 1.0 - points_.alpha * points_.alpha + points_.beta;
  }

  Model model_;
  SigmaPoints points_;
  State x_;
  StateMatrix P_;
  Correction<N, M> last_;
};

}  // namespace survtrack
