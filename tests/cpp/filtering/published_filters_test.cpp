// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

// Filters of two works as they are printed, and what is wrong with them.

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <Eigen/LU>

#include "survtrack/filtering/kalman_filter.hpp"
#include "survtrack/filtering/motion_model.hpp"

namespace survtrack {
namespace {

using Filter = KalmanFilter<4, 2>;

/// Nashenda 2011, 5.1: constant velocity, 3.724 frames a second, the printed R (no covariance) and B u, after so many
/// updates; the covariances do not depend on what is measured.
struct Nashenda {
  Nashenda(double q, int updates) {
    Filter::Model m;
    m.F = ConstantVelocity::transition(0.2685);
    m.H = Eigen::MatrixXd::Identity(2, 4);
    m.Q = q * Eigen::Matrix4d::Identity();
    m.R << 0.2877, 1.1909, 1.1909, 1.1465;
    m.B = Eigen::Vector4d(0.0, 0.0, 0.0, 8.0);
    Filter filter(m, {192.0, 144.0, 0.0, 0.0}, 100.0 * Eigen::Matrix4d::Identity(), Covariances::as_published);
    for (int k = 0; k < updates; ++k) {
      filter.predict(Eigen::VectorXd::Ones(1));
      predicted = filter.P();
      filter.update({367.0, 274.0});
    }
    gain = filter.last().K;
    updated = filter.P();
  }
  Eigen::Matrix4d predicted, updated;
  Eigen::Matrix<double, 4, 2> gain;
};

constexpr double printed = 0.5e-4 + 1e-9;  // four decimals

TEST(PublishedFilters, Nashenda2011WithQ10) {
  const Nashenda run(10.0, 121);
  Eigen::Matrix4d P_minus, P;
  P_minus << 13.3580, 1.6698, 11.6210, 1.1871, 1.6698, 14.5621, 1.1871, 12.4771, 11.6210, 1.1871, 52.7167, 0.9202,
      1.1871 /* misprinted 11.1871 */, 12.4771, 0.9202, 53.3803;
  Eigen::Matrix<double, 4, 2> K;
  K << 0.9946, -0.0748, -0.0748, 0.9406, 0.8690, -0.0827, -0.0827, 0.8093;
  P << 0.1970, 1.0987, 0.1515, 0.9401, 1.0987, 0.9893, 0.9401, 0.8294, 0.1515, 0.9401, 42.7167, 0.9202, 0.9401, 0.8294,
      0.9202, 43.3803;
  EXPECT_LT((run.predicted - P_minus).cwiseAbs().maxCoeff(), printed);
  EXPECT_LT((run.gain - K).cwiseAbs().maxCoeff(), printed);
  EXPECT_LT((run.updated - P).cwiseAbs().maxCoeff(), printed);
}

TEST(PublishedFilters, Nashenda2011WithQ50) {
  Eigen::Matrix4d P_minus;
  P_minus << 65.7521, 1.7842, 57.4486, 1.2843, 1.7842, 67.0388, 1.2843, 58.3748, 57.4486, 1.2843, 263.1132, 1.0029, 1.2843,
      58.3748, 1.0029, 263.8365;
  EXPECT_LT((Nashenda(50.0, 121).predicted - P_minus).cwiseAbs().maxCoeff(), printed);
}

TEST(PublishedFilters, Nashenda2011WithQ0AndQ1AtUpdate108) {
  Eigen::Matrix<double, 4, 2> still, one;
  still << 0.0365, 0.0, 0.0, 0.0365, 0.0019, 0.0, 0.0, 0.0019;
  one << 1.4773, -0.6126, -0.6126, 1.0355, 1.4039, -0.6727, -0.6727, 0.9188;
  EXPECT_LT((Nashenda(0.0, 108).gain - still).cwiseAbs().maxCoeff(), printed);
  EXPECT_LT((Nashenda(1.0, 108).gain - one).cwiseAbs().maxCoeff(), printed);
}

/// O'Malley 2000: Q = 0.01 diag(1, 10, 1, 10), R = 0.0001 diag(1, 20000), dt = 1/15 s.
Filter omalley() {
  Filter::Model m;
  m.F = ConstantVelocity::transition(1.0 / 15.0);
  m.H = Eigen::MatrixXd::Identity(2, 4);
  m.Q = (0.01 * Eigen::Vector4d(1.0, 10.0, 1.0, 10.0)).asDiagonal();
  m.R = (0.0001 * Eigen::Vector2d(1.0, 20000.0)).asDiagonal();
  return Filter(m, {2.0, 1.83, 77.0, 0.3}, Eigen::Matrix4d::Identity());
}

TEST(PublishedFilters, OMalley2000GainIsOfThePredictedCovariance) {
  Filter filter = omalley();
  for (int k = 0; k < 500; ++k) {
    filter.predict();
    if (k < 499) filter.update({0.0, 0.0});
  }
  EXPECT_NEAR(3.0 * std::sqrt(filter.P()(0, 0)), 0.31, 0.005);
  filter.update({0.0, 0.0});
  EXPECT_NEAR(filter.last().K(0, 0), 0.99, 0.005);

  // Both listings take the gain from the covariance before the prediction.
  const auto& m = filter.model();
  Eigen::Matrix4d P = Eigen::Matrix4d::Identity(), predicted;
  Eigen::Matrix<double, 4, 2> K;
  for (int k = 0; k < 500; ++k) {
    predicted = m.F * P * m.F.transpose() + m.Q;
    K = P * m.H.transpose() * (m.H * predicted * m.H.transpose() + m.R).inverse();
    P = (Eigen::Matrix4d::Identity() - K * m.H) * predicted;
  }
  EXPECT_NEAR(K(0, 0), 0.50, 0.005);
  EXPECT_NEAR(std::sqrt(predicted(0, 0)) / 0.1039, 1.5, 0.02);
}

TEST(PublishedFilters, AnUpdateLowersTheTraceAndAPlusWouldRaiseIt) {
  Filter filter = omalley();
  for (int k = 0; k < 50; ++k) {
    filter.predict();
    const Eigen::Matrix4d before = filter.P();
    filter.update({0.0, 0.0});
    EXPECT_LT(filter.P().trace(), before.trace());
    const Eigen::Matrix4d wrong = before + filter.last().K * filter.model().H * before;  // (I + K H) P
    EXPECT_GT(wrong.trace(), before.trace());
  }
}

}  // namespace
}  // namespace survtrack
