// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include <gtest/gtest.h>

#include <cmath>

#include "../error_message.hpp"
#include "survtrack/core/errors.hpp"
#include "survtrack/filtering/filter_bank.hpp"

namespace survtrack {
namespace {

KalmanCvOptions cv_in_px() {
  return {.noise_unit = NoiseUnit::px,
          .velocity_noise = 1.0,
          .position_noise = 1.0,
          .initial_velocity = 2.0,
          .lost_damping_time = 0.0};
}

TEST(KalmanCv, OneStepWorkedByHand) {
  // The numbers of KalmanBank.OneStepWorkedByHand.
  const auto bank = make_filter_bank(cv_in_px());
  bank->add({100.0, 50.0}, 77.0);  // sizes play no part in px
  bank->predict(1.0);
  EXPECT_NEAR(bank->innovation_covariance_px2(0).xx, 19.0 / 3.0, 1e-13);
  EXPECT_EQ(bank->innovation_covariance_px2(0).xy, 0.0);
  bank->correct(0, {102.0, 50.0});
  const Estimate now = bank->estimate(0);
  EXPECT_NEAR(now.position.x, 100.0 + 32.0 / 19.0, 1e-12);
  EXPECT_NEAR(now.velocity.x, 27.0 / 19.0, 1e-12);
  EXPECT_NEAR(now.position.y, 50.0, 1e-12);
  EXPECT_NEAR(now.covariance_px2.xx, 16.0 / 19.0, 1e-13);
  EXPECT_NEAR(bank->state_covariance(0)(2, 2), 34.25 / 19.0, 1e-13);
}

TEST(KalmanCv, NoisesInObjectSizesScaleWithTheObject) {
  KalmanCvOptions options = cv_in_px();
  const auto px = make_filter_bank(options);
  options.noise_unit = NoiseUnit::object_size;
  const auto sized = make_filter_bank(options);
  px->add({0.0, 0.0}, 10.0);
  sized->add({0.0, 0.0}, 10.0);
  for (int i = 1; i < 5; ++i) {
    px->predict(1.0);
    sized->predict(1.0);
    px->correct(0, {2.0 * i, 0.0});
    sized->correct(0, {2.0 * i, 0.0});
  }
  EXPECT_TRUE(sized->state(0).isApprox(px->state(0), 1e-12));
  EXPECT_TRUE(sized->state_covariance(0).isApprox(100.0 * px->state_covariance(0), 1e-12));
}

TEST(KalmanCv, AGrownObjectIsMeasuredLessSurely) {
  KalmanCvOptions options = cv_in_px();
  options.noise_unit = NoiseUnit::object_size;
  const auto bank = make_filter_bank(options);
  bank->add({0.0, 0.0}, 1.0);
  const double small = bank->innovation_covariance_px2(0).xx;
  bank->set_object_size(0, 3.0);
  EXPECT_NEAR(bank->innovation_covariance_px2(0).xx - small, 8.0, 1e-12);  // R grew from 1 to 9
}

TEST(KalmanCv, ALessCertainMeasurementCountsLess) {
  const auto bank = make_filter_bank(cv_in_px());
  bank->add({0.0, 0.0}, 1.0);
  bank->predict(1.0);
  // S = 16/3 + 1 + 19/3 in x: half the gain of OneStepWorkedByHand.
  EXPECT_NEAR(bank->innovation_covariance_px2(0, {19.0 / 3.0, 0.0, 0.0}).xx, 38.0 / 3.0, 1e-13);
  bank->correct(0, {2.0, 2.0}, {19.0 / 3.0, 0.0, 0.0});
  EXPECT_NEAR(bank->estimate(0).position.x, 16.0 / 19.0, 1e-13);
  EXPECT_NEAR(bank->estimate(0).position.y, 32.0 / 19.0, 1e-13);
}

TEST(KalmanCv, TheVelocityOfAnUnmatchedTrackDecays) {
  KalmanCvOptions options = cv_in_px();
  options.lost_damping_time = 4.0;
  const auto bank = make_filter_bank(options);
  bank->add({0.0, 0.0}, 1.0);
  bank->predict(1.0);
  bank->correct(0, {3.0, 0.0});
  const double velocity = bank->estimate(0).velocity.x;
  bank->predict(1.0);  // not known to be missed yet
  EXPECT_NEAR(bank->estimate(0).velocity.x, velocity, 1e-12);
  for (int missed = 1; missed <= 3; ++missed) {
    bank->predict(1.0);
    EXPECT_NEAR(bank->estimate(0).velocity.x, velocity * std::exp(-0.25 * missed), 1e-12);
  }
}

TEST(KalmanCa, FollowsAnAcceleration) {
  const auto bank = make_filter_bank(KalmanCaOptions{.noise_unit = NoiseUnit::px,
                                                     .acceleration_noise = 0.1,
                                                     .position_noise = 0.1,
                                                     .initial_velocity = 5.0,
                                                     .initial_acceleration = 5.0});
  bank->add({0.0, 0.0}, 1.0);
  for (int i = 1; i <= 60; ++i) {
    bank->predict(0.5);
    const double t = 0.5 * i;
    bank->correct(0, {2.0 * t + 0.75 * t * t, 0.0});
  }
  EXPECT_NEAR(bank->state(0)(4), 1.5, 0.02);
  EXPECT_NEAR(bank->estimate(0).velocity.x, 2.0 + 1.5 * 30.0, 0.1);
}

TEST(KalmanCa, FirstPredictionWorkedByHand) {
  // Per axis P = diag(1, 4, 9), dt = 2: P_xx = 1 + 4 dt^2 + 9 dt^4/4 + q dt^5/20, q = 0.25.
  const auto bank = make_filter_bank(KalmanCaOptions{.noise_unit = NoiseUnit::px,
                                                     .acceleration_noise = 0.5,
                                                     .position_noise = 1.0,
                                                     .initial_velocity = 2.0,
                                                     .initial_acceleration = 3.0});
  bank->add({0.0, 0.0}, 1.0);
  bank->predict(2.0);
  EXPECT_NEAR(bank->estimate(0).covariance_px2.xx, 1.0 + 16.0 + 36.0 + 0.4, 1e-12);
  EXPECT_NEAR(bank->innovation_covariance_px2(0).yy, 54.4, 1e-12);
}

TEST(FilterBank, RefusesOptionsOutOfTheirRanges) {
  KalmanCvOptions options = cv_in_px();
  options.position_noise = 0.0;
  EXPECT_EQ(message_of<ConfigError>([&] { make_filter_bank(options); }),
            "filter.position_noise: 0 is not allowed; expected between 1e-06 and 1000000");
}

}  // namespace
}  // namespace survtrack
