// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "../error_message.hpp"
#include "straight_tracks.hpp"
#include "survtrack/core/errors.hpp"
#include "survtrack/offline/history.hpp"

namespace survtrack {
namespace {

History two_tracks() { return {{track_of({3, 0, 9, {0, 0}}), track_of({8, 5, 14, {100, 0}})}}; }

TEST(CheckHistory, TakesWhatIsRight) {
  EXPECT_NO_THROW(check_history({}));
  EXPECT_NO_THROW(check_history(two_tracks()));
}

struct Wrong {
  std::string name;
  std::function<void(History&)> spoil;
  std::vector<std::string> words;
};

class CheckHistoryRefuses : public testing::TestWithParam<Wrong> {};

TEST_P(CheckHistoryRefuses, NamesTrackAndFrame) {
  History history = two_tracks();
  GetParam().spoil(history);
  const std::string message = message_of<InputError>([&] { check_history(history); });
  for (const std::string& word : GetParam().words) EXPECT_TRUE(contains(message, word));
}

TrackPoint& fourth(History& history) { return history.tracks[0].points[4]; }

INSTANTIATE_TEST_SUITE_P(
    Kinds, CheckHistoryRefuses,
    testing::Values(
        Wrong{"IdTwice", [](History& h) { h.tracks[1].id = 3; }, {"track 3", "twice"}},
        Wrong{"IdBelowZero", [](History& h) { h.tracks[1].id = -1; }, {"track -1", "ids count from 0"}},
        Wrong{"NoPoints", [](History& h) { h.tracks[1].points.clear(); }, {"track 8", "no points"}},
        Wrong{"IndexBelowZero", [](History& h) { h.tracks[0].points[0].index = -1; }, {"track 3, frame index -1"}},
        Wrong{"SameFrameTwice", [](History& h) { fourth(h).index = 3; }, {"track 3, frame index 3", "after frame index 3"}},
        Wrong{"FrameBack", [](History& h) { fourth(h).index = 2; }, {"frame index 2", "after frame index 3", "must increase"}},
        Wrong{"TimeIsNan", [](History& h) { fourth(h).time_s = std::nan(""); }, {"track 3, frame index 4", "time_s nan"}},
        Wrong{"TimeBack", [](History& h) { fourth(h).time_s = 0.25; }, {"track 3, frame index 4", "0.25", "0.3 s in frame index 3"}},
        Wrong{"TimeStays", [](History& h) { fourth(h).time_s = h.tracks[0].points[3].time_s; }, {"track 3, frame index 4"}},
        Wrong{"TwoTimesInAFrame", [](History& h) { h.tracks[1].points[2].time_s = 0.71; },
              {"track 8, frame index 7", "0.71", "track 3 has 0.7 s in the same frame"}},
        Wrong{"LeftIsInfinite", [](History& h) { fourth(h).box.x = INFINITY; }, {"track 3, frame index 4", "left and top (inf, "}},
        Wrong{"WidthIsZero", [](History& h) { fourth(h).box.width = 0.0; }, {"width and height (0, 80)", "0.001 to 1e9"}},
        Wrong{"HeightIsNegative", [](History& h) { fourth(h).box.height = -2.0; }, {"width and height (20, -2)"}},
        Wrong{"PositionIsNan", [](History& h) { fourth(h).position.y = std::nan(""); }, {"frame index 4: position"}},
        Wrong{"VelocityIsInfinite", [](History& h) { fourth(h).velocity_px_per_s.x = -INFINITY; }, {"velocity_px_per_s (-inf, 0)"}},
        Wrong{"ColorAbove255", [](History& h) { fourth(h).mean_color.red = 256.0; }, {"mean_color (100, 100, 256)", "0 to 255"}},
        Wrong{"ColorIsNan", [](History& h) { fourth(h).mean_color.blue = std::nan(""); }, {"mean_color"}}),
    [](const auto& tested) { return tested.param.name; });

TEST(HistoryRecorder, TakesReportedTracksInOrder) {
  HistoryRecorder recorder;
  for (int k = 0; k < 3; ++k) {
    TrackingResult result;
    result.index = 10 + k;
    result.time_s = 0.5 * k;
    for (const std::int64_t id : {2, 5}) {
      Track track;
      track.id = id;
      track.reported = id == 2 || k == 1;
      track.box = {1.0 * k, 2, 3, 4};
      track.position = {9, 8};
      track.velocity_px_per_s = {7, 6};
      track.mean_color = {10, 20, 30};
      result.tracks.push_back(track);
    }
    recorder.add(result);
  }
  const History& history = recorder.history();
  ASSERT_EQ(history.tracks.size(), 2U);
  EXPECT_EQ(history.tracks[0].id, 2);
  ASSERT_EQ(history.tracks[0].points.size(), 3U);
  EXPECT_EQ(history.tracks[0].points[2].index, 12);
  EXPECT_EQ(history.tracks[0].points[2].time_s, 1.0);
  EXPECT_EQ(history.tracks[1].id, 5);
  ASSERT_EQ(history.tracks[1].points.size(), 1U);
  const TrackPoint& point = history.tracks[1].points[0];
  EXPECT_EQ(point.box, (Box{1, 2, 3, 4}));
  EXPECT_EQ(point.position, (Point{9, 8}));
  EXPECT_EQ(point.velocity_px_per_s, (Point{7, 6}));
  EXPECT_EQ(point.mean_color, (Color{10, 20, 30}));
  EXPECT_NO_THROW(check_history(history));
}

}  // namespace
}  // namespace survtrack
