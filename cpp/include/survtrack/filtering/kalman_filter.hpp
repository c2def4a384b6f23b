// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <Eigen/Core>
#include <utility>

#include "survtrack/filtering/correction.hpp"
#include "survtrack/filtering/covariance.hpp"

namespace survtrack {

/// The linear Kalman filter, for any model: x = F x + B u + noise of covariance Q, z = H x + noise of R.
/// `KalmanFilter<4, 2>` has 4 states and 2 measured numbers and allocates nothing; `KalmanFilter<>` takes its
/// sizes from the matrices. Equations and letters: Bar-Shalom, Li and Kirubarajan 2001, 5.2.
template <int N = Eigen::Dynamic, int M = Eigen::Dynamic>
class KalmanFilter {
 public:
  using State = Eigen::Matrix<double, N, 1>;
  using StateMatrix = Eigen::Matrix<double, N, N>;
  using Measurement = Eigen::Matrix<double, M, 1>;
  using MeasurementMatrix = Eigen::Matrix<double, M, N>;
  using MeasurementCovariance = Eigen::Matrix<double, M, M>;
  using ControlMatrix = Eigen::Matrix<double, N, Eigen::Dynamic>;

  struct Model {
    StateMatrix F;            ///< transition
    MeasurementMatrix H;      ///< measured of state
    StateMatrix Q;            ///< covariance of the process noise of a step
    MeasurementCovariance R;  ///< covariance of the measurement noise
    ControlMatrix B = {};     ///< effect of the control input; without columns: there is none
    Residual residual = {};   ///< empty: z - predicted
  };

  /// Starts at state x with covariance P. Throws `InputError` naming the matrix whose size is wrong, that has a
  /// number that is not finite, or that is no covariance.
  KalmanFilter(Model model, const State& x, const StateMatrix& P, Covariances covariances = Covariances::checked)
      : covariances_(covariances), model_(std::move(model)), x_(x), P_(P) {
    check_matrix("x", x_, x_.size(), 1);
    set_F(model_.F);
    set_H(model_.H);
    set_Q(model_.Q);
    set_R(model_.R);
    if (model_.B.size() != 0) check_matrix("B", model_.B, x_.size(), model_.B.cols());
    set_P(P);
    const Eigen::Index m = model_.H.rows();
    last_ = {Measurement::Zero(m), MeasurementCovariance::Zero(m, m), Eigen::Matrix<double, N, M>::Zero(x.size(), m), 0.0};
  }

  /// x = F x, P = F P F' + Q.
  void predict() { move(model_.F * x_); }
  /// x = F x + B u.
  void predict(const Eigen::VectorXd& u) {
    check_matrix("u", u, model_.B.cols(), 1);
    move(model_.F * x_ + model_.B * u);
  }

  /// Corrects by a measurement; a missing one is simply not passed. Throws `InputError` where z has a number
  /// that is not finite or the innovation covariance is singular; the filter is then as before.
  void update(const Measurement& z) { last_ = correct_linear<N, M>(x_, P_, innovation(z), model_.H, model_.R, covariances_); }
  /// The same with another measurement noise, this time.
  void update(const Measurement& z, const MeasurementCovariance& R) {
    check_covariance("R", R, model_.H.rows(), covariances_);
    last_ = correct_linear<N, M>(x_, P_, innovation(z), model_.H, R, covariances_);
  }

  /// What the last update came from; all zero before the first.
  const Correction<N, M>& last() const { return last_; }

  /// How z differs from what is expected now, H x.
  Measurement innovation(const Measurement& z) const {
    const double sum = z.sum();
    if (z.size() != model_.H.rows() || !(sum - sum == 0.0)) check_matrix("z", z, model_.H.rows(), 1);
    if (!model_.residual) return z - model_.H * x_;
    const Eigen::VectorXd y = model_.residual(z, model_.H * x_);
    check_matrix("residual", y, model_.H.rows(), 1);
    return y;
  }
  /// S = H P H' + R, the covariance of the coming innovation.
  MeasurementCovariance innovation_covariance() const {
    return model_.H * P_ * model_.H.transpose() + model_.R;
  }
  /// (z - H x)' S^-1 (z - H x): a measurement is inside the gate that holds the share p of the true ones where this
  /// is at most `chi_square_quantile(p, M)`.
  double squared_mahalanobis(const Measurement& z) const {
    return Ldl<M>(innovation_covariance(), covariances_).squared_distance(innovation(z));
  }

  const State& x() const { return x_; }
  const StateMatrix& P() const { return P_; }
  const Model& model() const { return model_; }
  Covariances covariances() const { return covariances_; }

  /// New values of the same size; they throw as the constructor does, and then change nothing.
  void set_x(const State& x) { check_matrix("x", x, x_.size(), 1), x_ = x; }
  void set_P(const StateMatrix& P) { check_covariance("P", P, x_.size(), covariances_), P_ = 0.5 * (P + P.transpose()); }
  void set_F(const StateMatrix& F) { check_matrix("F", F, x_.size(), x_.size()), model_.F = F; }
  void set_H(const MeasurementMatrix& H) { check_matrix("H", H, model_.H.rows(), x_.size()), model_.H = H; }
  void set_Q(const StateMatrix& Q) { check_covariance("Q", Q, x_.size(), covariances_), model_.Q = Q; }
  void set_R(const MeasurementCovariance& R) { check_covariance("R", R, model_.H.rows(), covariances_), model_.R = R; }

 private:
  void move(const State& x) {
    const StateMatrix FP = model_.F * P_;
    StateMatrix P;
    set_upper_product(P, model_.Q, FP, model_.F);
    check_still_finite("predict", x, P);
    x_ = x;
    P_ = mirrored(P);
  }

  Covariances covariances_;
  Model model_;
  State x_;
  StateMatrix P_;
  Correction<N, M> last_;
};

}  // namespace survtrack
