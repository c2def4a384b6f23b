// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "survtrack/filtering/noise_identification.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <cmath>
#include <limits>
#include <vector>

#include "../error_message.hpp"
#include "filtering/simplex_search.hpp"
#include "survtrack/core/errors.hpp"
#include "survtrack/filtering/kalman_filter.hpp"
#include "survtrack/filtering/motion_model.hpp"
#include "survtrack/filtering/random.hpp"

namespace survtrack {
namespace {

/// Tracks drawn from the model itself: noise q per axis of the Order-th derivative, measured with deviation r, every
/// `dt`, now and then one missing. With `length` all is so many times as large.
template <int Order>
std::vector<MeasuredTrack> drawn(std::uint64_t seed, double q, double r, int tracks, int steps, double dt, double length = 1.0) {
  Random random(seed);
  std::vector<MeasuredTrack> found;
  for (int k = 0; k < tracks; ++k) {
    Eigen::Matrix<double, 2 * Order, 1> x = Eigen::Matrix<double, 2 * Order, 1>::Zero();
    for (Eigen::Index i = 2; i < x.size(); ++i) x(i) = (i < 4 ? 3.0 : 0.5) * random.normal();
    MeasuredTrack track;
    double time = 100.0 * k;
    for (int i = 0; i < steps; ++i) {
      const double step = random.uniform() < 0.1 ? 2.0 * dt : dt;
      const auto Q = MotionModel<Order>::unit_noise(step);
      const Eigen::Matrix<double, 2 * Order, 2 * Order> L = Q.llt().matrixL();
      Eigen::Matrix<double, 2 * Order, 1> normal;
      for (double& number : normal) number = random.normal();
      x = (MotionModel<Order>::transition(step) * x + q * L * normal).eval();
      time += step;
      const double noise_x = r * random.normal(), noise_y = r * random.normal();
      track.times.push_back(time);
      track.positions.push_back({length * (x(0) + noise_x), length * (x(1) + noise_y)});
      track.lengths.push_back(length);
    }
    found.push_back(track);
  }
  return found;
}

KalmanCvOptions cv(double q, double r, double v = 3.0) { return {NoiseUnit::px, q, r, v, 2.0}; }

TEST(MeasurementNoise, OfFourPlacesByHand) {
  // About the line x = 1 + t: residuals 0.5, -0.5, -0.5, 0.5 whose sum and slope vanish; degrees 4 - 2.
  const MeasuredTrack track{{0.0, 1.0, 2.0, 3.0}, {{1.5, 5.0}, {1.5, 5.0}, {2.5, 5.0}, {4.5, 5.0}}};
  const MeasurementNoise noise = identify_measurement_noise({track}, NoiseUnit::object_size);
  EXPECT_NEAR(noise.R(0, 0), 0.5, 1e-14);
  EXPECT_NEAR(noise.R(1, 1), 0.0, 1e-14);
  EXPECT_NEAR(noise.R(0, 1), 0.0, 1e-14);
  EXPECT_NEAR(noise.standard_error(0, 0), 0.5, 1e-14);  // sqrt(2 R^2 / 2)
  EXPECT_NEAR(noise.position_noise.value, 0.5, 1e-14);
  EXPECT_EQ(noise.samples, 4);
  EXPECT_EQ(noise.degrees, 2);
}

TEST(MeasurementNoise, IsRecoveredWithinItsErrorUnderDrift) {
  Eigen::Matrix2d truth;
  truth << 4.0, 1.0, 1.0, 2.0;
  const Eigen::Matrix2d L = truth.llt().matrixL();
  double squares = 0.0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    Random random(seed);
    std::vector<MeasuredTrack> still(3);
    for (MeasuredTrack& track : still) {
      for (int i = 0; i < 100; ++i) {
        const double a = random.normal(), b = random.normal();
        const Eigen::Vector2d noise = L * Eigen::Vector2d(a, b);
        track.times.push_back(0.04 * i);
        track.positions.push_back({20.0 * (300.0 + noise(0) + 0.5 * 0.04 * i), 20.0 * (200.0 + noise(1))});
        track.lengths.push_back(20.0);
      }
    }
    const MeasurementNoise found = identify_measurement_noise(still, NoiseUnit::object_size);
    EXPECT_EQ(found.degrees, 294);
    const Eigen::Matrix2d off = (found.R - truth).cwiseQuotient(found.standard_error);
    EXPECT_LT(off.cwiseAbs().maxCoeff(), 4.0) << "seed " << seed;
    squares += off(0, 0) * off(0, 0) + off(0, 1) * off(0, 1) + off(1, 1) * off(1, 1);
    const NoiseEstimate& r = found.position_noise;
    EXPECT_LT(std::abs(r.value - std::sqrt(3.0)), 4.0 * r.standard_error);
    EXPECT_NEAR(identify_measurement_noise(still, NoiseUnit::px).position_noise.value, 20.0 * r.value, 1e-9);
  }
  EXPECT_NEAR(squares / 120.0, 1.0, 0.35);  // the errors are as large as they are said to be
}

TEST(FilterConsistency, IsThatOfTheGeneralFilter) {
  const std::vector<MeasuredTrack> tracks = drawn<2>(5, 0.8, 1.5, 2, 40, 0.5);
  using Filter = KalmanFilter<4, 2>;
  Filter::Model model;
  model.H.setIdentity();
  model.R = 2.25 * Eigen::Matrix2d::Identity();
  double log_likelihood = 0.0, nis = 0.0;
  for (const MeasuredTrack& track : tracks) {
    model.F = model.Q = Filter::StateMatrix::Identity();
    const Point& first = track.positions.front();
    Filter filter(model, {first.x, first.y, 0.0, 0.0}, Eigen::Vector4d(2.25, 2.25, 9.0, 9.0).asDiagonal());
    for (std::size_t i = 1; i < track.times.size(); ++i) {
      const double dt = track.times[i] - track.times[i - 1];
      filter.set_F(ConstantVelocity::transition(dt));
      filter.set_Q(0.64 * ConstantVelocity::unit_noise(dt));
      filter.predict();
      filter.update({track.positions[i].x, track.positions[i].y});
      log_likelihood += filter.last().log_likelihood();
      nis += filter.last().nis;
    }
  }
  const FilterConsistency found = filter_consistency(tracks, cv(0.8, 1.5));
  EXPECT_EQ(found.steps, 78);
  EXPECT_NEAR(found.log_likelihood, log_likelihood, 1e-9);
  EXPECT_NEAR(found.nis_mean, nis / 78.0, 1e-11);
  EXPECT_NEAR(found.nis_band.first, 1.58, 0.02);
  EXPECT_NEAR(found.correlation_limit, 1.96 / std::sqrt(152.0), 1e-4);
  // Filters of their own: the lengths of the tracks are the unit, so that all scales with them.
  const auto large = drawn<2>(5, 0.8, 1.5, 2, 40, 0.5, 30.0);
  KalmanCvOptions relative = cv(0.8, 1.5);
  relative.noise_unit = NoiseUnit::object_size;
  EXPECT_NEAR(filter_consistency(large, relative).nis_mean, found.nis_mean, 1e-9);
}

TEST(FilterConsistency, TellsWhatIsWrong) {
  const std::vector<MeasuredTrack> tracks = drawn<2>(9, 1.0, 1.0, 10, 200, 0.5);
  const FilterConsistency right = filter_consistency(tracks, cv(1.0, 1.0));
  EXPECT_GT(right.nis_mean, right.nis_band.first);
  EXPECT_LT(right.nis_mean, right.nis_band.second);
  EXPECT_LT(std::abs(right.correlation), 1.5 * right.correlation_limit);
  const FilterConsistency stiff = filter_consistency(tracks, cv(0.1, 1.0));
  EXPECT_GT(stiff.nis_mean, stiff.nis_band.second);
  EXPECT_GT(stiff.correlation, 5.0 * stiff.correlation_limit);
  const FilterConsistency loose = filter_consistency(tracks, cv(10.0, 1.0));
  EXPECT_LT(loose.nis_mean, loose.nis_band.first);
  EXPECT_LT(loose.correlation, -5.0 * loose.correlation_limit);
  EXPECT_LT(stiff.log_likelihood, right.log_likelihood);
  EXPECT_LT(loose.log_likelihood, right.log_likelihood);
}

template <int Order>
void expect_recovered(const TunableOptions& start, double q, double r, bool fit_position_noise) {
  double squares = 0.0;
  int numbers = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const auto tracks = drawn<Order>(seed, q, r, 8, 100, 0.4);
    const ProcessNoise found = identify_process_noise(tracks, start, fit_position_noise);
    const auto expect_near = [&](const NoiseEstimate& estimate, double truth) {
      const double off = (estimate.value - truth) / estimate.standard_error;
      EXPECT_LT(std::abs(off), 4.0) << "seed " << seed << ": " << estimate.value << " +- " << estimate.standard_error;
      EXPECT_LT(estimate.standard_error, 0.25 * truth);
      squares += off * off;
      ++numbers;
    };
    expect_near(found.process_noise, q);
    if (fit_position_noise) expect_near(found.position_noise, r);
    EXPECT_EQ(found.position_noise.standard_error > 0.0, fit_position_noise);
    EXPECT_NEAR(found.initial_velocity.value, 3.0, 2.0);
    EXPECT_GT(found.after.log_likelihood, found.before.log_likelihood);
    EXPECT_GE(found.after.nis_mean, found.after.nis_band.first);
    EXPECT_LE(found.after.nis_mean, found.after.nis_band.second);
    EXPECT_LT(std::abs(found.after.correlation), 2.0 * found.after.correlation_limit);
    EXPECT_EQ(filter_consistency(tracks, found.options).log_likelihood, found.after.log_likelihood);
  }
  // Standard errors are neither too small nor too large: the mean square of as many normal numbers.
  EXPECT_GT(squares / numbers, 0.4);
  EXPECT_LT(squares / numbers, 1.9);
}

