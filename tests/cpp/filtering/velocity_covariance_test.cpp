// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

// What estimates say of the velocity: from it and from nothing else a filter's prediction can be made again.

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <cmath>
#include <random>
#include <string>

#include "filtering/turn_motion.hpp"
#include "survtrack/filtering/filter_bank.hpp"
#include "survtrack/filtering/kalman_filter.hpp"
#include "survtrack/filtering/motion_model.hpp"

namespace survtrack {
namespace {

Eigen::Matrix2d matrix(const Symmetric2& m) { return (Eigen::Matrix2d() << m.xx, m.xy, m.xy, m.yy).finished(); }
Eigen::Matrix2d matrix(const Matrix2& m) { return (Eigen::Matrix2d() << m.xx, m.xy, m.yx, m.yy).finished(); }

double difference(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) { return (a - b).cwiseAbs().maxCoeff(); }

/// Position covariance after a time t by the estimate alone.
Eigen::Matrix2d after(const Estimate& now, double t) {
  const Eigen::Matrix2d C = matrix(now.cross_covariance);
  return matrix(now.covariance_px2) + t * (C + C.transpose()) + t * t * matrix(now.velocity_covariance) +
         t * t * t / 3.0 * matrix(now.velocity_noise);
}

/// A run with turns and missing measurements.
void run(FilterBank& bank, int frames = 40) {
  bank.add({40.0, 30.0}, 25.0);
  for (int k = 1; k <= frames; ++k) {
    bank.predict(0.5);
    const Symmetric2 extra = k % 5 == 0 ? Symmetric2{20.0, 6.0, 4.0} : Symmetric2{};
    if (k % 7 != 0) bank.correct(0, {40.0 + 30.0 * std::sin(0.2 * k), 60.0 - 30.0 * std::cos(0.2 * k)}, extra);
  }
}

TEST(VelocityCovariance, OfConstantVelocityIsTheReferenceFilters) {
  KalmanCvOptions options;
  options.noise_unit = NoiseUnit::px;
  options.velocity_noise = 1.5;
  options.position_noise = 2.0;
  options.initial_velocity = 8.0;
  const auto bank = make_filter_bank(options);
  using Reference = KalmanFilter<4, 2>;
  const auto model = [](double dt) {
    Reference::Model m;
    m.F = ConstantVelocity::transition(dt);
    m.H = Eigen::MatrixXd::Identity(2, 4);
    m.Q = 2.25 * ConstantVelocity::unit_noise(dt);
    m.R = 4.0 * Eigen::Matrix2d::Identity();
    return m;
  };
  bank->add({3.0, 4.0}, 50.0);
  Reference reference(model(1.0), {3.0, 4.0, 0.0, 0.0}, Eigen::Vector4d(4.0, 4.0, 64.0, 64.0).asDiagonal().toDenseMatrix());
  for (int k = 1; k <= 30; ++k) {
    const double dt = k % 3 == 0 ? 2.0 : 0.7;
    reference.set_F(model(dt).F);
    reference.set_Q(model(dt).Q);
    bank->predict(dt);
    reference.predict();
    for (const bool corrected : {false, true}) {
      if (corrected) {
        Eigen::Matrix2d R;
        R << 4.0 + k % 4, 0.5, 0.5, 4.0;
        bank->correct(0, {3.0 + k, 4.0 - k % 5}, {k % 4 + 0.0, 0.5, 0.0});
        reference.update({3.0 + k, 4.0 - k % 5}, R);
      }
      const Estimate now = bank->estimate(0);
      const Eigen::Matrix4d P = reference.P();
      ASSERT_LT(difference(matrix(now.covariance_px2), P.topLeftCorner<2, 2>()), 1e-9) << k;
      ASSERT_LT(difference(matrix(now.velocity_covariance), P.bottomRightCorner<2, 2>()), 1e-9) << k;
      ASSERT_LT(difference(matrix(now.cross_covariance), P.topRightCorner<2, 2>()), 1e-9) << k;
      ASSERT_EQ(now.velocity_noise, (Symmetric2{2.25, 0.0, 2.25}));
    }
  }
}

TEST(VelocityCovariance, OfAllIsThatOfTheState) {
  for (const FilterOptions& options :
       {FilterOptions{KalmanCvOptions{}}, FilterOptions{KalmanCaOptions{}}, FilterOptions{KalmanBoxOptions{}},
        FilterOptions{KalmanDiscreteOptions{.measurement_covariance = {9.0, 5.0, 4.0}}}, FilterOptions{ExtendedOptions{}},
        FilterOptions{UnscentedOptions{}}, FilterOptions{ParticleOptions{}}}) {
    const auto bank = make_filter_bank(options);
    run(*bank);
    const Eigen::MatrixXd P = bank->state_covariance(0);
    const int rates = bank->box_size(0) ? 4 : 2;
    const Estimate now = bank->estimate(0);
    const std::string model = std::visit([](const auto& o) { return std::string(o.model); }, options);
    EXPECT_EQ(difference(matrix(now.covariance_px2), P.topLeftCorner(2, 2)), 0.0) << model;
    EXPECT_EQ(difference(matrix(now.velocity_covariance), P.block(rates, rates, 2, 2)), 0.0) << model;
    EXPECT_EQ(difference(matrix(now.cross_covariance), P.block(0, rates, 2, 2)), 0.0) << model;
    EXPECT_GT(now.velocity_covariance.xx, 0.0) << model;
    EXPECT_GT(now.cross_covariance.xx, 0.0) << model;
  }
}

TEST(VelocityCovariance, ThePredictionOfConstantVelocityIsMadeAgain) {
  for (const FilterOptions& options : {FilterOptions{KalmanCvOptions{}}, FilterOptions{KalmanBoxOptions{}}}) {
    for (const double t : {0.01, 1.0, 9.0}) {
      const auto bank = make_filter_bank(options);
      run(*bank, 41);  // matched in the last frame: what is lost is damped
      const Eigen::Matrix2d expected = after(bank->estimate(0), t);
      bank->predict(t);
      EXPECT_LT(difference(matrix(bank->estimate(0).covariance_px2), expected), 1e-12 * expected.maxCoeff());
    }
  }
}

TEST(VelocityCovariance, OfStepsGivenAsPrintedTheLongRunIsMadeAgain) {
  KalmanDiscreteOptions options;
  options.process_variances = {0.0, 0.0, 4.0, 9.0};
  options.step_time = 0.5;
  const auto bank = make_filter_bank(options);
  run(*bank);
  EXPECT_EQ(bank->estimate(0).velocity_noise, (Symmetric2{8.0, 0.0, 18.0}));
  const Eigen::Matrix2d expected = after(bank->estimate(0), 50.0);
  bank->predict(50.0);  // a hundred steps: a sum in place of an integral
  EXPECT_LT(difference(matrix(bank->estimate(0).covariance_px2), expected), 0.02 * expected.maxCoeff());
}

TEST(VelocityCovariance, NoiseInTheAccelerationIsNotOneInTheVelocity) {
  KalmanCaOptions options;
  options.noise_unit = NoiseUnit::px;
  options.acceleration_noise = 3.0;
  auto bank = make_filter_bank(options);
  bank->add({1.0, 2.0}, 9.0);
  EXPECT_EQ(bank->estimate(0).velocity_noise, Symmetric2{});
  options.noise_form = NoiseForm::identity;
  bank = make_filter_bank(options);
  bank->add({1.0, 2.0}, 9.0);
  EXPECT_EQ(bank->estimate(0).velocity_noise, (Symmetric2{9.0, 0.0, 9.0}));
}

TEST(VelocityCovariance, AMeanVelocityHasNone) {
  const auto bank = make_filter_bank(MeanVelocityOptions{});
  run(*bank);
  const Estimate now = bank->estimate(0);
  EXPECT_NE(now.velocity.x, 0.0);
  EXPECT_EQ(now.velocity_covariance, Symmetric2{});
  EXPECT_EQ(now.cross_covariance, Matrix2{});
  EXPECT_EQ(now.velocity_noise, Symmetric2{});
}

/// Of filters whose velocity turns.
class TurningVelocity : public testing::TestWithParam<FilterOptions> {};

TEST_P(TurningVelocity, TheCrossCovarianceIsHowThePositionsCovarianceGrows) {
  const auto bank = make_filter_bank(GetParam());
  run(*bank);
  const Estimate before = bank->estimate(0);
  constexpr double dt = 1e-4;
  bank->predict(dt);
  const Eigen::Matrix2d slope = (matrix(bank->estimate(0).covariance_px2) - matrix(before.covariance_px2)) / dt;
  const Eigen::Matrix2d C = matrix(before.cross_covariance);
  EXPECT_LT(difference(slope, C + C.transpose()), 0.01 * slope.cwiseAbs().maxCoeff());
}

TEST_P(TurningVelocity, StatesDrawnFromItGoWhereItSays) {
  const auto bank = make_filter_bank(GetParam());
  run(*bank);
  constexpr int count = 40000;
  constexpr double dt = 0.3;
  const ExtendedOptions same;
  const TurnMotion motion(TurnNoise(same), dt, false);
  const Eigen::MatrixXd L = bank->state_covariance(0).llt().matrixL();
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  Eigen::MatrixXd places(count, 2);
  for (int k = 0; k < count; ++k) {
    const Eigen::VectorXd draw = Eigen::VectorXd::NullaryExpr(5, [&](Eigen::Index) { return normal(random); });
    places.row(k) = motion.moved(bank->state(0) + L * draw).head<2>().transpose();
  }
  const Eigen::MatrixXd away = places.rowwise() - places.colwise().mean();
  const Eigen::Matrix2d spread = away.transpose() * away / (count - 1);
  Estimate now = bank->estimate(0);
  EXPECT_NEAR(now.velocity_noise.xx, std::pow(same.velocity_noise * 25.0, 2), 1e-9);
  now.velocity_noise = {};  // nothing was drawn of it
  // But for what the turn adds, which the straight line does not know.
  EXPECT_LT(difference(after(now, dt), spread), 0.1 * spread.maxCoeff());
}

INSTANTIATE_TEST_SUITE_P(Filters, TurningVelocity,
                         testing::Values(FilterOptions{ExtendedOptions{}}, FilterOptions{UnscentedOptions{}},
                                         FilterOptions{ParticleOptions{}}));

}  // namespace
}  // namespace survtrack
