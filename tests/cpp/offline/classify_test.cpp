// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "../error_message.hpp"
#include "streets.hpp"
#include "survtrack/core/errors.hpp"
#include "survtrack/offline/patterns.hpp"

namespace survtrack {
namespace {

/// East 1, west 2, south 3, north 4.
Activity seen_by_streets(const RecordedTrack& track) { return learn_patterns(two_streets()).classify(track); }

TEST(Classify, WhatWasLearnedFromIsUsual) {
  const Patterns learned = learn_patterns(two_streets());
  std::vector<std::int64_t> tracks(4, 0);
  std::int64_t id = 0;
  for (const Activity& activity : learned.classify(two_streets())) {
    EXPECT_EQ(activity.track_id, ++id);
    EXPECT_EQ(activity.kind, ActivityKind::usual);
    EXPECT_FALSE(activity.unusual());
    EXPECT_FALSE(activity.partial);
    EXPECT_LE(*activity.distance, 0.2);  // 8 px
    EXPECT_NEAR(*activity.speed_ratio, 1.0, 1e-9);
    ++tracks[static_cast<std::size_t>(*activity.pattern) - 1];
  }
  EXPECT_EQ(tracks, (std::vector<std::int64_t>{9, 7, 5, 3}));
}

TEST(Classify, DistanceIsInObjectSizes) {
  const Activity activity = seen_by_streets(walk_between(50, {0, 210}, {400, 210}));
  EXPECT_EQ(activity.pattern, 1);
  EXPECT_NEAR(*activity.distance, 10.0 / 40.0, 1e-9);
  EXPECT_NEAR(*activity.angle_deg, 0.0, 1e-5);
}

TEST(Classify, AJaywalkerGoesAnotherWay) {
  // Crosses the street 100 px = 2.5 sizes beside the other one. Nearest are 200 px of the street where it crosses, at
  // right angles: 16 points from -100 to 100 px are on average 800 / 15 px from the crossing, on both.
  const Activity activity = seen_by_streets(walk_between(50, {300, 100}, {300, 300}));
  EXPECT_EQ(activity.kind, ActivityKind::other_way);
  EXPECT_TRUE(activity.unusual());
  EXPECT_FALSE(activity.pattern.has_value());
  EXPECT_FALSE(activity.speed_ratio.has_value());
  EXPECT_NEAR(*activity.distance, std::sqrt(2.0) * 800.0 / 15.0 / 40.0, 1e-9);
  EXPECT_NEAR(*activity.angle_deg, 90.0, 1e-6);
}

TEST(Classify, WhoTurnsBackGoesAnotherWay) {
  RecordedTrack track = walk_between(50, {0, 200}, {400, 200});
  for (std::size_t i = 50; i < track.points.size(); ++i) track.points[i].position = track.points[100 - i].position;
  EXPECT_EQ(seen_by_streets(track).kind, ActivityKind::other_way);
}

TEST(Classify, AcrossAShortStretchIsAnotherWayByItsAngle) {
  // 100 px across the street: its points are on average 38 px from those of the way, but go at right angles.
  const Activity activity = seen_by_streets(walk_between(50, {300, 150}, {300, 250}));
  EXPECT_EQ(activity.kind, ActivityKind::other_way);
  EXPECT_LT(*activity.distance, 1.5);
  EXPECT_NEAR(*activity.angle_deg, 90.0, 1e-6);
}

TEST(Classify, AStretchOfAWayIsEnough) {
  const Activity activity = seen_by_streets(walk_between(50, {100, 200}, {260, 200}));
  EXPECT_EQ(activity.kind, ActivityKind::usual);
  EXPECT_EQ(activity.pattern, 1);
  EXPECT_TRUE(activity.partial);
  EXPECT_NEAR(*activity.distance, 0.0, 1e-9);
  EXPECT_EQ(seen_by_streets(walk_between(50, {260, 200}, {100, 200})).pattern, 2);
}

TEST(Classify, SpeedsAreHeldAgainstThePatterns) {
  // All walked at 40 px/s, so that 3 times a tenth of it is allowed: up to 52, down to 40 / 1.3 = 30.8 px/s.
  const auto kind_at = [](double speed) { return seen_by_streets(walk_between(50, {0, 200}, {400, 200}, speed)); };
  EXPECT_EQ(kind_at(50.0).kind, ActivityKind::usual);
  EXPECT_EQ(kind_at(32.0).kind, ActivityKind::usual);
  EXPECT_EQ(kind_at(28.0).kind, ActivityKind::too_slow);
  const Activity fast = kind_at(80.0);
  EXPECT_EQ(fast.kind, ActivityKind::too_fast);
  EXPECT_TRUE(fast.unusual());
  EXPECT_EQ(fast.pattern, 1);
  EXPECT_NEAR(*fast.speed_ratio, 2.0, 1e-9);
  EXPECT_NEAR(fast.speed_px_per_s, 80.0, 1e-9);
}

TEST(Classify, AStretchIsHeldAgainstThePatternsSpeedThere) {
  // 200 px at 20 px/s and then, nearer to the camera, 200 px at 80 px/s: 12.5 s, 32 px/s on average.
  History history;
  for (std::int64_t id = 1; id <= 3; ++id) {
    history.tracks.push_back(walk_between(id, {0, 0}, {200, 0}, 20.0));
    const RecordedTrack rest = walk_between(id, {208, 0}, {400, 0}, 80.0, 101);
    auto& points = history.tracks.back().points;
    points.insert(points.end(), rest.points.begin(), rest.points.end());
  }
  const Patterns learned = learn_patterns(history);
  ASSERT_EQ(learned.patterns.size(), 1U);
  EXPECT_NEAR(learned.patterns[0].speed_px_per_s, 32.0, 1e-9);
  for (const double x : {0.0, 220.0}) {
    const Activity activity = learned.classify(walk_between(9, {x, 0}, {x + 160, 0}, x > 0.0 ? 80.0 : 20.0));
    EXPECT_EQ(activity.kind, ActivityKind::usual);
    EXPECT_TRUE(activity.partial);
    EXPECT_NEAR(*activity.speed_ratio, 1.0, 0.02);
  }
  EXPECT_EQ(learned.classify(walk_between(9, {220, 0}, {380, 0}, 20.0)).kind, ActivityKind::too_slow);
}

TEST(Classify, ThePatternsOwnSpreadIsAllowed) {
  // 20, 40 and 80 px/s: mean 46.7 and deviation 24.9, of which three allow up to 2.6 times the mean, 121 px/s.
  const Patterns learned = learn_patterns({{walk_between(1, {0, 0}, {400, 0}, 20.0), walk_between(2, {0, 0}, {400, 0}, 40.0),
                                            walk_between(3, {0, 0}, {400, 0}, 80.0)}});
  EXPECT_EQ(learned.classify(walk_between(4, {0, 0}, {400, 0}, 100.0)).kind, ActivityKind::usual);
  EXPECT_EQ(learned.classify(walk_between(4, {0, 0}, {400, 0}, 160.0)).kind, ActivityKind::too_fast);
}

TEST(Classify, WhatStandsIsNotUnusual) {
  const Activity activity = seen_by_streets(walk_between(50, {300, 300}, {350, 300}));
  EXPECT_EQ(activity.kind, ActivityKind::standing);
  EXPECT_FALSE(activity.unusual());
  EXPECT_FALSE(activity.distance.has_value());
}

TEST(Classify, WithoutPatternsEverythingThatMovesIsUnusual) {
  const Activity activity = Patterns{}.classify(walk_between(50, {0, 200}, {400, 200}));
  EXPECT_EQ(activity.kind, ActivityKind::other_way);
  EXPECT_FALSE(activity.distance.has_value());
}

TEST(Classify, OptionsCanBeChangedAfterwards) {
  Patterns learned = learn_patterns(two_streets());
  const RecordedTrack aside = walk_between(50, {0, 280}, {400, 280});  // 2 sizes
  EXPECT_EQ(learned.classify(aside).kind, ActivityKind::other_way);
  learned.options.max_distance = 2.5;
  learned.options.points = 32;
  EXPECT_EQ(learned.classify(aside).pattern, 1);
  learned.options.points = 1;
  EXPECT_TRUE(contains(message_of<ConfigError>([&] { learned.classify(aside); }), "points: 1 is not allowed"));
}

TEST(Classify, NumbersAreFiniteWhateverTheTracks) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> exponent(-12.0, 9.0), side(-3.0, 9.0);
  const double steps[] = {1e-12, 1e-3, 1.0, 1e9};
  for (int trial = 0; trial < 200; ++trial) {
    History history;
    for (std::int64_t id = 0; id < 20; ++id) {
      RecordedTrack track{id, {}};
      const double step_s = steps[trial % 4];
      for (int index = 0; index < 1 + static_cast<int>(random() % 20); ++index) {
        const auto place = [&] { return (random() % 2 ? 1.0 : -1.0) * std::pow(10.0, exponent(random)); };
        track.points.push_back({index, step_s * index, {0, 0, std::pow(10.0, side(random)), std::pow(10.0, side(random))},
                                {place(), place()}, {}, {}});
      }
      history.tracks.push_back(track);
    }
    PatternOptions options;
    options.min_tracks = 1;
    options.max_angle_deg = 180.0;
    options.max_distance = 1e6;
    const Patterns learned = learn_patterns(history, options);
    for (const Activity& activity : learned.classify(history)) {
      EXPECT_TRUE(std::isfinite(activity.speed_px_per_s));
      EXPECT_TRUE(std::isfinite(activity.distance.value_or(0.0)));
      EXPECT_TRUE(std::isfinite(activity.angle_deg.value_or(0.0)));
      EXPECT_TRUE(std::isfinite(activity.speed_ratio.value_or(0.0)));
    }
    EXPECT_EQ(Patterns::from_json(learned.to_json(), "again").to_json(), learned.to_json());
  }
}

TEST(Classify, APatternThatAProgramMadeWrongIsRefused) {
  Patterns learned = learn_patterns(two_streets());
  const auto refusal = [&] { return message_of<InputError>([&] { learned.classify(two_streets()); }); };
  learned.patterns[2].way.resize(1);
  EXPECT_TRUE(contains(refusal(), "pattern 3: expected a way of at least 2 points"));
  learned.patterns[1].speed_px_per_s = 0.0;
  EXPECT_TRUE(contains(refusal(), "pattern 2: expected a speed_px_per_s"));
  learned.patterns[0].way[0].x = std::nan("");
  EXPECT_TRUE(contains(refusal(), "pattern 1: expected a way within"));
}

}  // namespace
}  // namespace survtrack