TEST(ProcessNoise, OfConstantVelocityIsRecovered) {
  expect_recovered<2>(cv(0.05, 30.0, 0.1), 0.8, 1.5, true);
  expect_recovered<2>(cv(20.0, 1.5, 50.0), 0.8, 1.5, false);
}

TEST(ProcessNoise, OfConstantAccelerationIsRecovered) {
  KalmanCaOptions start;
  start.noise_unit = NoiseUnit::px;
  expect_recovered<3>(start, 0.5, 1.0, true);
}

TEST(ProcessNoise, IsWhereTheLikelihoodIsLargest) {
  const auto tracks = drawn<2>(3, 0.8, 1.5, 4, 60, 0.5);
  const ProcessNoise found = identify_process_noise(tracks, cv(1.0, 1.0));
  const auto best = std::get<KalmanCvOptions>(found.options);
  for (const double part : {0.97, 1.03}) {
    for (double KalmanCvOptions::*noise :
         {&KalmanCvOptions::velocity_noise, &KalmanCvOptions::position_noise, &KalmanCvOptions::initial_velocity}) {
      KalmanCvOptions other = best;
      other.*noise *= part;
      EXPECT_LT(filter_consistency(tracks, other).log_likelihood, found.after.log_likelihood);
    }
  }
  EXPECT_EQ(best.noise_unit, NoiseUnit::px);
  EXPECT_EQ(best.lost_damping_time, 2.0);
}

