// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

// Worked examples: what S and T are, at ends, corners and the start of a closed path.

#include "survtrack/tracking/path.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "some_paths.hpp"

namespace survtrack {
namespace {

void expect_place(const Path& path, Point point, double s_px, double t_px, double within = 1e-12) {
  const PathPosition place = path.to_path(point);
  EXPECT_NEAR(place.s_px, s_px, within) << "S of (" << point.x << ", " << point.y << ")";
  EXPECT_NEAR(place.t_px, t_px, within) << "T of (" << point.x << ", " << point.y << ")";
}

void expect_point(const Path& path, PathPosition place, Point point) {
  EXPECT_LT(distance(path.to_image(place), point), 1e-12) << "(" << place.s_px << ", " << place.t_px << ")";
}

TEST(Path, ALevelPathToTheRightHasTheImagesOwnCoordinates) {
  const Path path({{0, 0}, {300, 0}});
  EXPECT_EQ(path.length_px(), 300.0);
  expect_place(path, {120, 30}, 120, 30);
  expect_place(path, {120, -30}, 120, -30);
  expect_point(path, {120, 30}, {120, 30});
  EXPECT_EQ(path.tangent(10), (Point{1, 0}));
  EXPECT_EQ(path.normal(10), (Point{0, 1}));
}

TEST(Path, BeyondItsEndsAnOpenPathGoesStraightOn) {
  const Path path({{0, 0}, {30, 40}, {30, 100}});
  EXPECT_EQ(path.length_px(), 110.0);
  expect_place(path, {-6, -8}, -10, 0);
  expect_place(path, {-6 - 4, -8 + 3}, -10, 5);
  expect_place(path, {35, 120}, 130, -5);
  expect_point(path, {-10, 5}, {-10, -5});
  expect_point(path, {130, -5}, {35, 120});
}

TEST(Path, WhatIsNearToThePathIsNotOnTheLineBeyondItsEnd) {
  // Its second half leads back across the line on which the first goes on.
  const Path path({{0, 0}, {100, 0}, {100, 50}, {-50, 50}, {-50, -50}});
  expect_place(path, {-50, -1}, 351, 0);
  expect_place(path, {-20, -1}, -20, -1);
}

TEST(Path, ASquareByHand) {
  const Path path(square_points, true);
  EXPECT_EQ(path.length_px(), 400.0);
  expect_place(path, {50, 10}, 50, 10);
  expect_place(path, {50, -10}, 50, -10);
  expect_place(path, {110, 50}, 150, -10);
  expect_place(path, {40, 90}, 260, 10);
  expect_place(path, {-10, 50}, 350, -10);
  expect_place(path, {5, 20}, 380, 5);
}

TEST(Path, OutsideOfACornerSIsTheCornersAndTTheDistance) {
  const Path path(square_points, true);
  expect_place(path, {103, -4}, 100, -5);
  expect_place(path, {104, 103}, 200, -5);
  expect_place(path, {-3, -4}, 0, -5);
  const double aside = 5.0 / std::sqrt(2.0);
  expect_point(path, {100, -5}, {100 + aside, -aside});
  EXPECT_NEAR(path.tangent(100).x, std::sqrt(0.5), 1e-15);
  EXPECT_NEAR(path.tangent(100).y, std::sqrt(0.5), 1e-15);
  EXPECT_NEAR(path.tangent(400).x, std::sqrt(0.5), 1e-15);
}

TEST(Path, TheSideIsTheSameAllRoundASharpCorner) {
  const Path path({{0, 0}, {100, 0}, {0, 10}});  // turns right by 174 degrees
  for (double angle = -89.0; angle < 84.0; angle += 1.0) {
    const Point point{100 + 7 * std::cos(angle * M_PI / 180), 7 * std::sin(angle * M_PI / 180)};
    expect_place(path, point, 100, -7, 1e-9);
  }
}

TEST(Path, OfEqualDistancesTheSmallestSCounts) {
  expect_place(Path(square_points, true), {50, 50}, 50, 50);
  expect_place(Path({{0, 0}, {0, 100}, {60, 100}, {60, 0}}), {30, 20}, 20, -30);
  expect_place(Path({{100, 0}, {100, 100}, {0, 100}, {0, 0}}, true), {50, 50}, 50, 50);
}

TEST(Path, AClosedPathGoesRoundAndRound) {
  const Path path(square_points, true);
  expect_point(path, {450, 5}, {50, 5});
  expect_point(path, {-50, -5}, {-5, 50});
  expect_point(path, {-4050, 0}, {0, 50});
  EXPECT_EQ(path.wrap(400.0), 0.0);
  EXPECT_EQ(path.wrap(-1e-300), 0.0);
  EXPECT_EQ(path.wrap(-30.0), 370.0);
  EXPECT_EQ(Path({{0, 0}, {10, 0}}).wrap(-30.0), -30.0);
}

TEST(Path, TheShorterWayRoundIsTheResidual) {
  const Path path(square_points, true);
  EXPECT_EQ(path.residual(10, 390), 20.0);
  EXPECT_EQ(path.residual(390, 10), -20.0);
  EXPECT_EQ(path.residual(150, 100), 50.0);
  EXPECT_EQ(path.residual(300, 100), -200.0);  // half way round: back
  EXPECT_EQ(path.residual(790, 10), -20.0);
  const Path open({{0, 0}, {400, 0}});
  EXPECT_EQ(open.residual(390, 10), 380.0);
}

/// The wrap of O'Malley's listing: a difference, predicted less measured, of more than 200 is changed by the length,
/// which is subtracted whatever its sign.
double innovation_of_the_listing(double measured, double predicted, double length) {
  double difference = predicted - measured;
  if (std::abs(difference) > 200.0) difference -= length;
  return -difference;
}

TEST(Path, TheWrapOfOMalleysListingIsWrongByTwoLengths) {
  const double length = 278.586;
  const Path track({{0, 0}, {100, 0}, {100, 39.293}, {0, 39.293}}, true);
  ASSERT_NEAR(track.length_px(), length, 1e-12);
  EXPECT_NEAR(innovation_of_the_listing(277, 2, length), 553.586, 1e-9);
  EXPECT_NEAR(track.residual(277, 2), -3.586, 1e-9);
  EXPECT_NEAR(innovation_of_the_listing(277, 2, length) - track.residual(277, 2), 2 * length, 1e-9);
  // Forwards over the start the listing is right.
  EXPECT_NEAR(innovation_of_the_listing(2, 277, length), 3.586, 1e-9);
  EXPECT_NEAR(track.residual(2, 277), 3.586, 1e-9);
  // Between half the length and its fixed 200 it does not wrap at all.
  EXPECT_NEAR(innovation_of_the_listing(10, 180, length), -170, 1e-9);
  EXPECT_NEAR(track.residual(10, 180), 108.586, 1e-9);
}

TEST(Path, FarOffThePathIsNowhere) {
  const Path path({{0, 0}, {100, 0}}, false, PathKind::line, 20.0);
  expect_place(path, {50, 20}, 50, 20);
  EXPECT_TRUE(std::isnan(path.to_path({50, 20.001}).s_px));
  EXPECT_TRUE(std::isnan(path.to_path({50, 20.001}).t_px));
  expect_place(path, {-12, 16}, -12, 16);
  EXPECT_TRUE(std::isnan(path.to_path({-12.1, 16}).s_px));
  EXPECT_TRUE(std::isnan(path.velocity({50, 21}, {1, 1}).s_px));
  expect_point(path, {50, 500}, {50, 500});
}

TEST(Path, VelocitiesAreAlongAndAcross) {
  const Path path(square_points, true);
  EXPECT_EQ(path.velocity({110, 50}, {3, 4}), (PathPosition{4, -3}));
  EXPECT_EQ(path.velocity({50, 90}, {3, 4}), (PathPosition{-3, -4}));
}

TEST(Path, InTheOuterLaneOfABendSGrowsSlower) {
  const Path path(circle(72, 100.0), true, PathKind::curve);
  const PathPosition inner = path.velocity({80, 0}, {0, 40}), outer = path.velocity({125, 0}, {0, 40});
  EXPECT_NEAR(inner.s_px, 40 / 0.8, 0.1);
  EXPECT_NEAR(outer.s_px, 40 / 1.25, 0.1);
  EXPECT_NEAR(path.velocity({0.5, 0}, {0, 40}).s_px, 4000, 40);  // the divisor's least
}

}  // namespace
}  // namespace survtrack
