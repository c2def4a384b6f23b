// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

// Two tracks whose beliefs meet on one blob (Narayana 2007, 8.1).

#include "survtrack/tracking/convergence.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "../association/cost_tables.hpp"
#include "box_run.hpp"
#include "counted_config.hpp"

namespace survtrack {
namespace {

using Ids = std::vector<std::int64_t>;

/// Beliefs and assignments made by hand, of tracks 1, 2, ...
class Watch {
 public:
  explicit Watch(int tracks, int tentative = 0)
      : table_(MeanVelocityOptions{}, CentroidOptions{}, NoReentryOptions{}, 0.1) {
    Detections detections;
    for (int i = 0; i < tracks + tentative; ++i) detections.items.push_back(blob_at(30.0 * i, 50.0));
    for (int i = 0; i < tracks + tentative; ++i) table_.start(i, detections);
    for (int i = 0; i < tracks; ++i) table_.believe(i);
  }

  /// "1 2 on 0" for tracks 1 and 2 that met on blob 0.
  std::string met(const CostMatrix& beliefs, const Assignment& assignment) {
    Matches matches;
    matches.detection_of_track = assignment;
    watch_.update(table_, beliefs, matches);
    std::string text;
    for (const Convergence& one : watch_.met()) {
      text += text.empty() ? "" : ", ";
      for (const std::int64_t id : one.track_ids) text += std::to_string(id) + " ";
      text += "on " + std::to_string(one.detection);
    }
    return text;
  }
  void clear() { watch_.clear(); }
  void close(int row) {
    table_.set_status(row, TrackStatus::closed);
    table_.remove_closed();
  }

