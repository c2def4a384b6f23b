// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "survtrack/tracking/predicted_region.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "../error_message.hpp"
#include "survtrack/core/errors.hpp"

namespace survtrack {
namespace {

const PredictedRegionsOptions published{.sigmas_along = 3.0,
                                        .sigmas_across = 1.0,
                                        .forward_only = true,
                                        .whole_object = false,
                                        .margin = 0.0,
                                        .growth = 0.0};

void expect_box(const Box& box, double left, double top, double right, double bottom) {
  EXPECT_NEAR(box.x, left, 1e-9);
  EXPECT_NEAR(box.y, top, 1e-9);
  EXPECT_NEAR(box.right(), right, 1e-9);
  EXPECT_NEAR(box.bottom(), bottom, 1e-9);
}

/// Goes right, 20 px a frame, from (100, 50); 2 px deviation along, 3 across; 10 x 6 px.
ExpectedObject runner() {
  return {{100.0, 50.0}, {120.0, 50.0}, {4.0, 0.0, 9.0}, Box::around({120.0, 50.0}, 10.0, 6.0), 0};
}

TEST(PredictedRegion, IsFromTheLastPositionToThreeDeviationsAhead) {
  // 100 to 120 + 3 * 2; 50 +- 1 * 3, which is less than the longest axis of 10.
  expect_box(predicted_region(published, runner()), 100.0, 45.0, 126.0, 55.0);
  ExpectedObject wide = runner();
  wide.covariance_px2.yy = 81.0;
  expect_box(predicted_region(published, wide), 100.0, 41.0, 126.0, 59.0);
}

TEST(PredictedRegion, FollowsADiagonalWay) {
  const double r = std::sqrt(0.5);
  ExpectedObject diagonal = runner();
  // The same turned by 45 degrees.
  diagonal.position = {100.0 + 20.0 * r, 50.0 + 20.0 * r};
  diagonal.covariance_px2 = {6.5, -2.5, 6.5};
  diagonal.box = Box::around(diagonal.position, 10.0, 6.0);
  const Box box = predicted_region(published, diagonal);
  // Corners at (-20, +-3) and (6, +-3) along and across.
  expect_box(box, 100.0 - 3.0 * r, 50.0 - 3.0 * r, 100.0 + 29.0 * r, 50.0 + 29.0 * r);
}

TEST(PredictedRegion, HoldsTheWholeObject) {
  PredictedRegionsOptions options{.margin = 0.0, .growth = 0.0};
  // 3 deviations both ways, and half the box beyond.
  expect_box(predicted_region(options, runner()), 120.0 - 6.0 - 5.0, 50.0 - 9.0 - 3.0, 120.0 + 6.0 + 5.0, 50.0 + 9.0 + 3.0);
  // A box that does not lie about its position is held all the same.
  ExpectedObject leaning = runner();
  leaning.box = {119.0, 40.0, 10.0, 12.0};
  expect_box(predicted_region(options, leaning), 119.0 - 6.0, 40.0 - 9.0, 129.0 + 6.0, 52.0 + 9.0);
  options.margin = 0.5;
  options.growth = 0.25;
  leaning.lost_s = 2.0;  // 0.5 + 2 s * 0.25 of 12 px
  expect_box(predicted_region(options, leaning), 119.0 - 18.0, 40.0 - 21.0, 129.0 + 18.0, 52.0 + 21.0);
}

TEST(PredictedRegion, OfWhoStandsStillLiesAllAround) {
  ExpectedObject still = runner();
  still.before = still.position;
  PredictedRegionsOptions options = published;
  options.whole_object = true;
  expect_box(predicted_region(options, still), 120.0 - 6.0 - 5.0, 50.0 - 3.0 - 3.0, 120.0 + 6.0 + 5.0, 50.0 + 3.0 + 3.0);
}

TEST(PredictedRegion, OnAPathGoesRoundTheCorner) {
  // Right along y = 10 to x = 50, then down.
  const Path path({{0.0, 10.0}, {50.0, 10.0}, {50.0, 90.0}});
  ExpectedOnPath place{{40.0, 0.0}, {60.0, 0.0}, {4.0, 0.0, 1.0}};
  ExpectedObject car{{40.0, 10.0}, {50.0, 20.0}, {}, Box::around({50.0, 20.0}, 6.0, 6.0), 0};
  // S from 40 to 60 + 6: 16 px down the second leg; T +-1, which to the right of who goes down is to the left.
  const Box box = predicted_region(published, car, path, place);
  EXPECT_NEAR(box.x, 40.0, 1e-9);
  EXPECT_NEAR(box.right(), 51.0, 1e-9);
  EXPECT_NEAR(box.y, 9.0, 1e-9);
  EXPECT_NEAR(box.bottom(), 26.0, 1e-9);
}

TEST(PredictedRegion, OnAClosedPathCrossesItsStart) {
  const Path square({{0.0, 0.0}, {100.0, 0.0}, {100.0, 100.0}, {0.0, 100.0}}, true);
  // From S = 390, 10 px before the start, to 10 + 3 * 2 behind it.
  const ExpectedOnPath place{{390.0, 0.0}, {410.0, 0.0}, {4.0, 0.0, 0.0}};
  const ExpectedObject car{{0.0, 10.0}, {10.0, 0.0}, {}, Box::around({10.0, 0.0}, 4.0, 4.0), 0};
  expect_box(predicted_region(published, car, square, place), 0.0, 0.0, 16.0, 10.0);
  ExpectedOnPath wrapped = place;
  wrapped.position.s_px = 10.0;
  expect_box(predicted_region(published, car, square, wrapped), 0.0, 0.0, 16.0, 10.0);
}

TEST(PredictedRegion, HasSigmasOfItsOwnAlongAndAcross) {
  PredictedRegionsOptions options{.sigmas_along = 2.0, .sigmas_across = 1.0, .margin = 0.0, .growth = 0.0};
  const Box box = predicted_region(options, runner());
  EXPECT_NEAR(box.width, 2.0 * 2.0 * 2.0 + 10.0, 1e-9);
  EXPECT_NEAR(box.height, 2.0 * 3.0 + 6.0, 1e-9);
}

TEST(PredictedRegion, RefusesWhatIsNoExpectation) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto refused = [](const ExpectedObject& object) {
    return message_of<InputError>([&] { predicted_region({}, object); });
  };
  ExpectedObject object = runner();
  object.position.x = nan;
  EXPECT_EQ(refused(object), "predicted_region: a position is not finite; expected px");
  object = runner();
  object.covariance_px2.yy = -1.0;
  EXPECT_EQ(refused(object).find("predicted_region: covariance_px2 is no covariance: its smallest eigenvalue is "), 0U);
  object = runner();
  object.box.width = 0.0;
  EXPECT_EQ(refused(object).find("predicted_region: the box"), 0U);
  object = runner();
  object.lost_s = -1.0;
  EXPECT_EQ(refused(object).find("predicted_region: lost_s"), 0U);
  const Path path({{0.0, 0.0}, {100.0, 0.0}});
  EXPECT_THROW(predicted_region({}, runner(), path, {{0.0, 0.0}, {10.0, 0.0}, {nan, 0.0, 1.0}}), InputError);
}

}  // namespace
}  // namespace survtrack
