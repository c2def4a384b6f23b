// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "survtrack/offline/pattern_path.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "../error_message.hpp"
#include "../tracking/some_paths.hpp"
#include "streets.hpp"
#include "survtrack/core/errors.hpp"

namespace survtrack {
namespace {

Pattern pattern_of(std::vector<Point> way) {
  Pattern pattern;
  pattern.way = std::move(way);
  pattern.size_px = 20.0;
  return pattern;
}

TEST(PatternPath, FollowsTheWayOfAPattern) {
  const Patterns learned = learn_patterns(two_streets());
  const Path path = path_of_pattern(learned.patterns[0]);
  EXPECT_FALSE(path.closed());
  EXPECT_EQ(path.kind(), PathKind::curve);
  EXPECT_EQ(path.points(), learned.patterns[0].way);
  EXPECT_NEAR(path.length_px(), 400.0, 1e-6);
  EXPECT_NEAR(path.to_path({100, 210}).t_px, 10.0, 1e-6);  // to the east: the right side is down
}

TEST(PatternPath, IsClosedWhenItEndsNearItsStart) {
  std::vector<Point> lap = circle(30, 100.0);
  lap.push_back({100, 15});
  EXPECT_TRUE(path_of_pattern(pattern_of(lap)).closed());
  EXPECT_EQ(path_of_pattern(pattern_of(lap)).points(), circle(30, 100.0));
  EXPECT_TRUE(path_of_pattern(pattern_of(lap), PathKind::line, 15.0).closed());
  lap.back() = {95, -15};
  EXPECT_FALSE(path_of_pattern(pattern_of(lap), PathKind::line, 14.0).closed());
  EXPECT_TRUE(path_of_pattern(pattern_of(lap)).closed());
  EXPECT_EQ(path_of_pattern(pattern_of(lap)).points(), lap);
  lap.back() = {99, -5};  // nearly the first point
  EXPECT_EQ(path_of_pattern(pattern_of(lap)).points(), circle(30, 100.0));
}

TEST(PatternPath, TakesTheFirstOfSeveralLaps) {
  std::vector<Point> laps;
  for (int i = 0; i < 75; ++i) laps.push_back({100 * std::cos(0.2 * i), 100 * std::sin(0.2 * i)});
  const Path path = path_of_pattern(pattern_of(laps));
  EXPECT_TRUE(path.closed());
  EXPECT_EQ(path.points().size(), 31U);  // the next is at 6.2 of 6.28: nearer to the first than half a step
  EXPECT_NEAR(path.length_px(), 200 * M_PI, 0.5);
}

TEST(PatternPath, WhoTurnsBackMakesNoLap) {
  EXPECT_FALSE(path_of_pattern(pattern_of({{0, 0}, {100, 0}, {200, 0}, {200, 15}, {100, 15}, {0, 15}})).closed());
  EXPECT_FALSE(path_of_pattern(pattern_of({{0, 0}, {5, 5}, {10, 0}})).closed());  // never away
}

TEST(PatternPath, SaysWhatIsWrong) {
  const auto refusal = [](const Pattern& pattern, std::optional<double> close_within_px) {
    return message_of<InputError>([&] { path_of_pattern(pattern, PathKind::line, close_within_px); });
  };
  EXPECT_TRUE(contains(refusal(pattern_of({{0, 0}, {5, 5}}), -1.0), "close_within_px: is -1", "expected px of at least 0"));
  EXPECT_TRUE(contains(refusal(pattern_of({}), {}), "way: has 0 points; expected at least 2"));
  EXPECT_TRUE(contains(refusal(pattern_of({{0, 0}, {200, 200}, {200, 0}, {0, 200}}), {}), "meets itself near (100, 100)"));
}

}  // namespace
}  // namespace survtrack