 private:
  TrackTable table_;
  ConvergenceWatch watch_;
};

// Columns: blobs, and "lost".
const auto apart = [] { return costs_of({{0.8, 0.1, 0.1}, {0.1, 0.8, 0.1}}); };
const auto on_one = [] { return costs_of({{0.9, 0.1}, {0.8, 0.2}}); };

TEST(Convergence, IsToldOnceUntilBothHaveABlobOfTheirOwn) {
  Watch watch(2);
  EXPECT_EQ(watch.met(apart(), {0, 1}), "");
  EXPECT_EQ(watch.met(on_one(), {0, -1}), "1 2 on 0");
  EXPECT_EQ(watch.met(on_one(), {0, -1}), "");
  EXPECT_EQ(watch.met(on_one(), {-1, 0}), "");
  EXPECT_EQ(watch.met(apart(), {0, 1}), "");
  EXPECT_EQ(watch.met(on_one(), {0, -1}), "1 2 on 0");
}

TEST(Convergence, ATrackWithoutABlobForAWhileHasNotParted) {
  Watch watch(2);
  EXPECT_EQ(watch.met(on_one(), {0, -1}), "1 2 on 0");
  EXPECT_EQ(watch.met(costs_of({{0.9, 0.1}, {0.1, 0.9}}), {0, -1}), "");
  EXPECT_EQ(watch.met(on_one(), {0, -1}), "");
}

TEST(Convergence, OfThreeIsOneEvent) {
  Watch watch(3);
  EXPECT_EQ(watch.met(costs_of({{0.9, 0.1}, {0.8, 0.2}, {0.6, 0.4}}), {0, -1, -1}), "1 2 3 on 0");
}

TEST(Convergence, OfAThirdWithTwoThatMetIsNews) {
  Watch watch(3);
  EXPECT_EQ(watch.met(costs_of({{0.9, 0.1}, {0.8, 0.2}, {0.2, 0.8}}), {0, -1, -1}), "1 2 on 0");
  EXPECT_EQ(watch.met(costs_of({{0.9, 0.1}, {0.8, 0.2}, {0.6, 0.4}}), {0, -1, -1}), "1 2 3 on 0");
}

TEST(Convergence, OfTwoPairsAreTwoEvents) {
  Watch watch(4);
  const CostMatrix beliefs = costs_of({{0.8, 0.1, 0.1}, {0.1, 0.8, 0.1}, {0.7, 0.1, 0.2}, {0.1, 0.7, 0.2}});
  EXPECT_EQ(watch.met(beliefs, {0, 1, -1, -1}), "1 3 on 0, 2 4 on 1");
}

TEST(Convergence, TracksThatBelieveToBeLostMeetNoOne) {
  Watch watch(2);
  EXPECT_EQ(watch.met(costs_of({{0.9, 0.1}, {0.4, 0.6}}), {0, -1}), "");
  EXPECT_EQ(watch.met(costs_of({{0.9, 0.1}, {0.5, 0.5}}), {0, -1}), "");  // no more probable than "lost"
  EXPECT_EQ(watch.met(costs_of({{1.0}, {1.0}}), {-1, -1}), "");           // no blob at all
}

TEST(Convergence, TentativeTracksMeetNoOne) {
  Watch watch(1, 1);
  EXPECT_EQ(watch.met(on_one(), {0, -1}), "");
}

TEST(Convergence, IsToldOnceWhileBothPreferOneBlobThoughEachGetsItsOwn) {
  const auto both_prefer_the_first = costs_of({{0.8, 0.1, 0.1}, {0.5, 0.4, 0.1}});
  Watch watch(2);
  watch.met(both_prefer_the_first, {0, 1});
  EXPECT_EQ(watch.met(both_prefer_the_first, {0, 1}), "");
  EXPECT_EQ(watch.met(both_prefer_the_first, {0, 1}), "");
}

TEST(Convergence, ClearForgets) {
  Watch watch(2);
  watch.met(on_one(), {0, -1});
  watch.clear();
  EXPECT_EQ(watch.met(on_one(), {0, -1}), "1 2 on 0");
}

TEST(Convergence, OfManyTracksOnOneBlob) {
  constexpr int count = 400;
  Watch watch(count);
  CostMatrix beliefs;
  beliefs.resize(count, 2);
  for (int r = 0; r < count; ++r) {
    beliefs(r, 0) = 0.9;
    beliefs(r, 1) = 0.1;
  }
  Assignment assignment(count, -1);
  assignment[0] = 0;
  EXPECT_EQ(watch.met(beliefs, assignment).rfind("1 2 3 4 ", 0), 0U);
  EXPECT_EQ(watch.met(beliefs, assignment), "");
}

// ---------------------------------------------------------------- as events

/// Two blobs at these distances from the middle; at 0 there is one.
std::vector<Detection> two_blobs(double distance) {
  if (distance == 0.0) return {blob_at(150.0, 100.0)};
  return {blob_at(150.0 - distance, 100.0), blob_at(150.0 + distance, 100.0)};
}

TEST(Convergence, IsAnEventOfBothTracksThatWalkIntoOneBlob) {
  BoxRun run(belief_config(), 0.1, 320, 240);
  for (double distance = 40.0; distance > 5.0; distance -= 6.0) {
    const std::string events = events_of(run.see(two_blobs(distance)));
    EXPECT_EQ(events, distance == 40.0 ? "track_started 1, track_started 2" : "");
  }
  run.see(two_blobs(0.0));
  ASSERT_EQ(events_of(run.result()), "track_lost 2, converged 1");
  const Event& event = run.result().events[1];
  EXPECT_EQ(event.other_track_ids, (Ids{2}));
  EXPECT_EQ(event.position, (Point{150.0, 100.0}));
  EXPECT_EQ(event.box, two_blobs(0.0)[0].box);
  EXPECT_EQ(event.text, "tracks 1 and 2 met in one blob");
  EXPECT_EQ(event.index, run.result().index);
  EXPECT_EQ(event.time_s, run.result().time_s);
}

TEST(Convergence, IsAnEventAgainOnlyAfterTheyParted) {
  BoxRun run(belief_config(), 0.1, 320, 240);
  const auto converged = [&](const std::vector<double>& distances) {
    int events = 0;
    for (const double distance : distances) {
      for (const Event& event : run.see(two_blobs(distance)).events) events += event.kind == EventKind::converged;
    }
    return events;
  };
  EXPECT_EQ(converged({22.0, 16.0, 10.0}), 0);
  EXPECT_EQ(converged({0.0, 0.0, 0.0}), 1);
  EXPECT_EQ(converged({10.0, 16.0, 22.0, 16.0, 10.0}), 0);
  EXPECT_EQ(ids_of(run.result()), (Ids{1, 2}));
  EXPECT_EQ(converged({0.0, 0.0}), 1);
}

TEST(Convergence, IsNoEventWithoutBeliefs) {
  BoxRun run(counted_config(), 0.1, 320, 240);
  for (const double distance : {22.0, 16.0, 10.0, 0.0, 0.0}) {
    for (const Event& event : run.see(two_blobs(distance)).events) EXPECT_NE(event.kind, EventKind::converged);
  }
}

}  // namespace
}  // namespace survtrack
