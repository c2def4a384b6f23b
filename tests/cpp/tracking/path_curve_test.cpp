// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

// Splines, and what holds for every path.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "../simd_levels.hpp"
#include "some_paths.hpp"
#include "survtrack/core/errors.hpp"
#include "survtrack/tracking/path.hpp"

namespace survtrack {
namespace {

TEST(CurvedPath, GoesThroughItsPoints) {
  std::mt19937 random(1);
  const Path path(star(12, random), true, PathKind::curve);
  double last = -1.0;
  for (const Point& point : path.points()) {
    const PathPosition place = path.to_path(point);
    EXPECT_NEAR(place.t_px, 0.0, 1e-9);
    EXPECT_GT(place.s_px, last);
    EXPECT_LT(distance(path.to_image(place), point), 1e-9);
    last = place.s_px;
  }
}

TEST(CurvedPath, TwoPointsAreALineAndThreeOnALineToo) {
  const Path two({{0, 0}, {30, 40}}, false, PathKind::curve), three({{0, 0}, {10, 0}, {100, 0}}, false, PathKind::curve);
  EXPECT_NEAR(two.length_px(), 50.0, 1e-12);
  EXPECT_NEAR(three.length_px(), 100.0, 1e-9);
  EXPECT_NEAR(three.to_path({70, 3}).s_px, 70.0, 1e-9);
  EXPECT_NEAR(three.to_path({-5, 3}).s_px, -5.0, 1e-9);
}

TEST(CurvedPath, PointsOnACircleMakeNearlyThatCircle) {
  const Path path(circle(16, 100.0), true, PathKind::curve);
  EXPECT_NEAR(path.length_px(), 200.0 * M_PI, 0.5);
  for (double angle = 0.0; angle < 6.28; angle += 0.01) {
    const PathPosition place = path.to_path({120 * std::cos(angle), 120 * std::sin(angle)});
    EXPECT_NEAR(place.t_px, -20.0, 0.15);
    EXPECT_NEAR(place.s_px, 100.0 * angle, 0.5);
  }
}

/// A parabola by hand: of three points at equal distances the middle one's rate is that of the chord of its neighbours.
TEST(CurvedPath, TheTangentAtAPointHalvesTheAngle) {
  const Path path({{0, 0}, {100, 0}, {180, 60}}, false, PathKind::curve);
  const double half = 0.5 * std::atan2(60, 80);
  EXPECT_NEAR(path.tangent(path.to_path({100, 0}).s_px).x, std::cos(half), 1e-9);
  EXPECT_NEAR(path.tangent(path.to_path({100, 0}).s_px).y, std::sin(half), 1e-9);
}

TEST(CurvedPath, SIsTheLengthOfTheLine) {
  std::mt19937 random(2);
  const Path path(star(9, random), true, PathKind::curve);
  constexpr int steps = 200'000;
  const double step = path.length_px() / steps;
  double walked = 0.0, worst = 0.0;
  Point last = path.to_image({0, 0});
  for (int i = 1; i <= steps; ++i) {
    const Point next = path.to_image({i * step, 0});
    walked += distance(last, next);
    worst = std::max(worst, std::abs(walked - i * step));
    last = next;
  }
  EXPECT_LT(worst, 1e-5);
  EXPECT_LT(distance(last, path.points()[0]), 1e-9);
}

/// Any path of a few points: open or closed, with corners or without.
Path any_path(int k, std::mt19937& random) {
  for (;;) {
    try {
      return Path(star(3 + k % 13, random), k % 2 == 0, k % 4 < 2 ? PathKind::line : PathKind::curve);
    } catch (const InputError&) {  // a spline may meet itself where the lines do not
    }
  }
}

TEST(EveryPath, FromTheImageToThePathAndBackIsTheSamePlace) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> anywhere(0.0, 400.0);
  int compared = 0;
  for (int k = 0; k < 200; ++k) {
    const Path path = any_path(k, random);
    for (int i = 0; i < 200; ++i) {
      const Point point{anywhere(random), anywhere(random)};
      const PathPosition place = path.to_path(point);
      const bool at_corner = path.kind() == PathKind::line &&
                             distance(path.tangent(place.s_px), path.tangent(place.s_px + 1e-7)) > 1e-3;
      // How much faster S grows than the point moves: near to the centre of curvature nothing is certain.
      const bool near_center = std::abs(path.velocity(point, path.tangent(place.s_px)).s_px) > 20.0;
      if (at_corner || near_center) continue;
      EXPECT_LT(distance(path.to_image(place), point), 1e-9) << k << ", " << i;
      ++compared;
    }
  }
  EXPECT_GT(compared, 25'000);
}

TEST(EveryPath, FromThePathToTheImageAndBackIsTheSamePlace) {
  std::mt19937 random(4);
  for (int k = 0; k < 200; ++k) {
    const Path path = any_path(k, random);
    std::uniform_real_distribution<double> along(0.0, path.length_px());
    for (int i = 0; i < 100; ++i) {
      const double s_px = along(random);
      const PathPosition back = path.to_path(path.to_image({s_px, 0.0}));
      EXPECT_NEAR(path.residual(back.s_px, s_px), 0.0, 1e-9) << k << ", " << i;
      EXPECT_NEAR(back.t_px, 0.0, 1e-9);
    }
  }
}

TEST(EveryPath, NoPointOfThePathIsNearer) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> anywhere(-100.0, 500.0);
  constexpr int samples = 4000;
  for (int k = 0; k < 60; ++k) {
    const Path path = any_path(k, random);
    std::vector<Point> line;
    for (int i = 0; i <= samples; ++i) line.push_back(path.to_image({path.length_px() * i / samples, 0}));
    for (int i = 0; i < 40; ++i) {
      const Point point{anywhere(random), anywhere(random)};
      const double s_px = path.to_path(point).s_px;
      const double on_path = path.closed() ? s_px : std::clamp(s_px, 0.0, path.length_px());
      const double found = distance(point, path.to_image({on_path, 0}));
      double least = 1e9;
      for (const Point& sample : line) least = std::min(least, distance(point, sample));
      EXPECT_LT(found, least + 1e-9) << k << ", " << i;
    }
  }
}

TEST(EveryPath, NextToAJointThePlaceIsExact) {
  const Path line({{0, 0}, {100, 0}, {200, 1}, {300, 40}, {0, 300}}, true), curve(circle(9, 150.0), true, PathKind::curve);
  for (const Path* path : {&line, &curve}) {
    for (const Point& joint : path->points()) {
      const double s_px = path->to_path(joint).s_px;
      for (double off = 1e-10; off < 1.0; off *= 3.0) {
        for (const double side : {-1.0, 1.0}) {
          const Point point = path->to_image({s_px + side * off, -50.0});  // outside
          EXPECT_LT(distance(path->to_image(path->to_path(point)), point), 1e-9) << s_px << ", " << side * off;
        }
      }
    }
  }
}

TEST(EveryPath, TheVelocityIsHowThePlaceChanges) {
  std::mt19937 random(6);
  std::uniform_real_distribution<double> along(0.0, 1.0), across(-5.0, 5.0), speed(-30.0, 30.0);
  constexpr double h = 1e-5;
  int compared = 0;
  for (int k = 0; k < 100; ++k) {
    const Path path = any_path(k, random);
    for (int i = 0; i < 20; ++i) {
      const Point point = path.to_image({along(random) * path.length_px(), across(random)});
      const Point v{speed(random), speed(random)};
      const PathPosition rate = path.velocity(point, v), before = path.to_path(point - h * v), after = path.to_path(point + h * v);
      const PathPosition change{path.residual(after.s_px, before.s_px) / (2 * h), (after.t_px - before.t_px) / (2 * h)};
      // Not where it leaps: between two legs, or near to a centre of curvature.
      if (std::abs(change.s_px) > 200.0 || std::abs(change.s_px - rate.s_px) > 0.5 * std::hypot(v.x, v.y)) continue;
      EXPECT_NEAR(rate.s_px, change.s_px, 0.02 * std::max(1.0, std::abs(change.s_px))) << k << ", " << i;
      EXPECT_NEAR(rate.t_px, change.t_px, 0.02 * std::max(1.0, std::abs(change.t_px))) << k << ", " << i;
      ++compared;
    }
  }
  EXPECT_GT(compared, 1800);
}

class PathAtEverySimdLevel : public AtEverySimdLevel {};

TEST_P(PathAtEverySimdLevel, ManyAtOnceAreTheSameAsOneByOne) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> anywhere(0.0, 400.0);
  for (int k = 0; k < 12; ++k) {
    const Path path = any_path(k, random);
    std::vector<Point> points;
    for (int i = 0; i < 700; ++i) points.push_back({anywhere(random), anywhere(random)});
    std::vector<PathPosition> places(points.size());
    path.to_path(points.data(), points.size(), places.data());
    std::vector<Point> back(points.size());
    path.to_image(places.data(), places.size(), back.data());
    simd::set_level(simd::Level::baseline);
    for (std::size_t i = 0; i < points.size(); ++i) {
      ASSERT_EQ(path.to_path(points[i]), places[i]) << k << ", " << i;
      ASSERT_EQ(path.to_image(places[i]), back[i]) << k << ", " << i;
    }
    simd::set_level(GetParam());
  }
}

INSTANTIATE_TEST_SUITE_P(Simd, PathAtEverySimdLevel, testing::ValuesIn(simd_levels()), simd_level_name);

}  // namespace
}  // namespace survtrack
