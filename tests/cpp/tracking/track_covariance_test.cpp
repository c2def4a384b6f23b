// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

// A track's covariances are its filter's, in seconds whatever the config's time unit.

#include <gtest/gtest.h>

#include <Eigen/Core>

#include "box_run.hpp"
#include "survtrack/filtering/kalman_filter.hpp"
#include "survtrack/filtering/motion_model.hpp"

namespace survtrack {
namespace {

TEST(TrackCovariance, IsTheReferenceFiltersInSeconds) {
  constexpr double unit_s = 0.5, period_s = 0.2;
  Config config;
  config.set("time_unit_s=0.5");
  config.set("filter.noise_unit=px");
  config.set("filter.velocity_noise=3");
  config.set("filter.position_noise=2");
  config.set("filter.initial_velocity=5");
  BoxRun run(config, period_s);
  using Reference = KalmanFilter<4, 2>;
  const double density = 9.0 / (unit_s * unit_s * unit_s);
  Reference::Model model;
  model.F = ConstantVelocity::transition(period_s);
  model.H = Eigen::MatrixXd::Identity(2, 4);
  model.Q = density * ConstantVelocity::unit_noise(period_s);
  model.R = 4.0 * Eigen::Matrix2d::Identity();
  Reference reference(model, Eigen::Vector4d::Zero(), Eigen::Vector4d(4.0, 4.0, 100.0, 100.0).asDiagonal().toDenseMatrix());
  for (int k = 0; k < 25; ++k) {
    const bool seen = k != 24;  // the first step without a detection is not damped yet
    const Box box = Box::around({100.0 + 4.0 * k, 80.0 + k}, 20.0, 30.0);
    const TrackingResult& result = seen ? run.frame({box}) : run.frame({});
    if (k > 0) reference.predict();
    if (k > 0 && seen) reference.update({100.0 + 4.0 * k, 80.0 + k});
    const Track& track = result.tracks.empty() ? result.tentative.at(0) : result.tracks.at(0);
    const Eigen::Matrix4d P = reference.P();
    EXPECT_NEAR(track.position_covariance_px2.xx, P(0, 0), 1e-9) << k;
    EXPECT_NEAR(track.velocity_covariance_px2_per_s2.xx, P(2, 2), 1e-8) << k;
    EXPECT_NEAR(track.velocity_covariance_px2_per_s2.xy, P(2, 3), 1e-9) << k;
    EXPECT_NEAR(track.velocity_covariance_px2_per_s2.yy, P(3, 3), 1e-8) << k;
    EXPECT_NEAR(track.position_velocity_covariance_px2_per_s.xx, P(0, 2), 1e-8) << k;
    EXPECT_NEAR(track.position_velocity_covariance_px2_per_s.xy, P(0, 3), 1e-9) << k;
    EXPECT_NEAR(track.position_velocity_covariance_px2_per_s.yx, P(1, 2), 1e-9) << k;
    EXPECT_NEAR(track.position_velocity_covariance_px2_per_s.yy, P(1, 3), 1e-8) << k;
    EXPECT_NEAR(track.velocity_noise_px2_per_s3.xx, density, 1e-9) << k;
    EXPECT_EQ(track.velocity_noise_px2_per_s3.xy, 0.0) << k;
  }
}

TEST(TrackCovariance, TheNoiseGoesWithTheObjectsSize) {
  BoxRun run(Config{});
  for (int k = 0; k < 20; ++k) {
    run.frame({Box::around({50.0 + 4.0 * k, 50.0}, 16.0, 25.0), Box::around({50.0 + 4.0 * k, 250.0}, 32.0, 50.0)});
  }
  ASSERT_EQ(run.result().tracks.size(), 2U);
  const Track &small = run.result().tracks[0], &large = run.result().tracks[1];
  const double velocity_noise = std::get<KalmanCvOptions>(Config{}.filter).velocity_noise * 20.0;
  EXPECT_NEAR(small.velocity_noise_px2_per_s3.yy, velocity_noise * velocity_noise, 1e-9);
  EXPECT_NEAR(large.velocity_noise_px2_per_s3.yy, 4.0 * small.velocity_noise_px2_per_s3.yy, 1e-9);
}

}  // namespace
}  // namespace survtrack