TEST(ProcessNoise, SaysWhatTheDataDoNotDetermine) {
  // Straight and steady: any small process noise explains it.
  const ProcessNoise found = identify_process_noise(drawn<2>(2, 0.0, 1.0, 5, 40, 1.0), cv(1.0, 1.0));
  EXPECT_LT(found.process_noise.value, 0.05);
  EXPECT_GT(found.process_noise.standard_error, found.process_noise.value);
  EXPECT_NEAR(found.position_noise.value, 1.0, 0.15);
  // Without any noise at all they end at the bounds, and are finite.
  MeasuredTrack exact;
  for (int i = 0; i < 30; ++i) {
    exact.times.push_back(i);
    exact.positions.push_back({2.0 * i, 5.0});
  }
  const ProcessNoise none = identify_process_noise({exact}, cv(1.0, 1.0));
  EXPECT_GE(none.process_noise.value, 1e-6);
  EXPECT_GE(none.position_noise.value, 1e-6);
  EXPECT_TRUE(std::isfinite(none.after.log_likelihood));
  EXPECT_TRUE(std::isinf(none.process_noise.standard_error));
}

TEST(NoiseIdentification, RefusesByName) {
  const auto tracks = drawn<2>(1, 1.0, 1.0, 2, 10, 1.0);
  const auto told = [&](std::vector<MeasuredTrack> bad) {
    return message_of<InputError>([&] { identify_process_noise(bad, cv(1.0, 1.0)); });
  };
  EXPECT_EQ(told({}), "tracks: there are none; expected at least one");
  auto bad = tracks;
  bad[1].times[4] = bad[1].times[3];
  EXPECT_TRUE(contains(told(bad), "tracks[1].times[4]: ", "expected a time 1e-9 to 1e6 after the one before"));
  bad = tracks;
  bad[0].positions[2].y = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(contains(told(bad), "tracks[0].positions[2]: (", "nan) is not allowed"));
  bad = tracks;
  bad[0].lengths[2] = 0.0;
  EXPECT_TRUE(contains(told(bad), "tracks[0].lengths[2]: 0 is not allowed"));
  bad = tracks;
  bad[0].lengths.pop_back();
  EXPECT_TRUE(contains(told(bad), "tracks[0].lengths: 9 values is not allowed; expected 10"));
  bad = {tracks[0]};
  EXPECT_TRUE(contains(told(bad), "tracks: have 9 steps from one measurement to the next; expected 10 to 500000"));
  EXPECT_TRUE(contains(message_of<ConfigError>([&] { filter_consistency(tracks, cv(-1.0, 1.0)); }), "velocity_noise: -1"));
  EXPECT_TRUE(contains(message_of<InputError>([&] { identify_measurement_noise({{{0.0, 1.0}, {{}, {}}}}, NoiseUnit::px); }),
                       "tracks[0]: 2 measurements is not allowed; expected at least 3"));
}

