// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "../error_message.hpp"
#include "survtrack/core/errors.hpp"
#include "survtrack/filtering/extended_kalman_filter.hpp"
#include "survtrack/filtering/kalman_filter.hpp"
#include "survtrack/filtering/unscented_kalman_filter.hpp"

namespace survtrack {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

const Eigen::Matrix3d F = (Eigen::Matrix3d() << 0.9, 0.3, 0.0, -0.2, 0.8, 0.1, 0.0, 0.1, 0.7).finished();
const Eigen::Matrix<double, 2, 3> H = (Eigen::Matrix<double, 2, 3>() << 1.0, 0.0, 0.5, 0.0, 1.0, 0.0).finished();

NonlinearModel<> linear() {
  return {[](const VectorXd& x, const VectorXd& u) { return u.size() == 0 ? VectorXd(F * x) : VectorXd(F * x + u); },
          [](const VectorXd& x) { return VectorXd(H * x); }, 0.2 * MatrixXd::Identity(3, 3), 0.5 * MatrixXd::Identity(2, 2), {}};
}

template <class Filter>
void expect_like_the_linear_one(Filter filter) {
  const NonlinearModel<> m = linear();
  KalmanFilter<> reference({F, H, m.Q, m.R, MatrixXd::Identity(3, 3), {}}, filter.x(), filter.P());
  for (int k = 0; k < 100; ++k) {
    const Eigen::Vector2d z(10.0 * std::sin(0.3 * k), k % 7);
    const Eigen::Vector3d u(k % 3, 0.0, -1.0);
    filter.predict(u);
    reference.predict(u);
    ASSERT_NEAR(filter.squared_mahalanobis(z), reference.squared_mahalanobis(z), 1e-7);
    filter.update(z);
    reference.update(z);
    ASSERT_LT((filter.x() - reference.x()).cwiseAbs().maxCoeff(), 1e-9) << "step " << k;
    ASSERT_LT((filter.P() - reference.P()).cwiseAbs().maxCoeff(), 1e-9) << "step " << k;
    ASSERT_LT((filter.last().K - reference.last().K).cwiseAbs().maxCoeff(), 1e-9);
    ASSERT_NEAR(filter.last().log_likelihood(), reference.last().log_likelihood(), 1e-7);
  }
}

TEST(NonlinearFilters, AreTheKalmanFilterWhereTheModelIsLinear) {
  const VectorXd x = Eigen::Vector3d(4.0, -2.0, 1.0);
  const MatrixXd P = 5.0 * MatrixXd::Identity(3, 3);
  expect_like_the_linear_one(ExtendedKalmanFilter<>(linear(), x, P));
  expect_like_the_linear_one(ExtendedKalmanFilter<>(
      linear(), x, P, [](const VectorXd&, const VectorXd&) { return MatrixXd(F); }, [](const VectorXd&) { return MatrixXd(H); }));
  for (const SigmaPoints& points : {SigmaPoints{}, SigmaPoints{1.0, 0.0, 0.0}, SigmaPoints{0.5, 2.0, -1.0}}) {
    expect_like_the_linear_one(UnscentedKalmanFilter<>(linear(), x, P, points));
  }
}

TEST(ExtendedKalmanFilter, LinearisesWhereTheEstimateWas) {
  // x' = x^2 from 3: F = 6 at the estimate before, not 18 at the predicted 9.
  NonlinearModel<> m{[](const VectorXd& x, const VectorXd&) { return VectorXd(x.array().square()); },
                   [](const VectorXd& x) { return x; }, MatrixXd::Zero(1, 1), MatrixXd::Identity(1, 1), {}};
  ExtendedKalmanFilter<> filter(m, VectorXd::Constant(1, 3.0), MatrixXd::Identity(1, 1));
  filter.predict();
  EXPECT_NEAR(filter.x()(0), 9.0, 1e-14);
  EXPECT_NEAR(filter.P()(0, 0), 36.0, 1e-6);
}

TEST(UnscentedKalmanFilter, MomentsOfASquareAreExact) {
  // Of x ~ N(3, 1): x^2 has mean 10 and variance 4 * 9 + 2; alpha = 1, beta = 0 and kappa = 2 catch both.
  NonlinearModel<> m{[](const VectorXd& x, const VectorXd&) { return VectorXd(x.array().square()); },
                   [](const VectorXd& x) { return x; }, MatrixXd::Zero(1, 1), MatrixXd::Identity(1, 1), {}};
  UnscentedKalmanFilter<> filter(m, VectorXd::Constant(1, 3.0), MatrixXd::Identity(1, 1), {1.0, 0.0, 2.0});
  filter.predict();
  EXPECT_NEAR(filter.x()(0), 10.0, 1e-12);
  EXPECT_NEAR(filter.P()(0, 0), 38.0, 1e-11);
}

TEST(UnscentedKalmanFilter, MeanOfBearingsThatWrap) {
  // Seen from the origin, west: bearings on both sides of pi.
  const double pi = 3.141592653589793;
  NonlinearModel<> m{[](const VectorXd& x, const VectorXd&) { return x; },
                   [](const VectorXd& x) { return VectorXd::Constant(1, std::atan2(x(1), x(0))).eval(); }, MatrixXd::Zero(2, 2),
                   MatrixXd::Constant(1, 1, 0.01),
                   [pi](const VectorXd& z, const VectorXd& predicted) {
                     return VectorXd::Constant(1, wrapped_difference(z(0) - predicted(0), 2.0 * pi)).eval();
                   }};
  UnscentedKalmanFilter<> filter(m, Eigen::Vector2d(-10.0, 0.0), MatrixXd::Identity(2, 2));
  filter.update(VectorXd::Constant(1, -pi + 0.05));
  EXPECT_NEAR(filter.last().y(0), 0.05, 1e-9);
  EXPECT_LT(filter.x()(1), 0.0);
  EXPECT_GT(filter.x()(1), -0.5);
}

TEST(NonlinearFilters, SayWhatIsWrongAndStayAsTheyWere) {
  const VectorXd x = Eigen::Vector3d::Ones();
  const MatrixXd P = MatrixXd::Identity(3, 3);
  NonlinearModel<> m = linear();
  int calls = 0;
  m.f = [&](const VectorXd& at, const VectorXd&) -> VectorXd {
    if (++calls > 3) throw std::runtime_error("no more");
    return at.head(2);
  };
  m.h = [](const VectorXd&) { return VectorXd::Constant(2, std::numeric_limits<double>::quiet_NaN()).eval(); };
  ExtendedKalmanFilter<> extended(m, x, P);
  UnscentedKalmanFilter<> unscented(m, x, P);
  EXPECT_TRUE(contains(message_of<InputError>([&] { extended.predict(); }), "f: is 2x1; expected 3x1"));
  EXPECT_TRUE(contains(message_of<InputError>([&] { unscented.predict(); }), "f: is 2x1; expected 3x1"));
  EXPECT_TRUE(contains(message_of<InputError>([&] { extended.update(Eigen::Vector2d::Zero()); }), "h[0]: is nan"));
  EXPECT_TRUE(contains(message_of<InputError>([&] { unscented.update(Eigen::Vector2d::Zero()); }), "h[0]: is nan"));
  calls = 3;
  EXPECT_EQ(message_of<std::runtime_error>([&] { unscented.predict(); }), "no more");
  EXPECT_EQ(extended.x(), x);
  EXPECT_EQ(unscented.P(), P);
  EXPECT_TRUE(contains(message_of<InputError>([&] { UnscentedKalmanFilter<>(linear(), x, P, {0.0, 2.0, 0.0}); }), "alpha: is 0"));
  EXPECT_TRUE(contains(message_of<InputError>([&] { UnscentedKalmanFilter<>(linear(), x, P, {1.0, 2.0, -3.0}); }), "kappa: is -3"));
  EXPECT_TRUE(contains(message_of<InputError>([&] { ExtendedKalmanFilter<>(linear(), x, -P); }), "P: ", "is -1"));
}

/// A pendulum, seen from the side.
template <int N, int M>
NonlinearModel<N, M> pendulum() {
  using Model = NonlinearModel<N, M>;
  Model model;
  model.f = [](const typename Model::State& x, const VectorXd&) {
    typename Model::State next = x;
    next(0) += 0.1 * x(1);
    next(1) -= 0.1 * std::sin(x(0));
    return next;
  };
  model.h = [](const typename Model::State& x) {
    typename Model::Measurement z(1);
    z(0) = std::sin(x(0));
    return z;
  };
  model.Q = 0.01 * MatrixXd::Identity(2, 2);
  model.R = 0.04 * MatrixXd::Identity(1, 1);
  return model;
}

template <class Fixed, class Dynamic>
void expect_the_same(Fixed fixed, Dynamic dynamic) {
  for (int k = 0; k < 50; ++k) {
    fixed.predict();
    dynamic.predict();
    const double z = 0.6 * std::sin(0.1 * k);
    EXPECT_NEAR(fixed.squared_mahalanobis(VectorXd::Constant(1, z)), dynamic.squared_mahalanobis(VectorXd::Constant(1, z)), 1e-9);
    fixed.update(VectorXd::Constant(1, z));
    dynamic.update(VectorXd::Constant(1, z));
    EXPECT_LT((fixed.x() - dynamic.x()).norm(), 1e-10) << k;
    EXPECT_LT((fixed.P() - dynamic.P()).norm(), 1e-10) << k;
    EXPECT_NEAR(fixed.last().nis, dynamic.last().nis, 1e-9);
  }
}

TEST(NonlinearFilters, OfFixedSizesAreTheDynamicOnes) {
  const Eigen::Vector2d start(0.5, 0.0);
  const Eigen::Matrix2d spread = Eigen::Matrix2d::Identity();
  expect_the_same(ExtendedKalmanFilter<2, 1>(pendulum<2, 1>(), start, spread),
                  ExtendedKalmanFilter<>(pendulum<Eigen::Dynamic, Eigen::Dynamic>(), start, spread));
  expect_the_same(UnscentedKalmanFilter<2, 1>(pendulum<2, 1>(), start, spread),
                  UnscentedKalmanFilter<>(pendulum<Eigen::Dynamic, Eigen::Dynamic>(), start, spread));
  const auto of_f = [](const Eigen::Vector2d& at, const VectorXd&) {
    Eigen::Matrix2d derivative;
    derivative << 1.0, 0.1, -0.1 * std::cos(at(0)), 1.0;
    return derivative;
  };
  const auto of_h = [](const Eigen::Vector2d& at) { return Eigen::RowVector2d(std::cos(at(0)), 0.0); };
  ExtendedKalmanFilter<2, 1> analytic(pendulum<2, 1>(), start, spread, of_f, of_h), numeric(pendulum<2, 1>(), start, spread);
  for (int k = 0; k < 20; ++k) {
    analytic.predict();
    numeric.predict();
    analytic.update(ExtendedKalmanFilter<2, 1>::Measurement(0.3));
    numeric.update(ExtendedKalmanFilter<2, 1>::Measurement(0.3));
    EXPECT_LT((analytic.x() - numeric.x()).norm(), 1e-8) << k;
  }
}

}  // namespace
}  // namespace survtrack
