// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "survtrack/filtering/filter_bank.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <random>
#include <string>

namespace survtrack {
namespace {

bool turns(const FilterOptions& options) {
  return std::holds_alternative<ExtendedOptions>(options) || std::holds_alternative<UnscentedOptions>(options) ||
         std::holds_alternative<ParticleOptions>(options);
}

/// What every filter promises: it finds the velocity of what moves steadily, slots do not touch each other,
/// and state and estimate say the same.
class FilterContract : public testing::TestWithParam<FilterOptions> {
 protected:
  /// The mean velocity over the headings that an object which may turn can have is a little shorter than it is.
  static double share_of_velocity() { return turns(GetParam()) ? 0.04 : 0.0; }
};

TEST_P(FilterContract, FindsPositionAndVelocityOfASteadyMotion) {
  const auto bank = make_filter_bank(GetParam());
  bank->add({10.0, 200.0}, 20.0);
  for (int i = 1; i <= 60; ++i) {
    bank->predict(1.0);
    bank->correct(0, {10.0 + 4.0 * i, 200.0 - 3.0 * i});
  }
  const Estimate now = bank->estimate(0);
  const double slack = 5.0 * share_of_velocity();
  EXPECT_NEAR(now.position.x, 250.0, 0.05 + slack);
  EXPECT_NEAR(now.position.y, 20.0, 0.05 + slack);
  EXPECT_NEAR(now.velocity.x, 4.0, 0.05 + slack);
  EXPECT_NEAR(now.velocity.y, -3.0, 0.05 + slack);
  bank->predict(1.0);
  EXPECT_NEAR(bank->predicted_position(0).x, 254.0, 0.1 + slack);
  EXPECT_NEAR(bank->predicted_position(0).y, 17.0, 0.1 + slack);
}

TEST_P(FilterContract, TwoStepsAtOnceAfterAMissingFrame) {
  const auto bank = make_filter_bank(GetParam());
  bank->add({0.0, 0.0}, 20.0);
  double time = 0.0;
  for (int i = 0; i < 60; ++i) {
    const double dt = i % 3 == 0 ? 2.0 : 1.0;
    time += dt;
    bank->predict(dt);
    bank->correct(0, {5.0 * time, 0.0});
  }
  EXPECT_NEAR(bank->estimate(0).velocity.x, 5.0, 0.05 + 5.0 * share_of_velocity());
}

TEST_P(FilterContract, SlotsDoNotTouchEachOther) {
  const auto both = make_filter_bank(GetParam());
  const auto alone = make_filter_bank(GetParam());
  EXPECT_EQ(both->add({1.0, 1.0}, 10.0), 0);
  EXPECT_EQ(both->add({50.0, 60.0}, 30.0), 1);
  alone->add({1.0, 1.0}, 10.0);  // random numbers go by the turn of birth
  alone->remove(0);
  alone->add({50.0, 60.0}, 30.0);
  for (int i = 1; i <= 12; ++i) {
    both->predict(0.5);
    alone->predict(0.5);
    if (i % 2 == 0) both->correct(0, {1.0 + i, 1.0});
    if (i % 3 != 0) {
      both->correct(1, {50.0 - i, 60.0 + i});
      alone->correct(0, {50.0 - i, 60.0 + i});
    }
  }
  both->remove(0);  // slot 1 moves down to 0, and a younger one follows
  EXPECT_EQ(both->add({1.0, 1.0}, 10.0), 1);
  ASSERT_EQ(both->size(), 2);
  for (int i = 0; i < 5; ++i) {
    both->predict(0.5);
    alone->predict(0.5);
    both->correct(0, {40.0 - i, 70.0 + i});
    alone->correct(0, {40.0 - i, 70.0 + i});
  }
  EXPECT_EQ(both->state(0), alone->state(0));
  EXPECT_EQ(both->state_covariance(0), alone->state_covariance(0));
  EXPECT_EQ(both->innovation_covariance_px2(0), alone->innovation_covariance_px2(0));
}

TEST_P(FilterContract, StateAndEstimateSayTheSame) {
  const auto bank = make_filter_bank(GetParam());
  bank->add({3.0, 4.0}, 10.0);
  bank->predict(1.0);
  bank->correct(0, {5.0, 8.0});
  const Estimate now = bank->estimate(0);
  const Eigen::VectorXd x = bank->state(0);
  EXPECT_EQ(x(0), now.position.x);
  EXPECT_EQ(x(1), now.position.y);
  const int rates = bank->box_size(0) ? 4 : 2;  // width and height stand between
  EXPECT_EQ(x(rates), now.velocity.x);
  EXPECT_EQ(x(rates + 1), now.velocity.y);
  const Eigen::MatrixXd P = bank->state_covariance(0);
  if (P.size() == 0) {
    EXPECT_EQ(now.covariance_px2, Symmetric2{});
  } else {
    EXPECT_EQ(now.covariance_px2, (Symmetric2{P(0, 0), P(0, 1), P(1, 1)}));
  }
}

TEST_P(FilterContract, ASecondMeasurementOfTheSameTimeStaysFinite) {
  const auto bank = make_filter_bank(GetParam());
  bank->add({3.0, 4.0}, 10.0);
  bank->correct(0, {5.0, 8.0});
  EXPECT_TRUE(bank->state(0).allFinite());
}

TEST_P(FilterContract, RestartIsANewBeginningInTheSameSlot) {
  const auto bank = make_filter_bank(GetParam());
  bank->add({3.0, 4.0}, 10.0);
  bank->add({60.0, 60.0}, 10.0);
  for (int i = 1; i <= 10; ++i) {
    bank->predict(1.0);
    bank->correct(0, {3.0 + 5.0 * i, 4.0});
    bank->correct(1, {60.0, 60.0 - 2.0 * i});
  }
  const Eigen::VectorXd other = bank->state(1);
  bank->restart(0, {100.0, 200.0}, 30.0);
  const auto fresh = make_filter_bank(GetParam());
  fresh->add({100.0, 200.0}, 30.0);
  ASSERT_EQ(bank->size(), 2);
  EXPECT_EQ(bank->state(0), fresh->state(0));
  EXPECT_EQ(bank->state_covariance(0), fresh->state_covariance(0));
  EXPECT_EQ(bank->estimate(0).position, (Point{100.0, 200.0}));
  EXPECT_EQ(bank->innovation_covariance_px2(0), fresh->innovation_covariance_px2(0));
  EXPECT_EQ(bank->state(1), other);
}

TEST_P(FilterContract, StepsOfAnyLengthStayFinite) {
  for (const double dt : {1e-9, 1e-3, 1e3, 1e6}) {
    const auto bank = make_filter_bank(GetParam());
    bank->add({3.0, 4.0}, 10.0);
    for (int i = 0; i < 20; ++i) {
      bank->predict(dt);
      if (i % 3 != 0) bank->correct(0, {5.0 + i, 8.0}, {i % 2 == 0 ? 1e6 : 0.0, 0.0, 0.0});
    }
    EXPECT_TRUE(bank->state(0).allFinite()) << dt;
    EXPECT_TRUE(bank->state_covariance(0).allFinite()) << dt;
    EXPECT_TRUE(std::isfinite(bank->predicted_position(0).x)) << dt;
  }
}

TEST_P(FilterContract, ClearForgetsAll) {
  const auto bank = make_filter_bank(GetParam());
  bank->add({3.0, 4.0}, 10.0);
  bank->clear();
  EXPECT_EQ(bank->size(), 0);
  EXPECT_EQ(bank->add({7.0, 8.0}, 10.0), 0);
  EXPECT_EQ(bank->estimate(0).position, (Point{7.0, 8.0}));
}

INSTANTIATE_TEST_SUITE_P(Filters, FilterContract,
                         testing::Values(FilterOptions{KalmanCvOptions{}}, FilterOptions{KalmanCaOptions{}},
                                         FilterOptions{MeanVelocityOptions{}}, FilterOptions{KalmanDiscreteOptions{}},
                                         FilterOptions{KalmanDiscreteOptions{.measurement_covariance = {9.0, 5.0, 4.0}}},
                                         FilterOptions{KalmanBoxOptions{}},
                                         FilterOptions{MeanVelocityOptions{.window_steps = 5, .extrapolate_lost = true}},
                                         FilterOptions{ExtendedOptions{}}, FilterOptions{UnscentedOptions{}},
                                         FilterOptions{ParticleOptions{}}),
                         [](const auto& tested) {
                           const auto name = [](const auto& o) { return std::string(o.model); };
                           return std::visit(name, tested.param) + "_" + std::to_string(tested.index);
                         });

/// Kalman filters of either model over a random run with missing measurements and changing sizes.
class KalmanContract : public testing::TestWithParam<FilterOptions> {};

TEST_P(KalmanContract, CovarianceStaysSymmetricAndPositiveOverManySteps) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> step(1e-3, 3.0), part(0.0, 1.0), size(1.0, 200.0);
  std::normal_distribution<double> noise(0.0, 5.0);
  const auto bank = make_filter_bank(GetParam());
  bank->add({0.0, 0.0}, 20.0);
  double time = 0.0;
  for (int i = 0; i < 10000; ++i) {
    const double dt = step(random);
    time += dt;
    bank->predict(dt);
    if (part(random) < 0.7) {
      bank->correct(0, {30.0 * std::sin(0.1 * time) + noise(random), 0.5 * time + noise(random)});
      bank->set_object_size(0, size(random));
    }
    const Eigen::MatrixXd P = bank->state_covariance(0);
    ASSERT_LE((P - P.transpose()).cwiseAbs().maxCoeff(), 1e-12 * P.cwiseAbs().maxCoeff()) << "step " << i;
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(P, Eigen::EigenvaluesOnly);
    ASSERT_GT(solver.eigenvalues().minCoeff(), 0.0) << "step " << i;
  }
}

TEST_P(KalmanContract, MeasuringLowersAndMissingRaisesTheVariance) {
  const auto bank = make_filter_bank(GetParam());
  bank->add({0.0, 0.0}, 20.0);
  for (int i = 0; i < 30; ++i) {
    bank->predict(1.0);
    bank->correct(0, {0.0, 0.0});
  }
  double before = bank->estimate(0).covariance_px2.xx;
  for (int i = 0; i < 5; ++i) {
    bank->predict(1.0);
    const Symmetric2 now = bank->estimate(0).covariance_px2;
    EXPECT_GT(now.xx, before);
    EXPECT_GT(bank->innovation_covariance_px2(0).xx, now.xx);
    before = now.xx;
  }
  bank->correct(0, {0.0, 0.0});
  EXPECT_LT(bank->estimate(0).covariance_px2.xx, before);
}

TEST_P(KalmanContract, WhatIsMeasuredLessWellCountsLess) {
  const auto sharp = make_filter_bank(GetParam()), blurred = make_filter_bank(GetParam());
  for (const auto& bank : {sharp.get(), blurred.get()}) {
    bank->add({0.0, 0.0}, 20.0);
    bank->predict(1.0);
  }
  const Symmetric2 extra{50.0, 10.0, 100.0};
  EXPECT_NEAR(blurred->innovation_covariance_px2(0, extra).xx, sharp->innovation_covariance_px2(0).xx + 50.0, 1e-9);
  EXPECT_NEAR(blurred->innovation_covariance_px2(0, extra).xy, sharp->innovation_covariance_px2(0).xy + 10.0, 1e-9);
  sharp->correct(0, {10.0, 10.0});
  blurred->correct(0, {10.0, 10.0}, extra);
  EXPECT_LT(blurred->estimate(0).position.y, sharp->estimate(0).position.y);
  EXPECT_GT(blurred->estimate(0).covariance_px2.yy, sharp->estimate(0).covariance_px2.yy);
}

TEST_P(KalmanContract, TwoHalfStepsAreOneStep) {
  // The turns of the others are taken at their mean over a step; see turn_banks_test.cpp.
  if (turns(GetParam())) GTEST_SKIP() << "not linear";
  FilterOptions options = GetParam();
  if (std::holds_alternative<KalmanDiscreteOptions>(options)) {
    // Its Q is that of whole steps: those are joined exactly.
    std::get<KalmanDiscreteOptions>(options).step_time = 0.35;
  }
  if (auto* box = std::get_if<KalmanBoxOptions>(&options)) box->lost_damping_time = 0.0;
  if (auto* cv = std::get_if<KalmanCvOptions>(&options)) cv->lost_damping_time = 0.0;
  const auto whole = make_filter_bank(options);
  const auto halves = make_filter_bank(options);
  for (const auto& bank : {whole.get(), halves.get()}) {
    bank->add({100.0, 50.0}, 20.0);
    bank->predict(1.0);
    bank->correct(0, {108.0, 47.0});
  }
  whole->predict(0.7);
  halves->predict(0.35);
  halves->predict(0.35);
  EXPECT_TRUE(halves->state(0).isApprox(whole->state(0), 1e-12));
  EXPECT_TRUE(halves->state_covariance(0).isApprox(whole->state_covariance(0), 1e-12));
}

INSTANTIATE_TEST_SUITE_P(Filters, KalmanContract,
                         testing::Values(FilterOptions{KalmanCvOptions{}}, FilterOptions{KalmanCaOptions{}},
                                         FilterOptions{KalmanCvOptions{.noise_unit = NoiseUnit::px}},
                                         FilterOptions{KalmanCaOptions{.noise_unit = NoiseUnit::px}},
                                         FilterOptions{KalmanBoxOptions{}}, FilterOptions{KalmanDiscreteOptions{}},
                                         FilterOptions{KalmanDiscreteOptions{.measurement_covariance = {9.0, 5.0, 4.0}}},
                                         FilterOptions{ExtendedOptions{}}, FilterOptions{UnscentedOptions{}},
                                         FilterOptions{ParticleOptions{}}));

}  // namespace
}  // namespace survtrack
