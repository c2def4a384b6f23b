// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <Eigen/Core>
#include <cmath>
#include <functional>

#include "survtrack/filtering/covariance.hpp"
#include "survtrack/filtering/ldl.hpp"
#include "survtrack/filtering/symmetric_products.hpp"

namespace survtrack {

/// How a measurement differs from the predicted one: z - predicted unless a filter is given another, such as
/// one that wraps (`wrapped_difference`).
using Residual = std::function<Eigen::VectorXd(const Eigen::VectorXd& z, const Eigen::VectorXd& predicted)>;

/// What an update came from. Letters: Bar-Shalom, Li and Kirubarajan 2001, 5.2.
template <int N = Eigen::Dynamic, int M = Eigen::Dynamic>
struct Correction {
  Eigen::Matrix<double, M, 1> y;  ///< innovation: the residual of the measurement
  Eigen::Matrix<double, M, M> S;  ///< its covariance
  Eigen::Matrix<double, N, M> K;  ///< gain
  double nis = 0.0;               ///< y' S^-1 y; of M degrees of freedom if the model fits

  /// Logarithm of the density of the innovation, Gaussian with covariance S. Throws `InputError` where S is
  /// not positive definite, as it can be with `Covariances::as_published`.
  double log_likelihood() const {
    constexpr double log_two_pi = 1.8378770664093453;
    const Ldl<M> factors(S, Covariances::checked);
    return -0.5 * (nis + factors.log_determinant() + static_cast<double>(y.size()) * log_two_pi);
  }
};

/// Corrects x and P, given the innovation y and that the measurement is H x with noise R. Joseph form:
/// P = (I - K H) P (I - K H)' + K R K' stays symmetric and positive semi-definite whatever the rounding (Bar-Shalom,
/// Li and Kirubarajan 2001, 5.2.4). Throws `InputError` where S is singular; x and P are then as before.
template <int N, int M>
Correction<N, M> correct_linear(Eigen::Matrix<double, N, 1>& x, Eigen::Matrix<double, N, N>& P,
                                const Eigen::Matrix<double, M, 1>& y, const Eigen::Matrix<double, M, N>& H,
                                const Eigen::Matrix<double, M, M>& R, Covariances covariances) {
  Correction<N, M> c;
  const Eigen::Matrix<double, N, M> PH = P * H.transpose();
  c.y = y;
  c.S = H * PH + R;
  const Ldl<M> factors(c.S, covariances);
  c.K = PH;
  factors.solve_from_right(c.K);
  c.nis = factors.squared_distance(y);
  Eigen::Matrix<double, N, N> I_KH = -c.K * H;
  I_KH.diagonal().array() += 1.0;
  const Eigen::Matrix<double, N, M> KR = c.K * R;
  const Eigen::Matrix<double, N, N> left = P - c.K * PH.transpose();  // (I - K H) P
  const Eigen::Matrix<double, N, N> KRK = KR * c.K.transpose();
  Eigen::Matrix<double, N, N> updated;
  set_upper_product(updated, KRK, left, I_KH);
  const Eigen::Matrix<double, N, 1> moved = x + c.K * y;
  check_still_finite("update", moved, updated);
  x = moved;
  P = mirrored(updated);
  return c;
}

/// Brings a difference into [-period / 2, period / 2): the shorter way round a circle or a closed path. A
/// period of 0 leaves it alone. Throws `InputError` for another that is not above 0 and finite.
double wrapped_difference(double difference, double period);

}  // namespace survtrack
