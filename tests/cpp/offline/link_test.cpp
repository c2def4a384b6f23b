// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "survtrack/offline/link.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "../error_message.hpp"
#include "straight_tracks.hpp"
#include "survtrack/core/errors.hpp"

namespace survtrack {
namespace {

using Pairs = std::vector<std::pair<std::int64_t, std::int64_t>>;

/// Nothing is dropped.
LinkOptions keep_all() {
  LinkOptions options;
  options.min_frames = 0;
  options.min_s = options.min_travel = 0.0;
  return options;
}

Pairs pairs_of(const Linked& linked) {
  Pairs pairs;
  for (const Link& link : linked.links) pairs.emplace_back(link.earlier_id, link.later_id);
  return pairs;
}

std::vector<std::int64_t> ids_of(const Linked& linked) {
  std::vector<std::int64_t> ids;
  for (const RecordedTrack& track : linked.history.tracks) ids.push_back(track.id);
  return ids;
}

/// Frames 0 to 9 from (0, 0), then 15 to 24, at 40 px/s to the right: by frame 15 the object is at 60.
History broken(Point later = {60.0, 0.0}, Point later_velocity = {40.0, 0.0}, Color later_color = {100.0, 100.0, 100.0}) {
  return {{track_of({1, 0, 9, {0, 0}}), track_of({2, 15, 24, later, later_velocity, later_color})}};
}

TEST(LinkTracks, JoinsWhatGoesOnAsItWas) {
  const Linked linked = link_tracks(broken(), keep_all());
  ASSERT_EQ(pairs_of(linked), (Pairs{{1, 2}}));
  const Link& link = linked.links[0];
  EXPECT_NEAR(link.gap_s, 0.6, 1e-12);
  EXPECT_NEAR(link.distance, 0.0, 1e-12);
  EXPECT_NEAR(link.speed_difference, 0.0, 1e-12);
  EXPECT_EQ(link.color_difference, 0.0);
  EXPECT_NEAR(link.cost, 0.6 / 3.0 / 4.0, 1e-12);
  ASSERT_EQ(ids_of(linked), (std::vector<std::int64_t>{1}));
  const auto& points = linked.history.tracks[0].points;
  ASSERT_EQ(points.size(), 20U);
  EXPECT_EQ(points[9].index, 9);
  EXPECT_EQ(points[10].index, 15);
  EXPECT_TRUE(linked.dropped.empty());
}

TEST(LinkTracks, WeighsTheFourDifferences) {
  // The end is at 36 px and the start at 60 + 20; over the 0.6 s between them the two go 0.3 * 40 + 0.3 * 60 = 30 px:
  // 14 px are left, 0.35 sizes of 40 px, of 0.75 + 0.5 * 0.6 = 1.05 allowed. The velocities differ by 20 px/s = 0.5
  // sizes/s of 1, the colours by 51 / 255 = 0.2 of 0.3, and the gap is 0.6 s of 3: the mean of 0.2, 1/3, 0.5 and 2/3.
  const Linked linked = link_tracks(broken({80, 0}, {60, 0}, {100, 151, 100}), keep_all());
  ASSERT_EQ(linked.links.size(), 1U);
  const Link& link = linked.links[0];
  EXPECT_NEAR(link.gap_s, 0.6, 1e-12);
  EXPECT_NEAR(link.distance, 0.35, 1e-12);
  EXPECT_NEAR(link.speed_difference, 0.5, 1e-12);
  EXPECT_NEAR(link.color_difference, 0.2, 1e-12);
  EXPECT_NEAR(link.cost, 0.425, 1e-12);
}

/// Whether the two tracks of `history` become one with `options`, and not with `limit` a little smaller.
void expect_limit(const History& history, double LinkOptions::*limit, double value) {
  LinkOptions options = keep_all();
  options.max_cost = 1.0;
  options.*limit = value * 1.001;
  EXPECT_EQ(link_tracks(history, options).links.size(), 1U);
  options.*limit = value * 0.999;
  EXPECT_EQ(link_tracks(history, options).links.size(), 0U);
}

TEST(LinkTracks, ALimitEach) {
  expect_limit(broken(), &LinkOptions::max_gap_s, 0.6);
  expect_limit(broken({60, 40}), &LinkOptions::max_distance, 1.0 - 0.5 * 0.6);
  expect_limit(broken({60, 40}), &LinkOptions::max_distance_growth, 0.25 / 0.6);
  expect_limit(broken({60 + 0.3 * 28, 0}, {68, 0}), &LinkOptions::max_speed_difference, 0.7);
  expect_limit(broken({60, 0}, {40, 0}, {149, 136, 120}), &LinkOptions::max_color_difference,
               std::sqrt(49.0 * 49.0 + 36.0 * 36.0 + 20.0 * 20.0) / 255.0);
  expect_limit(broken(), &LinkOptions::max_cost, 0.05);
}

TEST(LinkTracks, AGapOfExactlyTheLimitIsTaken) {
  LinkOptions options = keep_all();
  options.max_gap_s = 0.6;
  EXPECT_EQ(link_tracks(broken(), options).links.size(), 1U);
  options.max_gap_s = 0.0;
  EXPECT_TRUE(link_tracks(broken(), options).links.empty());
}

TEST(LinkTracks, TheSpeedsDirectionCounts) {
  // It comes back: the velocities differ by two sizes a second.
  EXPECT_TRUE(link_tracks(broken({36, 0}, {-40, 0}), keep_all()).links.empty());
}

TEST(LinkTracks, TheVelocityIsThatOfThePositions) {
  // The recorded one may be that of a filter that has not settled.
  History history = broken();
  for (TrackPoint& point : history.tracks[1].points) point.velocity_px_per_s = {};
  ASSERT_EQ(link_tracks(history, keep_all()).links.size(), 1U);
  EXPECT_NEAR(link_tracks(history, keep_all()).links[0].speed_difference, 0.0, 1e-12);
  // A single point has none but that: it stands, one size a second slower.
  history.tracks[1].points.resize(1);
  LinkOptions options = keep_all();
  options.max_speed_difference = 2.0;
  ASSERT_EQ(link_tracks(history, options).links.size(), 1U);
  EXPECT_NEAR(link_tracks(history, options).links[0].speed_difference, 1.0, 1e-12);
}

TEST(LinkTracks, OnlyTheEndsCount) {
  // The first track runs to the left for a second before it walks to the right for one.
  RecordedTrack first = track_of({1, 0, 9, {40, 0}, {-40, 0}});
  const RecordedTrack turned = track_of({1, 10, 20, {0, 0}});
  first.points.insert(first.points.end(), turned.points.begin(), turned.points.end());
  const History history{{first, track_of({2, 26, 35, {64, 0}})}};
  LinkOptions options = keep_all();
  options.max_speed_difference = 0.5;
  ASSERT_EQ(link_tracks(history, options).links.size(), 1U);
  EXPECT_NEAR(link_tracks(history, options).links[0].speed_difference, 0.0, 1e-9);
  options.end_s = 2.0;
  EXPECT_TRUE(link_tracks(history, options).links.empty());
}

TEST(LinkTracks, WhatOverlapsIsNeverJoined) {
  for (const int first : {5, 9}) {
    const History history{{track_of({1, 0, 9, {0, 0}}), track_of({2, first, first + 9, {4.0 * first, 0}})}};
    EXPECT_TRUE(link_tracks(history, keep_all()).links.empty()) << first;
  }
  const History next{{track_of({1, 0, 9, {0, 0}}), track_of({2, 10, 19, {40, 0}})}};
  EXPECT_EQ(link_tracks(next, keep_all()).links.size(), 1U);
}

TEST(LinkTracks, AChainIsOneTrackWithTheIdOfItsFirst) {
  // The ids say nothing about the order.
  const History history{{track_of({7, 30, 39, {120, 0}}), track_of({9, 0, 9, {0, 0}}), track_of({4, 15, 24, {60, 0}})}};
  const Linked linked = link_tracks(history, keep_all());
  EXPECT_EQ(pairs_of(linked), (Pairs{{9, 4}, {4, 7}}));
  ASSERT_EQ(ids_of(linked), (std::vector<std::int64_t>{9}));
  EXPECT_EQ(linked.history.tracks[0].points.size(), 30U);
  EXPECT_NO_THROW(check_history(linked.history));
}

TEST(LinkTracks, OneToOneForTheLeastTotal) {
  // Two walk side by side, 20 px apart, and break at once; each alone could follow either.
  const History history{{track_of({1, 0, 9, {0, 0}}), track_of({2, 0, 9, {0, 20}}), track_of({3, 15, 24, {60, 4}}),
                         track_of({4, 15, 24, {60, 16}})}};
  EXPECT_EQ(pairs_of(link_tracks(history, keep_all())), (Pairs{{1, 3}, {2, 4}}));
  // Where there is one successor only, the nearer one has it.
  History fewer = history;
  fewer.tracks.erase(fewer.tracks.begin() + 2);
  EXPECT_EQ(pairs_of(link_tracks(fewer, keep_all())), (Pairs{{2, 4}}));
}

TEST(LinkTracks, ShortTracksAreDroppedAfterJoining) {
  // Two pieces of 0.2 s, 8 px each, make a track of 0.9 s and 36 px; 5 stays alone.
  const History history{{track_of({2, 0, 2, {0, 0}}), track_of({3, 7, 9, {28, 0}}), track_of({5, 0, 2, {0, 500}})}};
  const Linked linked = link_tracks(history);
  EXPECT_EQ(pairs_of(linked), (Pairs{{2, 3}}));
  EXPECT_EQ(ids_of(linked), (std::vector<std::int64_t>{2}));
  ASSERT_EQ(linked.dropped.size(), 1U);
  EXPECT_EQ(linked.dropped[0].id, 5);
  EXPECT_EQ(linked.dropped[0].frames, 3);
  EXPECT_NEAR(linked.dropped[0].duration_s, 0.2, 1e-12);
  EXPECT_NEAR(linked.dropped[0].travel, 8.0 / 40.0, 1e-12);
}

TEST(LinkTracks, EachMeasureOfShortnessDrops) {
  // 10 frames, 0.9 s, 36 px = 0.9 sizes.
  const History history{{track_of({1, 0, 9, {0, 0}})}};
  const auto kept = [&](int frames, double seconds, double travel) {
    LinkOptions options;
    options.min_frames = frames;
    options.min_s = seconds;
    options.min_travel = travel;
    return link_tracks(history, options).history.tracks.size() == 1;
  };
  EXPECT_TRUE(kept(0, 0.0, 0.0));
  EXPECT_TRUE(kept(10, 0.9, 0.899));
  EXPECT_FALSE(kept(11, 0.0, 0.0));
  EXPECT_FALSE(kept(0, 0.91, 0.0));
  EXPECT_FALSE(kept(0, 0.0, 0.901));
}

TEST(LinkTracks, TravelIsTheFarthestPlaceNotTheLast) {
  RecordedTrack there = track_of({1, 0, 10, {0, 0}});
  const RecordedTrack back = track_of({1, 11, 20, {36, 0}, {-40, 0}});
  there.points.insert(there.points.end(), back.points.begin(), back.points.end());
  LinkOptions options = keep_all();
  options.min_travel = 1.1;
  const Linked linked = link_tracks({{there}}, options);
  ASSERT_EQ(linked.dropped.size(), 1U);
  EXPECT_NEAR(linked.dropped[0].travel, 1.0, 1e-12);
}

TEST(LinkTracks, EmptyHistory) {
  const Linked linked = link_tracks({});
  EXPECT_TRUE(linked.history.tracks.empty());
  EXPECT_TRUE(linked.links.empty());
  EXPECT_TRUE(linked.dropped.empty());
}

TEST(LinkTracks, RefusesBadOptionsAndHistories) {
  LinkOptions options;
  options.max_gap_s = -1.0;
  EXPECT_TRUE(contains(message_of<ConfigError>([&] { link_tracks({}, options); }), "max_gap_s: -1 is not allowed"));
  options = {};
  options.max_cost = std::nan("");
  EXPECT_TRUE(contains(message_of<ConfigError>([&] { link_tracks({}, options); }), "max_cost: nan"));
  History history = broken();
  history.tracks[1].id = 1;
  EXPECT_THROW(link_tracks(history), InputError);
}

TEST(LinkTracks, ExtremesStayNumbers) {
  History history = broken();
  // Times so close that a velocity overflows: nothing is joined, nothing breaks.
  history.tracks[0].points.resize(2);
  history.tracks[0].points[0].time_s = 0.0;
  history.tracks[0].points[1].time_s = 1e-320;
  history.tracks[0].points[1].position = {1e9, 1e9};
  EXPECT_TRUE(link_tracks(history, keep_all()).links.empty());
}

}  // namespace
}  // namespace survtrack
