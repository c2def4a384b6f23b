// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <Eigen/Core>
#include <functional>
#include <utility>

#include "survtrack/filtering/nonlinear_model.hpp"

namespace survtrack {

/// The extended Kalman filter: a non-linear model, linearised where the estimate is. Equations: Bar-Shalom, Li and
/// Kirubarajan 2001, 10.3.
/// `ExtendedKalmanFilter<4, 2>` has 4 states and 2 measured numbers and allocates nothing; `ExtendedKalmanFilter<>`
/// takes its sizes from the model.
template <int N = Eigen::Dynamic, int M = Eigen::Dynamic>
class ExtendedKalmanFilter {
 public:
  using Model = NonlinearModel<N, M>;
  using State = typename Model::State;
  using StateMatrix = typename Model::StateMatrix;
  using Measurement = typename Model::Measurement;
  using MeasurementMatrix = typename Model::MeasurementMatrix;
  using MeasurementCovariance = typename Model::MeasurementCovariance;
  /// Derivatives of f by x (n x n) and of h by x (m x n).
  using TransitionJacobian = std::function<StateMatrix(const State& x, const Eigen::VectorXd& u)>;
  using MeasureJacobian = std::function<MeasurementMatrix(const State& x)>;

  /// Starts at state x with covariance P. A Jacobian that is empty is taken by central differences. Throws `InputError`
  /// naming what is wrong; a callable's exceptions pass through, and leave the filter as it was.
  ExtendedKalmanFilter(Model model, const State& x, const StateMatrix& P, TransitionJacobian F = {}, MeasureJacobian H = {})
      : model_(std::move(model)), F_(std::move(F)), H_(std::move(H)), x_(x), P_(P) {
    model_.check(x, P);
    const Eigen::Index n = x.size(), m = model_.R.rows();
    last_ = {Measurement::Zero(m), MeasurementCovariance::Zero(m, m), Eigen::Matrix<double, N, M>::Zero(n, m), 0.0};
  }

  /// x = f(x, u), P = F P F' + Q with F the derivative at the estimate before.
  void predict(const Eigen::VectorXd& u = {}) {
    // The derivative at the estimate before, not at the predicted one.
    const StateMatrix F = F_ ? F_(x_, u) : numeric_jacobian<N>([&](const State& x) { return model_.moved(x, u); }, x_);
    check_matrix("F", F, x_.size(), x_.size());
    const State x = model_.moved(x_, u);
    const StateMatrix P = F * P_ * F.transpose() + model_.Q;
    check_still_finite("predict", x, P);
    x_ = x;
    P_ = 0.5 * (P + P.transpose());
  }
  /// Corrects with H, the derivative of h at the predicted state. Throws as `KalmanFilter::update` does.
  void update(const Measurement& z) {
    const Measurement y = model_.difference(z, model_.measured(x_));
    const MeasurementMatrix H = measure_jacobian();
    last_ = correct_linear<N, M>(x_, P_, y, H, model_.R, Covariances::checked);
  }

  const Correction<N, M>& last() const { return last_; }  ///< of the last update; zero before the first
  /// y' S^-1 y of a measurement, as things stand now.
  double squared_mahalanobis(const Measurement& z) const {
    const Measurement y = model_.difference(z, model_.measured(x_));
    const MeasurementMatrix H = measure_jacobian();
    return Ldl<M>(H * P_ * H.transpose() + model_.R, Covariances::checked).squared_distance(y);
  }

  const State& x() const { return x_; }
  const StateMatrix& P() const { return P_; }
  const Model& model() const { return model_; }
  void set_x(const State& x) { check_matrix("x", x, x_.size(), 1), x_ = x; }
  void set_P(const StateMatrix& P) { check_covariance("P", P, x_.size()), P_ = 0.5 * (P + P.transpose()); }
  void set_Q(const StateMatrix& Q) { check_covariance("Q", Q, x_.size()), model_.Q = Q; }
  void set_R(const MeasurementCovariance& R) { check_covariance("R", R, model_.R.rows()), model_.R = R; }

 private:
  MeasurementMatrix measure_jacobian() const {
    const auto measured = [this](const State& x) { return model_.measured(x); };
    const MeasurementMatrix H = H_ ? H_(x_) : numeric_jacobian<M>(measured, x_, model_.residual);
    check_matrix("H", H, model_.R.rows(), x_.size());
    return H;
  }

  Model model_;
  TransitionJacobian F_;
  MeasureJacobian H_;
  State x_;
  StateMatrix P_;
  Correction<N, M> last_;
};

}  // namespace survtrack
