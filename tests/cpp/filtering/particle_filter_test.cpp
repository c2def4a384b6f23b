// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "survtrack/filtering/particle_filter.hpp"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "../error_message.hpp"
#include "survtrack/core/errors.hpp"
#include "survtrack/filtering/kalman_filter.hpp"
#include "survtrack/filtering/rts_smoother.hpp"

namespace survtrack {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using One = Eigen::Matrix<double, 1, 1>;

TEST(Random, FirstNumbersOfXoshiro) {
  // Of splitmix64 from 0, as its authors' program prints them; the first output is of the words 0 and 3.
  Random random(0);
  EXPECT_EQ(random.state().words[0], 0xe220a8397b1dcdafU);
  EXPECT_EQ(random.state().words[1], 0x6e789e6aa1b965f4U);
  const auto s = random.state().words;
  const std::uint64_t sum = s[0] + s[3];
  EXPECT_EQ(random.bits(), ((sum << 23) | (sum >> 41)) + s[0]);
}

TEST(Random, NormalNumbersAreNormal) {
  Random random(3);
  double sum = 0.0, square = 0.0, fourth = 0.0, beyond = 0.0;
  constexpr int count = 200000;
  for (int i = 0; i < count; ++i) {
    const double n = random.normal();
    sum += n;
    square += n * n;
    fourth += n * n * n * n;
    beyond += std::abs(n) > 1.959964 ? 1.0 : 0.0;
  }
  EXPECT_NEAR(sum / count, 0.0, 0.01);
  EXPECT_NEAR(square / count, 1.0, 0.015);
  EXPECT_NEAR(fourth / count, 3.0, 0.1);
  EXPECT_NEAR(beyond / count, 0.05, 0.002);
}

TEST(ParticleFilter, SystematicResamplingDrawsEachItsShare) {
  VectorXd weights(5);
  weights << 0.0, 0.5, 0.1, 0.4, 0.0;
  EXPECT_EQ(systematic_resample(weights, 0.0), (std::vector<int>{1, 1, 1, 3, 3}));
  EXPECT_EQ(systematic_resample(weights, 0.6), (std::vector<int>{1, 1, 2, 3, 3}));
  for (double offset = 0.0; offset < 1.0; offset += 0.05) {
    const std::vector<int> chosen = systematic_resample(weights, offset);
    for (int i = 0; i < 5; ++i) {
      const auto times = static_cast<double>(std::count(chosen.begin(), chosen.end(), i));
      EXPECT_GE(times, std::floor(5.0 * weights(i) - 1e-9));
      EXPECT_LE(times, std::ceil(5.0 * weights(i) + 1e-9));
    }
  }
  EXPECT_THROW(systematic_resample(VectorXd::Zero(3), 0.5), InputError);
  EXPECT_THROW(systematic_resample(weights, 1.0), InputError);
}

ParticleFilter<>::Model walk() {
  return {[](const MatrixXd& particles, const VectorXd& u) { return MatrixXd(particles.array() + (u.size() ? u(0) : 0.0)); },
          [](const VectorXd& z, const MatrixXd& particles) {
            return VectorXd(-0.5 * (z(0) - particles.row(0).transpose().array()).square());
          },
          MatrixXd::Constant(1, 1, 0.5)};
}

TEST(ParticleFilter, ComesNearTheKalmanFilterOfALinearModel) {
  ParticleFilter<> particles(walk(), One(0.0), One(4.0), {20000, 0.5, 7});
  KalmanFilter<1, 1> exact({One(1.0), One(1.0), One(0.5), One(1.0), One(1.0), {}}, One(0.0), One(4.0));
  double sum = 0.0, exact_sum = 0.0;
  for (int k = 1; k <= 30; ++k) {
    const One z(2.0 * k + std::sin(3.0 * k));
    particles.predict(One(2.0));
    exact.predict(One(2.0));
    particles.update(z);
    exact.update(z);
    EXPECT_NEAR(particles.x()(0), exact.x()(0), 0.05);
    EXPECT_NEAR(particles.P()(0, 0), exact.P()(0, 0), 0.05);
    // The callable leaves out the constant of the density.
    sum += particles.log_likelihood() - 0.5 * std::log(2.0 * 3.141592653589793);
    exact_sum += exact.last().log_likelihood();
  }
  EXPECT_NEAR(sum, exact_sum, 0.5);
  EXPECT_GT(particles.resamplings(), 3);
  EXPECT_LT(particles.resamplings(), 30);
}

TEST(ParticleFilter, TheSeedDecides) {
  const auto end = [](std::uint64_t seed) {
    ParticleFilter<> filter(walk(), One(0.0), One(4.0), {100, 0.5, seed});
    filter.predict();
    filter.update(One(1.0));
    filter.predict();
    return filter.particles();
  };
  EXPECT_EQ(end(5), end(5));
  EXPECT_NE(end(5), end(6));
}

TEST(ParticleFilter, SaysWhatIsWrongAndStaysAsItWas) {
  ParticleFilter<>::Model model = walk();
  double likelihood = -std::numeric_limits<double>::infinity();
  model.log_likelihood = [&](const VectorXd&, const MatrixXd&) { return VectorXd::Constant(50, likelihood).eval(); };
  ParticleFilter<> filter(model, One(0.0), One(1.0), {50, 0.5, 1});
  const VectorXd weights = filter.weights();
  EXPECT_TRUE(contains(message_of<InputError>([&] { filter.update(One(0.0)); }), "impossible for every particle"));
  likelihood = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(contains(message_of<InputError>([&] { filter.update(One(0.0)); }), "log_likelihood[0]: is nan"));
  EXPECT_TRUE(contains(message_of<InputError>([&] { filter.update(One(likelihood)); }), "z[0]: is nan"));
  EXPECT_EQ(filter.weights(), weights);
  EXPECT_THROW(ParticleFilter<>(walk(), One(0.0), One(-1.0), {}), InputError);
  EXPECT_THROW(ParticleFilter<>(walk(), One(0.0), One(1.0), {0, 0.5, 1}), InputError);
  EXPECT_THROW(ParticleFilter<>(walk(), One(0.0), One(1.0), {10, 1.5, 1}), InputError);
}

TEST(RtsSmoother, IsTheLeastSquaresSolutionOfTheWholeRun) {
  // A walk x_k = x_{k-1} + 1 + noise, from N(0, 4), measured with R = 1: the mode of the joint density of all states.
  constexpr int steps = 12;
  KalmanFilter<1, 1> filter({One(1.0), One(1.0), One(0.5), One(1.0), One(1.0), {}}, One(0.0), One(4.0));
  FilteredRun<> run;
  run.F = {One(1.0)};
  run.Q = {One(0.5)};
  run.Bu = {One(1.0)};
  MatrixXd A = MatrixXd::Zero(steps, steps);
  VectorXd b = VectorXd::Zero(steps);
  A(0, 0) += 1.0 / 4.0;
  for (int k = 0; k < steps; ++k) {
    const double z = k + std::cos(2.0 * k);
    if (k > 0) {
      filter.predict(One(1.0));
      A.block<2, 2>(k - 1, k - 1) += 2.0 * (Eigen::Matrix2d() << 1.0, -1.0, -1.0, 1.0).finished();
      b(k - 1) -= 2.0;
      b(k) += 2.0;
    }
    filter.update(One(z));
    A(k, k) += 1.0;
    b(k) += z;
    run.x.emplace_back(filter.x());
    run.P.emplace_back(filter.P());
  }
  FilteredRun<1> fixed{{}, {}, {One(1.0)}, {One(0.5)}, {One(1.0)}};
  for (int k = 0; k < steps; ++k) {
    fixed.x.emplace_back(run.x[static_cast<std::size_t>(k)]);
    fixed.P.emplace_back(run.P[static_cast<std::size_t>(k)]);
  }
  const SmoothedRun<> smoothed = rts_smooth(run);
  const SmoothedRun<1> smoothed_fixed = rts_smooth(fixed);
  const MatrixXd covariance = A.inverse();
  const VectorXd x = covariance * b;
  for (int k = 0; k < steps; ++k) {
    EXPECT_NEAR(smoothed.x[static_cast<std::size_t>(k)](0), x(k), 1e-12);
    EXPECT_NEAR(smoothed.P[static_cast<std::size_t>(k)](0, 0), covariance(k, k), 1e-12);
    EXPECT_NEAR(smoothed_fixed.x[static_cast<std::size_t>(k)](0), x(k), 1e-12);
    EXPECT_NEAR(smoothed_fixed.P[static_cast<std::size_t>(k)](0, 0), covariance(k, k), 1e-12);
  }
  run.Q = {One(0.5), One(0.5)};
  EXPECT_TRUE(contains(message_of<InputError>([&] { rts_smooth(run); }), "Q: has 2 steps; expected 12"));
  run.Q = {One(-0.5)};
  EXPECT_TRUE(contains(message_of<InputError>([&] { rts_smooth(run); }), "Q[0]: ", "is -0.5"));
}

TEST(ParticleFilter, OfFixedSizeIsTheDynamicOne) {
  using Fixed = ParticleFilter<2>;
  const Eigen::Matrix2d Q = Eigen::Vector2d(0.3, 0.1).asDiagonal();
  const auto near = [](const Eigen::VectorXd& z, const Eigen::MatrixXd& particles) {
    return Eigen::VectorXd(-0.5 * (particles.row(0).array() - z(0)).square().transpose());
  };
  Fixed fixed({[](const Fixed::Particles& p, const Eigen::VectorXd&) { return Fixed::Particles(0.9 * p); },
               [&](const Eigen::VectorXd& z, const Fixed::Particles& p) { return near(z, p); }, Q},
              Eigen::Vector2d(1.0, 2.0), Eigen::Matrix2d::Identity(), {200, 0.5, 3});
  ParticleFilter<> dynamic({[](const Eigen::MatrixXd& p, const Eigen::VectorXd&) { return Eigen::MatrixXd(0.9 * p); }, near, Q},
                           Eigen::Vector2d(1.0, 2.0), Eigen::Matrix2d::Identity(), {200, 0.5, 3});
  for (int k = 0; k < 30; ++k) {
    fixed.predict();
    dynamic.predict();
    fixed.update(Eigen::VectorXd::Constant(1, 0.1 * k));
    dynamic.update(Eigen::VectorXd::Constant(1, 0.1 * k));
    EXPECT_LT((fixed.x() - dynamic.x()).norm(), 1e-9) << k;
    EXPECT_LT((fixed.P() - dynamic.P()).norm(), 1e-9) << k;
  }
  EXPECT_GT(fixed.resamplings(), 3);
  EXPECT_EQ(fixed.resamplings(), dynamic.resamplings());
}

}  // namespace
}  // namespace survtrack
