// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "survtrack/tracking/reentry.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <vector>

#include "box_run.hpp"

namespace survtrack {
namespace {

OpenTrack ended(std::int64_t id, const Point& position, double time_s, const Color& color = {}) {
  OpenTrack row;
  row.track.id = id;
  row.width_px = row.height_px = 20.0;
  row.seen_position = position;
  row.track.mean_color = color;
  row.track.end_time_s = time_s;
  return row;
}

/// The identity of someone who comes alone; nothing for someone new.
std::optional<ReentryMemory::Identity> claim(ReentryMemory& memory, const OpenTrack& newcomer) {
  const auto identity = memory.claim({&newcomer}).front();
  if (identity.id == 0) return std::nullopt;
  return identity;
}

OpenTrack newcomer(const Point& position, double time_s, const Color& color = {}) {
  OpenTrack row;
  row.width_px = row.height_px = 20.0;
  row.start_position = position;
  row.track.mean_color = color;
  row.track.start_time_s = time_s;
  return row;
}

// By hand: w = exp(-(d / (s_d size))^2 / 2 - (c / s_c)^2 / 2 - t / T), confidence = w / (w + 0.2).
TEST(Reentry, ConfidenceIsAPartOfAllWeights) {
  ReentryMemory memory({.away_time_s = 30.0, .place_deviation = 1.5, .color_deviation = 0.1, .newcomer_weight = 0.2});
  memory.remember(ended(7, {100.0, 50.0}, 10.0, {100.0, 100.0, 100.0}));
  const auto found = claim(memory, newcomer({115.0, 50.0}, 16.0, {100.0, 100.0, 110.2}));
  ASSERT_TRUE(found);
  EXPECT_EQ(found->id, 7);
  const double w = std::exp(-0.5 * 0.25 - 0.5 * 0.16 - 0.2);  // 15 px of 30; 0.04 of 0.1; 6 s of 30
  EXPECT_NEAR(found->confidence, w / (w + 0.2), 1e-12);
  EXPECT_FALSE(claim(memory, newcomer({115.0, 50.0}, 16.0, {100.0, 100.0, 110.2}))) << "nobody comes back twice";
}

TEST(Reentry, TwoWhoLookTheSameAreNotToldApart) {
  ReentryMemory memory({.min_confidence = 0.5});
  memory.remember(ended(1, {100.0, 50.0}, 10.0));
  memory.remember(ended(2, {100.0, 50.0}, 10.0));
  EXPECT_FALSE(claim(memory, newcomer({100.0, 50.0}, 11.0)));
}

// By hand: at one place weights are e^0 and e^(-1/2), for 1.5 sizes of 20 px; no time passes that counts.
TEST(Reentry, OfTwoNewcomersTheNearerIsTheOneWhateverTheirOrder) {
  const OpenTrack near = newcomer({100.0, 50.0}, 11.0), far = newcomer({130.0, 50.0}, 11.0);
  const double w = 1.0, other = std::exp(-0.5);
  for (const bool near_first : {true, false}) {
    ReentryMemory memory({.away_time_s = 1e6, .newcomer_weight = 0.05});
    memory.remember(ended(1, {100.0, 50.0}, 10.0));
    const auto found = memory.claim(near_first ? std::vector{&near, &far} : std::vector{&far, &near});
    EXPECT_EQ(found[near_first ? 0 : 1].id, 1);
    EXPECT_NEAR(found[near_first ? 0 : 1].confidence, w / (0.05 + w + other), 1e-5);
    EXPECT_EQ(found[near_first ? 1 : 0].id, 0);
  }
}

TEST(Reentry, PlaceTimeAndColorEachTellSomeoneNew) {
  ReentryMemory memory({.max_away_s = 60.0});
  memory.remember(ended(1, {100.0, 50.0}, 10.0, {100.0, 100.0, 100.0}));
  EXPECT_FALSE(claim(memory, newcomer({250.0, 50.0}, 11.0, {100.0, 100.0, 100.0})));
  EXPECT_FALSE(claim(memory, newcomer({100.0, 50.0}, 71.0, {100.0, 100.0, 100.0})));
  EXPECT_FALSE(claim(memory, newcomer({100.0, 50.0}, 11.0, {200.0, 100.0, 100.0})));
  EXPECT_FALSE(claim(memory, newcomer({100.0, 50.0}, 9.0, {100.0, 100.0, 100.0}))) << "it was there when the other was";
  EXPECT_TRUE(claim(memory, newcomer({100.0, 50.0}, 11.0, {100.0, 100.0, 100.0})));
}

TEST(Reentry, WhoWalkedOnMayComeBackFurtherOn) {
  OpenTrack walker = ended(1, {100.0, 50.0}, 10.0);
  walker.seen_velocity_px_per_s = {60.0, 0.0};
  ReentryMemory memory({});
  memory.remember(walker);
  EXPECT_TRUE(claim(memory, newcomer({190.0, 50.0}, 11.5)));
}

TEST(Reentry, TheForgottenAreForgotten) {
  ReentryMemory memory({.max_away_s = 5.0});
  memory.remember(ended(1, {100.0, 50.0}, 10.0));
  memory.remember(ended(2, {300.0, 50.0}, 20.0));
  EXPECT_FALSE(claim(memory, newcomer({100.0, 50.0}, 15.1)));
  memory.clear();
  EXPECT_FALSE(claim(memory, newcomer({300.0, 50.0}, 21.0)));
}

/// Walks out on the right, stays away, and walks in again at the same place.
std::vector<Event> events_of_a_return(const ReentryOptions& reentry, std::vector<std::int64_t>& ids) {
  Config config;
  config.reentry = reentry;
  BoxRun run(config, 0.1, 320, 240);
  std::vector<Event> events;
  for (int frame = 0; frame < 120; ++frame) {
    const double x = frame < 40 ? 150.0 + 4.0 * frame : 300.0 - 4.0 * (frame - 80);
    const bool away = frame >= 40 && frame < 80;
    const TrackingResult result =
        away ? run.frame(std::vector<Box>{}) : run.frame({Box::around({x, 100.0}, 20.0, 40.0)});
    events.insert(events.end(), result.events.begin(), result.events.end());
    for (const Track& track : result.tracks) {
      if (ids.empty() || ids.back() != track.id) ids.push_back(track.id);
    }
  }
  return events;
}

std::optional<Event> first(const std::vector<Event>& events, EventKind kind) {
  for (const Event& event : events) {
    if (event.kind == kind) return event;
  }
  return std::nullopt;
}

TEST(Reentry, WhoLeavesAndComesBackHasItsIdentityAgain) {
  std::vector<std::int64_t> ids;
  const std::vector<Event> events = events_of_a_return(RememberOptions{}, ids);
  EXPECT_EQ(ids, (std::vector<std::int64_t>{1}));
  const auto back = first(events, EventKind::track_reentered);
  ASSERT_TRUE(back);
  EXPECT_EQ(back->track_id, 1);
  EXPECT_GT(back->confidence, 0.5);
  EXPECT_LT(back->confidence, 1.0);
  EXPECT_EQ(back->text.rfind("track 1 came back, to ", 0), 0U) << back->text;
}

TEST(Reentry, WithoutItWhoComesBackIsNew) {
  std::vector<std::int64_t> ids;
  const std::vector<Event> events = events_of_a_return(NoReentryOptions{}, ids);
  EXPECT_EQ(ids, (std::vector<std::int64_t>{1, 2}));
  EXPECT_FALSE(first(events, EventKind::track_reentered));
  for (const Event& event : events) EXPECT_EQ(event.confidence, 1.0);
}

}  // namespace
}  // namespace survtrack
