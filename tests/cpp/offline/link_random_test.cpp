// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include "straight_tracks.hpp"
#include "survtrack/offline/link.hpp"

namespace survtrack {
namespace {

/// Short walks, close enough for many to fit several others.
History random_history(std::mt19937& random, int tracks, int frames, double room_px) {
  std::uniform_int_distribution<int> first(0, frames), length(0, 12);
  std::uniform_real_distribution<double> place(0.0, room_px), speed(-20.0, 20.0), channel(80.0, 130.0);
  History history;
  for (int id = 1; id <= tracks; ++id) {
    Walk walk;
    walk.id = id;
    walk.first = first(random);
    walk.last = walk.first + length(random);
    walk.start = {place(random), place(random)};
    walk.velocity_px_per_s = {speed(random), speed(random)};
    walk.color = {channel(random), channel(random), channel(random)};
    history.tracks.push_back(track_of(walk));
  }
  std::shuffle(history.tracks.begin(), history.tracks.end(), random);
  return history;
}

LinkOptions wide() {
  LinkOptions options;
  options.max_gap_s = 2.0;
  options.max_distance = 2.0;
  options.max_cost = 0.7;
  return options;
}

/// Everything that links say, to the bit.
std::vector<std::vector<double>> facts_of(const Linked& linked) {
  std::vector<std::vector<double>> facts;
  for (const Link& l : linked.links) {
    facts.push_back({static_cast<double>(l.earlier_id), static_cast<double>(l.later_id), l.gap_s, l.distance,
                     l.speed_difference, l.color_difference, l.cost});
  }
  for (const DroppedTrack& d : linked.dropped) {
    facts.push_back({static_cast<double>(d.id), static_cast<double>(d.frames), d.duration_s, d.travel});
  }
  for (const RecordedTrack& track : linked.history.tracks) {
    facts.push_back({static_cast<double>(track.id)});
    for (const TrackPoint& point : track.points) facts.back().push_back(point.position.x);
  }
  return facts;
}

TEST(LinkTracksAtRandom, EveryPointIsInOneTrackOrDropped) {
  std::mt19937 random(3);
  std::size_t links = 0, dropped_tracks = 0;
  for (int trial = 0; trial < 200; ++trial) {
    const History history = random_history(random, 40, 60, 150.0);
    const Linked linked = link_tracks(history, wide());
    EXPECT_NO_THROW(check_history(linked.history));
    std::map<std::int64_t, std::int64_t> chain_of;  // by piece, from the links
    for (const RecordedTrack& track : history.tracks) chain_of[track.id] = track.id;
    for (const Link& link : linked.links) chain_of[link.later_id] = chain_of[link.earlier_id];
    std::map<std::int64_t, std::multiset<double>> expected, got;
    for (const RecordedTrack& track : history.tracks) {
      for (const TrackPoint& point : track.points) expected[chain_of[track.id]].insert(point.position.x);
    }
    for (const DroppedTrack& track : linked.dropped) {
      EXPECT_EQ(expected[track.id].size(), static_cast<std::size_t>(track.frames));
      expected.erase(track.id);
    }
    for (const RecordedTrack& track : linked.history.tracks) {
      for (const TrackPoint& point : track.points) got[track.id].insert(point.position.x);
    }
    ASSERT_EQ(got, expected);
    links += linked.links.size();
    dropped_tracks += linked.dropped.size();
  }
  EXPECT_GT(links, 500U);
  EXPECT_GT(dropped_tracks, 100U);
}

TEST(LinkTracksAtRandom, TheOrderOfTheTracksDoesNotMatter) {
  std::mt19937 random(4);
  for (int trial = 0; trial < 50; ++trial) {
    History history = random_history(random, 40, 60, 150.0);
    const auto facts = facts_of(link_tracks(history, wide()));
    EXPECT_EQ(facts, facts_of(link_tracks(history, wide())));
    std::shuffle(history.tracks.begin(), history.tracks.end(), random);
    EXPECT_EQ(facts, facts_of(link_tracks(history, wide())));
  }
}

/// The cost of joining just these two; nothing where they may not be joined.
double cost_of(const RecordedTrack& a, const RecordedTrack& b, const LinkOptions& options) {
  const Linked linked = link_tracks({{a, b}}, options);
  if (linked.links.empty() || linked.links[0].earlier_id != a.id) return options.max_cost;
  return linked.links[0].cost;
}

/// The most that successors for the tracks from `row` on can save.
double best_saving(const std::vector<std::vector<double>>& savings, std::size_t row, std::vector<char>& taken) {
  if (row == savings.size()) return 0.0;
  double best = best_saving(savings, row + 1, taken);
  for (std::size_t column = 0; column < savings.size(); ++column) {
    if (taken[column] || savings[row][column] <= 0.0) continue;
    taken[column] = 1;
    best = std::max(best, savings[row][column] + best_saving(savings, row + 1, taken));
    taken[column] = 0;
  }
  return best;
}

TEST(LinkTracksAtRandom, NoOtherJoiningSavesMore) {
  std::mt19937 random(5);
  const LinkOptions options = wide();
  for (int trial = 0; trial < 150; ++trial) {
    const History history = random_history(random, 8, 40, 60.0);
    std::vector<std::vector<double>> savings(history.tracks.size(), std::vector<double>(history.tracks.size(), 0.0));
    for (std::size_t a = 0; a < savings.size(); ++a) {
      for (std::size_t b = 0; b < savings.size(); ++b) {
        if (a != b) savings[a][b] = options.max_cost - cost_of(history.tracks[a], history.tracks[b], options);
      }
    }
    std::vector<char> taken(savings.size(), char{0});
    double saved = 0.0;
    for (const Link& link : link_tracks(history, options).links) saved += options.max_cost - link.cost;
    ASSERT_NEAR(saved, best_saving(savings, 0, taken), 1e-9) << trial;
  }
}

TEST(LinkTracksAtRandom, ManyTracksInOnePlaceAreNoMatrix) {
  // Something flickers for hours, and each piece fits those after it: 30 000 tracks that hang together.
  std::mt19937 random(6);
  const History history = random_history(random, 30000, 300000, 30.0);
  const Linked linked = link_tracks(history, wide());
  EXPECT_GT(linked.links.size(), 5000U);
}

}  // namespace
}  // namespace survtrack
