// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "../error_message.hpp"
#include "streets.hpp"
#include "survtrack/core/errors.hpp"
#include "survtrack/offline/patterns.hpp"

namespace survtrack {
namespace {

std::vector<std::int64_t> counts_of(const Patterns& learned) {
  std::vector<std::int64_t> counts;
  for (const Pattern& pattern : learned.patterns) counts.push_back(pattern.count);
  return counts;
}

void expect_way(const Pattern& pattern, Point from, Point to) {
  ASSERT_EQ(pattern.way.size(), 16U);
  for (std::size_t i = 0; i < 16; ++i) {
    const Point expected = from + (static_cast<double>(i) / 15.0) * (to - from);
    EXPECT_NEAR(pattern.way[i].x, expected.x, 1e-9) << "pattern " << pattern.id << ", point " << i;
    EXPECT_NEAR(pattern.way[i].y, expected.y, 1e-9) << "pattern " << pattern.id << ", point " << i;
  }
}

TEST(LearnPatterns, TwoStreetsAreFourWays) {
  const Patterns learned = learn_patterns(two_streets());
  ASSERT_EQ(counts_of(learned), (std::vector<std::int64_t>{9, 7, 5, 3}));
  expect_way(learned.patterns[0], {0, 200}, {400, 200});
  expect_way(learned.patterns[1], {400, 200}, {0, 200});
  expect_way(learned.patterns[2], {200, 0}, {200, 400});
  expect_way(learned.patterns[3], {200, 400}, {200, 0});
  // Walkers at -4, -2, 0, 2 and 4 px: the root of (16 + 4 + 0 + 4 + 16) / 5.
  for (const double spread : learned.patterns[2].spread_px) EXPECT_NEAR(spread, std::sqrt(8.0), 1e-9);
  for (std::size_t k = 0; k < 4; ++k) {
    const Pattern& pattern = learned.patterns[k];
    EXPECT_EQ(pattern.id, static_cast<int>(k) + 1);
    EXPECT_EQ(pattern.spread_px.size(), 16U);
    ASSERT_EQ(pattern.time_s.size(), 16U);
    for (std::size_t i = 0; i < 16; ++i) EXPECT_NEAR(pattern.time_s[i], 10.0 * static_cast<double>(i) / 15.0, 1e-9);
    EXPECT_NEAR(pattern.size_px, 40.0, 1e-9);
    EXPECT_NEAR(pattern.speed_px_per_s, 40.0, 1e-9);
    EXPECT_NEAR(pattern.speed_deviation_px_per_s, 0.0, 1e-9);
    EXPECT_NEAR(pattern.duration_s, 10.0, 1e-9);
    EXPECT_NEAR(pattern.duration_deviation_s, 0.0, 1e-9);
    EXPECT_EQ(pattern.enters(), pattern.way.front());
    EXPECT_EQ(pattern.leaves(), pattern.way.back());
  }
}

TEST(LearnPatterns, SpeedAndDurationSpread) {
  // 400 px in 20, 10 and 5 s; without options for it a pattern has three tracks.
  const History history = {{walk_between(1, {0, 0}, {400, 0}, 20.0), walk_between(2, {0, 0}, {400, 0}, 40.0),
                            walk_between(3, {0, 0}, {400, 0}, 80.0)}};
  const Patterns learned = learn_patterns(history);
  ASSERT_EQ(learned.patterns.size(), 1U);
  const Pattern& pattern = learned.patterns[0];
  EXPECT_NEAR(pattern.speed_px_per_s, 140.0 / 3.0, 1e-9);
  EXPECT_NEAR(pattern.speed_deviation_px_per_s, std::sqrt(8400.0 / 3.0 - std::pow(140.0 / 3.0, 2)), 1e-9);
  EXPECT_NEAR(pattern.duration_s, 35.0 / 3.0, 1e-9);
  EXPECT_NEAR(pattern.duration_deviation_s, std::sqrt(525.0 / 3.0 - std::pow(35.0 / 3.0, 2)), 1e-9);
}

TEST(LearnPatterns, TheOrderOfTheTracksDoesNotMatter) {
  std::mt19937 random(1);
  History history = two_streets();
  const std::string expected = learn_patterns(history).to_json();
  for (int trial = 0; trial < 10; ++trial) {
    std::shuffle(history.tracks.begin(), history.tracks.end(), random);
    EXPECT_EQ(learn_patterns(history).to_json(), expected);
  }
}

TEST(LearnPatterns, WhatFewTracksDoIsNoPattern) {
  PatternOptions options;
  options.min_tracks = 6;
  EXPECT_EQ(counts_of(learn_patterns(two_streets(), options)), (std::vector<std::int64_t>{9, 7}));
  options.min_tracks = 10;
  EXPECT_TRUE(learn_patterns(two_streets(), options).patterns.empty());
  EXPECT_TRUE(learn_patterns({}).patterns.empty());
}

TEST(LearnPatterns, WhatStandsIsNotLearnedFrom) {
  // Trembles by 3 px for ten seconds: more of a way than a street, and nowhere to go.
  History history;
  for (std::int64_t id = 1; id <= 5; ++id) {
    RecordedTrack track = walk_between(id, {100, 100}, {400, 100});
    for (TrackPoint& point : track.points) point.position = {100.0 + 3.0 * static_cast<double>(point.index % 2), 100.0};
    history.tracks.push_back(track);
  }
  EXPECT_TRUE(learn_patterns(history).patterns.empty());
}

TEST(LearnPatterns, TremblingIsNoWay) {
  History history;
  for (std::int64_t id = 1; id <= 3; ++id) {
    RecordedTrack track = walk_between(id, {0, 0}, {400, 0});
    const auto halt = track.points[50];
    for (auto point = track.points.begin() + 51; point != track.points.end(); ++point) {
      point->position = halt.position + Point{0.0, 3.0 * static_cast<double>(point->index % 2)};
    }
    history.tracks.push_back(track);
  }
  const Patterns learned = learn_patterns(history);
  ASSERT_EQ(learned.patterns.size(), 1U);
  EXPECT_NEAR(learned.patterns[0].speed_px_per_s, 20.0, 1.0);  // 200 px in 10 s
}

TEST(LearnPatterns, NearAndFarAreInObjectSizes) {
  // 50 px apart are 1.25 sizes of 40 px, and 5 of 10 px.
  History history;
  for (std::int64_t id = 1; id <= 6; ++id) history.tracks.push_back(walk_between(id, {0, id > 3 ? 50.0 : 0.0}, {400, id > 3 ? 50.0 : 0.0}));
  EXPECT_EQ(counts_of(learn_patterns(history)), (std::vector<std::int64_t>{6}));
  for (RecordedTrack& track : history.tracks) {
    for (TrackPoint& point : track.points) point.box = Box::around(point.position, 5.0, 20.0);
  }
  EXPECT_EQ(counts_of(learn_patterns(history)), (std::vector<std::int64_t>{3, 3}));
}

TEST(LearnPatterns, PatternsOfManyTracksAreThoseOfFew) {
  // Eight streams from all sides through one place, 3000 tracks, 3 px wide.
  std::mt19937 random(2);
  std::normal_distribution<double> noise(0.0, 3.0);
  History history;
  for (std::int64_t id = 0; id < 3000; ++id) {
    const double angle = 0.25 * 3.14159265358979 * static_cast<double>(id % 8);
    const Point aside{300.0 + noise(random), 300.0 + noise(random)}, half{250.0 * std::cos(angle), 250.0 * std::sin(angle)};
    history.tracks.push_back(walk_between(id, aside - half, aside + half, 50.0));
  }
  EXPECT_EQ(counts_of(learn_patterns(history)), std::vector<std::int64_t>(8, 375));
}

TEST(LearnPatterns, RefusesBadTracksAndOptions) {
  History history = two_streets();
  history.tracks[1].points[2].position.x = std::nan("");
  EXPECT_TRUE(contains(message_of<InputError>([&] { learn_patterns(history); }), "track 2, frame index 16: position (nan"));
  PatternOptions options;
  options.max_distance = 0.0;
  EXPECT_TRUE(contains(message_of<ConfigError>([&] { learn_patterns({}, options); }), "max_distance: 0 is not allowed"));
}

}  // namespace
}  // namespace survtrack
