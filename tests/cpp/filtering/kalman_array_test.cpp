// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "survtrack/filtering/kalman_array.hpp"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>
#include <limits>
#include <random>
#include <tuple>
#include <vector>

#include "../error_message.hpp"
#include "../simd_levels.hpp"
#include "survtrack/core/errors.hpp"
#include "survtrack/filtering/kalman_filter.hpp"

namespace survtrack {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

class KalmanArrayAt : public AtEverySimdLevel {};

Eigen::MatrixXd random_matrix(Eigen::Index rows, Eigen::Index columns, std::mt19937& random) {
  std::normal_distribution<double> normal;
  return Eigen::MatrixXd::NullaryExpr(rows, columns, [&] { return normal(random); });
}

Eigen::MatrixXd random_covariance(Eigen::Index n, std::mt19937& random) {
  const Eigen::MatrixXd root = random_matrix(n, n, random);
  return root * root.transpose() + 0.1 * Eigen::MatrixXd::Identity(n, n);
}

TEST_P(KalmanArrayAt, IsAsManyFilters) {
  std::mt19937 random(11);
  for (const auto& [n, m, count] : {std::tuple{1, 1, 3}, {4, 2, 37}, {6, 2, 16}, {5, 3, 20}, {7, 5, 1}}) {
    KalmanArray::Model model{0.4 * random_matrix(n, n, random), random_matrix(m, n, random), random_covariance(n, random),
                             random_covariance(m, random), random_matrix(n, 2, random), {}};
    model.F(0, n - 1) = 0.0;
    model.H(m - 1, 0) = 0.0;
    KalmanArray array(model);
    std::vector<KalmanFilter<>> filters;
    for (int k = 0; k < count; ++k) {
      const Eigen::VectorXd x = random_matrix(n, 1, random);
      const Eigen::MatrixXd P = random_covariance(n, random);
      EXPECT_EQ(array.add(x, P), k);
      filters.emplace_back(KalmanFilter<>::Model{model.F, model.H, model.Q, model.R, model.B, {}}, x, P);
    }
    for (int step = 0; step < 20; ++step) {
      const Eigen::MatrixXd u = random_matrix(2, step % 2 == 0 ? 1 : count, random);
      Eigen::MatrixXd z = random_matrix(m, count, random);
      array.predict(u);
      for (int k = 0; k < count; ++k) {
        filters[static_cast<std::size_t>(k)].predict(u.col(step % 2 == 0 ? 0 : k));
        if ((k + step) % 3 == 2) z.col(k).setConstant(nan);
      }
      array.update(z);
      for (int k = 0; k < count; ++k) {
        KalmanFilter<>& filter = filters[static_cast<std::size_t>(k)];
        const bool missing = std::isnan(z(0, k));
        ASSERT_EQ(std::isnan(array.nis()(k)), missing);
        if (!missing) {
          filter.update(z.col(k));
          ASSERT_NEAR(array.nis()(k), filter.last().nis, 1e-9 * (1.0 + filter.last().nis));
          ASSERT_NEAR(array.log_likelihoods()(k), filter.last().log_likelihood(), 1e-9 * (1.0 + filter.last().nis));
          ASSERT_TRUE(array.innovation_covariance(k).isApprox(filter.last().S, 1e-10));
        }
        ASSERT_TRUE(array.states().col(k).isApprox(filter.x(), 1e-9));
        ASSERT_TRUE(array.covariance(k).isApprox(filter.P(), 1e-9));
      }
    }
    const Eigen::MatrixXd z = random_matrix(m, 2, random);
    EXPECT_NEAR(array.squared_mahalanobis(z)(count - 1, 1), filters.back().squared_mahalanobis(z.col(1)), 1e-8);
  }
}

INSTANTIATE_TEST_SUITE_P(All, KalmanArrayAt, testing::ValuesIn(simd_levels()), simd_level_name);

KalmanArray walkers(int count, double R, double period = 0.0) {
  Eigen::Matrix2d F, Q;
  F << 1.0, 1.0, 0.0, 1.0;
  Q << 0.1, 0.0, 0.0, 0.1;
  KalmanArray array({F, Eigen::RowVector2d(1.0, 0.0), Q, Eigen::MatrixXd::Constant(1, 1, R), {}, Eigen::VectorXd::Constant(1, period)});
  for (int k = 0; k < count; ++k) array.add(Eigen::Vector2d(k, 0.0), Eigen::Matrix2d::Identity());
  return array;
}

TEST(KalmanArray, SameBytesAtEverySimdLevel) {
  std::vector<Eigen::MatrixXd> ends;
  for (const simd::Level level : simd_levels()) {
    simd::set_level(level);
    KalmanArray array = walkers(50, 2.0, 30.0);
    for (int step = 1; step < 40; ++step) {
      array.predict();
      array.update(Eigen::RowVectorXd::LinSpaced(50, step, 50.0 + 0.9 * step));
    }
    ends.push_back(array.states());
  }
  simd::set_level(simd::best_level());
  for (const Eigen::MatrixXd& end : ends) EXPECT_EQ(end, ends.front());
}

TEST(KalmanArray, SlotsMoveDownWhenOneIsRemoved) {
  KalmanArray array = walkers(20, 1.0);
  array.remove(3);
  array.remove(0);
  EXPECT_EQ(array.size(), 18);
  EXPECT_EQ(array.states()(0, 0), 1.0);
  EXPECT_EQ(array.states()(0, 2), 4.0);
  EXPECT_EQ(array.add(Eigen::Vector2d(70.0, 7.0), Eigen::Matrix2d::Identity()), 18);
  EXPECT_EQ(array.states()(1, 18), 7.0);
  EXPECT_TRUE(std::isnan(array.nis()(18)));
  EXPECT_THROW(array.remove(19), InputError);
}

TEST(KalmanArray, MeasurementsWrap) {
  KalmanArray array = walkers(2, 1.0, 10.0);
  array.update(Eigen::RowVector2d(9.0, 2.0));  // filters at 0 and 1
  EXPECT_DOUBLE_EQ(array.innovations()(0, 0), -1.0);
  EXPECT_DOUBLE_EQ(array.innovations()(0, 1), 1.0);
  EXPECT_DOUBLE_EQ(array.squared_mahalanobis(Eigen::MatrixXd::Constant(1, 1, array.states()(0, 0) + 10.0))(0, 0), 0.0);
}

TEST(KalmanArray, SaysWhatIsWrongAndChangesNothing) {
  KalmanArray array = walkers(18, 0.0);
  array.add(Eigen::Vector2d(1.0, 1.0), Eigen::Matrix2d::Zero());
  const Eigen::MatrixXd before = array.states();
  Eigen::MatrixXd z = Eigen::MatrixXd::Zero(1, 19);
  EXPECT_TRUE(contains(message_of<InputError>([&] { array.update(z); }), "S[18]: ", "singular"));
  z(0, 4) = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(contains(message_of<InputError>([&] { array.update(z); }), "filter 4", "neither finite nor missing"));
  EXPECT_TRUE(contains(message_of<InputError>([&] { array.update(Eigen::MatrixXd::Zero(2, 19)); }), "z: is 2x19; expected 1x19"));
  EXPECT_TRUE(contains(message_of<InputError>([&] { array.set_Q(-Eigen::Matrix2d::Identity()); }), "Q: ", "is -1"));
  EXPECT_EQ(array.states(), before);
  z.setZero();
  z(0, 18) = nan;  // the singular one has none
  array.update(z);
  EXPECT_NEAR(array.states()(0, 5), 0.0, 1e-12);
  EXPECT_EQ(array.states().col(18), before.col(18));
  array.set_F(Eigen::Matrix2d::Constant(1e300));
  EXPECT_TRUE(contains(message_of<InputError>([&] { array.predict(); }), "predict[", "finite"));
}

}  // namespace
}  // namespace survtrack
