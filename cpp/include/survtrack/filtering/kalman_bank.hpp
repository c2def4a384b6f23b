// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <Eigen/Core>
#include <Eigen/LU>
#include <cstddef>
#include <vector>

namespace survtrack {

/// Kalman filters of all tracks in one object: states of N and measurements of M numbers, held as
/// two arrays, one column a track. A single filter is a bank of one.
/// Equations and letters: Bar-Shalom, Li and Kirubarajan 2001, 5.2; Joseph form: 5.2.4.
template <int N, int M>
class KalmanBank {
 public:
  using State = Eigen::Matrix<double, N, 1>;
  using Covariance = Eigen::Matrix<double, N, N>;
  using Measurement = Eigen::Matrix<double, M, 1>;
  using MeasurementMatrix = Eigen::Matrix<double, M, N>;
  using MeasurementCovariance = Eigen::Matrix<double, M, M>;

  int size() const { return static_cast<int>(states_.size() / N); }

  /// Adds a track; its slot is size() - 1.
  int add(const State& x, const Covariance& P) {
    states_.insert(states_.end(), x.data(), x.data() + N);
    covariances_.insert(covariances_.end(), P.data(), P.data() + N * N);
    return size() - 1;
  }

  /// Removes a track; later slots move down by one, so that the order stays.
  void remove(int slot) {
    const auto x = states_.begin() + static_cast<std::ptrdiff_t>(slot) * N;
    states_.erase(x, x + N);
    const auto P = covariances_.begin() + static_cast<std::ptrdiff_t>(slot) * N * N;
    covariances_.erase(P, P + N * N);
  }

  void clear() {
    states_.clear();
    covariances_.clear();
  }

  Eigen::Map<const State> x(int slot) const { return Eigen::Map<const State>(states_.data() + at(slot) * N); }
  Eigen::Map<State> x(int slot) { return Eigen::Map<State>(states_.data() + at(slot) * N); }
  Eigen::Map<const Covariance> P(int slot) const {
    return Eigen::Map<const Covariance>(covariances_.data() + at(slot) * N * N);
  }
  Eigen::Map<Covariance> P(int slot) { return Eigen::Map<Covariance>(covariances_.data() + at(slot) * N * N); }

  /// x = F x, P = F P F' + Q for one track.
  void predict(int slot, const Covariance& F, const Covariance& Q) {
    x(slot) = (F * x(slot)).eval();
    const Covariance predicted = F * P(slot) * F.transpose() + Q;
    P(slot) = 0.5 * (predicted + predicted.transpose());
  }

  /// S = H P H' + R, the covariance of the innovation z - H x.
  MeasurementCovariance innovation_covariance(int slot, const MeasurementMatrix& H,
                                              const MeasurementCovariance& R) const {
    return H * P(slot) * H.transpose() + R;
  }

  /// Corrects one track by its measurement. Joseph form: P = (I - K H) P (I - K H)' + K R K' stays symmetric
  /// and positive semi-definite whatever the rounding. A missing measurement is simply not passed.
  void correct(int slot, const Measurement& z, const MeasurementMatrix& H, const MeasurementCovariance& R) {
    const MeasurementCovariance S = innovation_covariance(slot, H, R);
    const Eigen::Matrix<double, N, M> K = P(slot) * H.transpose() * S.inverse();
    x(slot) += (K * (z - H * x(slot))).eval();
    const Covariance I_KH = Covariance::Identity() - K * H;
    const Covariance updated = I_KH * P(slot) * I_KH.transpose() + K * R * K.transpose();
    P(slot) = 0.5 * (updated + updated.transpose());
  }

 private:
  static std::size_t at(int slot) { return static_cast<std::size_t>(slot); }

  std::vector<double> states_;
  std::vector<double> covariances_;
};

}  // namespace survtrack