TEST(MeasuredTrack, StandsStill) {
  MeasuredTrack track;
  for (int i = 0; i < 50; ++i) {
    track.times.push_back(0.1 * i);
    track.positions.push_back({100.0 + (i % 2), 50.0 + 0.02 * i});  // 0.2 px a unit
    track.lengths.push_back(10.0);
  }
  EXPECT_TRUE(stands_still(track));
  EXPECT_FALSE(stands_still(track, 0.01));
  EXPECT_FALSE(stands_still(track, 0.05, 0.09));
  EXPECT_TRUE(stands_still(track, 0.05, 0.11));
  track.lengths.clear();
  EXPECT_FALSE(stands_still(track));
  EXPECT_TRUE(contains(message_of<InputError>([&] { stands_still(track, -1.0); }), "max_speed: -1"));
  EXPECT_TRUE(contains(message_of<InputError>([&] { stands_still({}); }), "track: 0 measurements"));
}

TEST(SimplexSearch, FindsTheBottomOfRosenbrocksValley) {
  const auto valley = [](const Eigen::VectorXd& x) {
    const double a = 1.0 - x(0), b = x(1) - x(0) * x(0);
    return x(0) > 3.0 ? std::numeric_limits<double>::infinity() : a * a + 100.0 * b * b;
  };
  const Eigen::VectorXd found = lowest_place(valley, Eigen::Vector2d(-1.2, 1.0), 0.7);
  EXPECT_NEAR(found(0), 1.0, 1e-3);
  EXPECT_NEAR(found(1), 1.0, 1e-3);
}

}  // namespace
}  // namespace survtrack
