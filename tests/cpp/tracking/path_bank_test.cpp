// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "survtrack/tracking/path_bank.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <string>

#include "../error_message.hpp"
#include "some_paths.hpp"

namespace survtrack {
namespace {

Paths paths_of(const Path& path) {
  Paths paths;
  paths.add("only", path);
  return paths;
}

Paths ring(double radius = 100.0) { return paths_of(Path(circle(36, radius), true, PathKind::curve)); }

PathBank bank_on(const Paths& paths, const KalmanPathOptions& options = {}) {
  PathBank bank(options);
  bank.set_paths(paths);
  return bank;
}

Point on_circle(double radius, double angle) { return {radius * std::cos(angle), radius * std::sin(angle)}; }

TEST(PathBank, OnAStraightPathItIsTheFilterInTheImage) {
  KalmanPathOptions along;
  along.process_variances = {1.0, 2.0, 3.0, 4.0};
  along.measurement_variances = {5.0, 6.0};
  along.initial_variances = {7.0, 8.0, 9.0, 10.0};
  KalmanDiscreteOptions plain;
  plain.process_variances = along.process_variances;
  plain.measurement_covariance = {5.0, 0.0, 6.0};
  plain.initial_variances = along.initial_variances;
  const auto other = make_filter_bank(plain);
  PathBank bank = bank_on(paths_of(Path({{0.0, 0.0}, {300.0, 0.0}})), along);
  bank.add({10.0, 5.0}, 20.0);
  other->add({10.0, 5.0}, 20.0);
  for (int k = 1; k < 30; ++k) {
    const double dt = k % 4 == 0 ? 2.0 : 1.0;
    bank.predict(dt);
    other->predict(dt);
    const Point z{10.0 + 4.0 * k, 5.0 + k % 3};
    const Point off = bank.innovation(0, z), expected = other->innovation(0, z);
    EXPECT_NEAR(off.x, expected.x, 1e-9);
    EXPECT_NEAR(off.y, expected.y, 1e-9);
    EXPECT_NEAR(bank.innovation_covariance_px2(0).yy, other->innovation_covariance_px2(0).yy, 1e-9);
    if (k % 5 == 0) continue;
    const Symmetric2 extra{k % 2 == 0 ? 30.0 : 0.0, 0.0, 0.0};
    bank.correct(0, z, extra);
    other->correct(0, z, extra);
    ASSERT_LT((bank.state(0) - other->state(0)).cwiseAbs().maxCoeff(), 1e-9) << k;
    ASSERT_LT((bank.state_covariance(0) - other->state_covariance(0)).cwiseAbs().maxCoeff(), 1e-9) << k;
  }
}

TEST(PathBank, FindsTheSpeedRoundACircleWhateverTheLap) {
  PathBank bank = bank_on(ring());
  const double speed = 0.2;  // radians a frame
  bank.add(on_circle(100.0, 0.0), 20.0);
  const double length = bank.paths().items().front().path.length_px();
  for (int k = 1; k <= 320; ++k) {  // ten laps
    bank.predict(1.0);
    const Point z = on_circle(100.0, speed * k);
    if (k > 20) {
      EXPECT_LT(distance(bank.predicted_position(0), z), 0.5) << k;
      EXPECT_NEAR(bank.state(0)(2), speed * length / (2.0 * M_PI), 0.1) << k;
    }
    bank.correct(0, z);
    EXPECT_GE(bank.state(0)(0), 0.0);
    EXPECT_LT(bank.state(0)(0), length);
  }
}

TEST(PathBank, VelocityInTheImageIsTheObjects) {
  for (const double radius : {70.0, 130.0}) {
    PathBank bank = bank_on(ring());
    for (int k = 0; k <= 60; ++k) {
      const Point z = on_circle(radius, 0.1 * k);
      if (k == 0) {
        bank.add(z, 20.0);
        continue;
      }
      bank.predict(1.0);
      bank.correct(0, z);
    }
    // In the inner lane S grows faster than the object goes.
    const Point v = bank.estimate(0).velocity;
    EXPECT_NEAR(std::hypot(v.x, v.y), 0.1 * radius, 0.3) << radius;
    const Point ahead = on_circle(1.0, 6.0 + 0.5 * M_PI);
    EXPECT_NEAR(v.x * ahead.x + v.y * ahead.y, 0.1 * radius, 0.3) << radius;
  }
}

TEST(PathBank, TheCovarianceIsTurnedWithThePath) {
  KalmanPathOptions o;
  o.initial_variances = {50.0, 2.0, 0.0, 0.0};
  const double half = std::sqrt(0.5);
  PathBank bank = bank_on(paths_of(Path({{0.0, 0.0}, {100.0 * half, 100.0 * half}})), o);
  bank.add({30.0, 30.0}, 20.0);
  const Symmetric2 P = bank.estimate(0).covariance_px2;
  EXPECT_NEAR(P.xx, 26.0, 1e-9);
  EXPECT_NEAR(P.xy, 24.0, 1e-9);
  EXPECT_NEAR(P.yy, 26.0, 1e-9);
  EXPECT_NEAR(bank.innovation_covariance_px2(0).xx, 30.0, 1e-9);
}

TEST(PathBank, WhatIsKnownOfTheVelocityIsTurnedToo) {
  KalmanPathOptions o;
  o.process_variances = {0.0, 0.0, 6.0, 1.0};
  o.initial_variances = {50.0, 2.0, 20.0, 4.0};
  o.step_time = 2.0;
  const double half = std::sqrt(0.5);
  PathBank bank = bank_on(paths_of(Path({{0.0, 0.0}, {100.0 * half, 100.0 * half}})), o);
  bank.add({30.0, 30.0}, 20.0);
  const Estimate start = bank.estimate(0);
  EXPECT_NEAR(start.velocity_covariance.xx, 12.0, 1e-9);
  EXPECT_NEAR(start.velocity_covariance.xy, 8.0, 1e-9);
  EXPECT_NEAR(start.velocity_covariance.yy, 12.0, 1e-9);
  EXPECT_NEAR(start.cross_covariance.xx, 0.0, 1e-9);
  EXPECT_NEAR(start.velocity_noise.xx, 1.75, 1e-9);
  EXPECT_NEAR(start.velocity_noise.xy, 1.25, 1e-9);
  bank.predict(2.0);  // one step: C = 2 V
  const Estimate later = bank.estimate(0);
  EXPECT_NEAR(later.covariance_px2.xy, 24.0 + 4.0 * 8.0, 1e-9);
  EXPECT_NEAR(later.velocity_covariance.xx, 12.0 + 3.5, 1e-9);
  EXPECT_NEAR(later.cross_covariance.xx, 24.0, 1e-9);
  EXPECT_NEAR(later.cross_covariance.xy, 16.0, 1e-9);
  EXPECT_NEAR(later.cross_covariance.yx, 16.0, 1e-9);
}

TEST(PathBank, WhatIsUnmeasuredInTheImageIsTurnedToo) {
  // On a path that goes down x is across it.
  PathBank bank = bank_on(paths_of(Path({{0.0, 0.0}, {0.0, 300.0}})));
  bank.add({0.0, 100.0}, 20.0);
  bank.predict(1.0);
  bank.correct(0, {8.0, 110.0}, {1e12, 0.0, 0.0});
  EXPECT_NEAR(bank.state(0)(1), 0.0, 1e-3);
  EXPECT_GT(bank.state(0)(0), 105.0);
  EXPECT_TRUE(bank.state_covariance(0).allFinite());
  EXPECT_GT(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(bank.state_covariance(0)).eigenvalues().minCoeff(), 0.0);
}

TEST(PathBank, TakesTheNearestPathAndNothingFarOffAll) {
  Paths paths;
  paths.add("upper", Path({{0.0, 50.0}, {300.0, 50.0}}, false, PathKind::line, 30.0));
  paths.add("lower", Path({{0.0, 100.0}, {300.0, 100.0}}, false, PathKind::line, 30.0));
  PathBank bank = bank_on(paths);
  bank.add({10.0, 60.0}, 20.0);
  bank.add({10.0, 80.0}, 20.0);
  EXPECT_EQ(bank.path_state(0)->path, &bank.paths().items()[0].path);
  EXPECT_EQ(bank.path_state(1)->path, &bank.paths().items()[1].path);
  EXPECT_EQ(bank.state(1)(1), -20.0);
  EXPECT_TRUE(bank.accepts({150.0, 21.0}));
  for (const Point& far : {Point{150.0, 19.0}, Point{150.0, 131.0}, Point{-31.0, 50.0}, Point{1e9, 50.0}}) {
    EXPECT_FALSE(bank.accepts(far));
    EXPECT_THROW(bank.add(far, 20.0), InputError);
  }
  EXPECT_EQ(bank.size(), 2);
  // One that is there already may be led farther off.
  bank.predict(1.0);
  bank.correct(0, {20.0, 5.0});
  EXPECT_LT(bank.state(0)(1), -10.0);
}

TEST(PathBank, PathStateHasThePlaceBeforeThePrediction) {
  PathBank bank = bank_on(ring());
  bank.add(on_circle(100.0, 1.0), 20.0);
  for (int k = 1; k < 10; ++k) {
    bank.predict(1.0);
    bank.correct(0, on_circle(100.0, 1.0 + 0.1 * k));
  }
  const PathPosition before = bank.path_state(0)->predicted;
  bank.predict(1.0);
  const PathState now = *bank.path_state(0);
  EXPECT_EQ(now.place_before, before);
  EXPECT_NEAR(now.path->residual(now.predicted.s_px, before.s_px), 10.0, 0.2);
  EXPECT_EQ(now.predicted, (PathPosition{bank.state(0)(0), bank.state(0)(1)}));
  EXPECT_EQ(now.velocity, (PathPosition{bank.state(0)(2), bank.state(0)(3)}));
  EXPECT_EQ(now.covariance_px2.xx, bank.state_covariance(0)(0, 0));
  EXPECT_EQ(make_filter_bank(KalmanCvOptions{})->path_state(0), std::nullopt);
}

TEST(PathBank, NumbersAreInTheUnitOfLength) {
  KalmanPathOptions one, tenth;
  one.initial_velocity = {77.0, 0.3};
  tenth = one;
  tenth.unit_px = 0.1;
  for (double& v : tenth.process_variances) v *= 100.0;
  for (double& v : tenth.measurement_variances) v *= 100.0;
  for (double& v : tenth.initial_variances) v *= 100.0;
  for (double& v : tenth.initial_velocity) v *= 10.0;
  PathBank a = bank_on(ring(), one), b = bank_on(ring(), tenth);
  for (PathBank* bank : {&a, &b}) {
    bank->add(on_circle(100.0, 1.0), 20.0);
    EXPECT_NEAR(bank->state(0)(2), 77.0, 1e-9);
    bank->predict(1.0);
    bank->correct(0, on_circle(100.0, 1.7));
  }
  EXPECT_TRUE(a.state(0).isApprox(b.state(0), 1e-12));
  EXPECT_TRUE(a.state_covariance(0).isApprox(b.state_covariance(0), 1e-12));
}

TEST(PathBank, PredictedForEverItStaysFinite) {
  const Paths open = paths_of(Path({{0.0, 0.0}, {50.0, 80.0}, {100.0, 0.0}}, false, PathKind::curve));
  for (const Paths& paths : {open, ring(20.0)}) {
    KalmanPathOptions wild;
    wild.process_variances = {1e12, 1e12, 1e12, 1e12};
    wild.measurement_variances = {1e-12, 1e12};
    PathBank bank = bank_on(paths, wild);
    bank.add({10.0, 10.0}, 5.0);
    for (int k = 0; k < 20; ++k) {
      bank.predict(k % 2 == 0 ? 1e-6 : 1e9);
      const Estimate now = bank.estimate(0);
      const Symmetric2 S = bank.innovation_covariance_px2(0);
      EXPECT_TRUE(std::isfinite(now.position.x) && std::isfinite(now.velocity.y) && std::isfinite(now.covariance_px2.xy));
      EXPECT_GT(S.xx * S.yy - S.xy * S.xy, 0.0) << k;
      if (k % 3 == 0) bank.correct(0, {1e9 * k, -5.0}, {1e12, 0.0, 0.0});
    }
  }
}

TEST(PathBank, PathsAreAskedFor) {
  PathBank bank{KalmanPathOptions{}};
  EXPECT_EQ(message_of<InputError>([&] { bank.check_frame_size(0, 0); }),
            "filter.model: \"kalman_path\" has no paths; expected load_paths() before the first frame, or --path FILE on the "
            "command line");
  EXPECT_TRUE(contains(message_of<InputError>([&] { bank.set_paths({}); }), "paths: has none"));
  Paths paths = ring();
  paths.frame_width = 640;
  paths.frame_height = 480;
  bank.set_paths(paths);
  EXPECT_NO_THROW(bank.check_frame_size(0, 0));
  EXPECT_NO_THROW(bank.check_frame_size(640, 480));
  EXPECT_EQ(message_of<InputError>([&] { bank.check_frame_size(320, 240); }),
            "frame: is 320x240 px, and the paths are drawn on frames of 640x480 px; expected the same size");
  bank.add(on_circle(100.0, 0.0), 20.0);
  EXPECT_TRUE(contains(message_of<InputError>([&] { bank.set_paths(paths); }), "paths: tracks are on those before"));
  EXPECT_TRUE(contains(message_of<ConfigError>([] { make_filter_bank(KalmanPathOptions{}); }), "needs paths"));
}

TEST(Path, StretchIsHowFarAPointGoesForEachPxOfS) {
  const Path path(circle(72, 100.0), true, PathKind::curve);  // clockwise: positive T is towards the middle
  for (const double t : {-50.0, 0.0, 60.0}) {
    const double s = 123.4, step = 1e-3;
    const Point a = path.to_image({s - step, t}), b = path.to_image({s + step, t});
    EXPECT_NEAR(path.stretch({s, t}), distance(a, b) / (2.0 * step), 2e-3) << t;
    EXPECT_NEAR(path.stretch({s, t}), 1.0 - t / 100.0, 0.02) << t;
  }
  EXPECT_EQ(path.stretch({0.0, 1e8}), 0.01);
  EXPECT_EQ(path.stretch({0.0, -1e8}), 100.0);
  EXPECT_EQ(Path({{0, 0}, {50, 80}, {100, 0}}, false, PathKind::curve).stretch({-5.0, 40.0}), 1.0);
  EXPECT_THROW(path.stretch({std::nan(""), 0.0}), InputError);
}

}  // namespace
}  // namespace survtrack
