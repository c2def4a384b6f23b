// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

#include "box_run.hpp"
#include "monitor_config.hpp"

namespace survtrack {
namespace {

Box at(double x, double y) { return Box::around({x, y}, 20.0, 20.0); }

/// The event of the only track that ends.
Event end_of(BoxRun& run, const std::vector<Box>& others) {
  for (int frame = 0; frame < 10; ++frame) {
    for (const Event& event : run.frame(others).events) {
      if (event.kind == EventKind::track_ended) return event;
    }
  }
  ADD_FAILURE() << "no track ended";
  return {};
}

TEST(LostPlace, AtTheBorderOfTheFrame) {
  BoxRun run(monitor_config(5), 0.1, 384, 288);
  for (int frame = 0; frame < 20; ++frame) run.frame({at(300.0 + 4.0 * frame, 100.0), at(100.0, 200.0)});
  const Event event = end_of(run, {at(100.0, 200.0)});
  EXPECT_EQ(event.track_id, 1);
  EXPECT_EQ(event.place, LostPlace::border);
  EXPECT_NE(event.text.find("at the border"), std::string::npos);
}

TEST(LostPlace, BehindAnotherObject) {
  BoxRun run(monitor_config(5), 0.1, 384, 288);
  // One walks up to another that stands, and disappears behind it.
  for (int frame = 0; frame < 20; ++frame) run.frame({at(100.0 + 4.0 * frame, 100.0), Box{180.0, 80.0, 40.0, 60.0}});
  const Event event = end_of(run, {Box{180.0, 80.0, 40.0, 60.0}});
  EXPECT_EQ(event.place, LostPlace::behind_object);
}

TEST(LostPlace, InTheOpen) {
  BoxRun run(monitor_config(5), 0.1, 384, 288);
  for (int frame = 0; frame < 20; ++frame) run.frame({at(200.0, 100.0), at(100.0, 200.0)});
  EXPECT_EQ(end_of(run, {at(100.0, 200.0)}).place, LostPlace::open);
}

TEST(LostPlace, NoiseThatRunsAwayDoesNotLeave) {
  // A filter of acceleration takes 2 px of noise for an acceleration, and 13 predictions carry it far.
  for (unsigned seed = 1; seed <= 20; ++seed) {
    BoxRun run(monitor_config(25), 0.04, 384, 288);
    std::minstd_rand random(seed);
    std::normal_distribution<double> noise(0.0, 2.0);
    const auto seen = [&](double x, double y) {
      const double dx = noise(random), dy = noise(random);
      return at(x + dx, y + dy);
    };
    for (int frame = 0; frame < 60; ++frame) run.frame({seen(190.0, 140.0), seen(100.0, 60.0)});
    LostPlace place = LostPlace::none;
    for (int frame = 0; frame < 30 && place == LostPlace::none; ++frame) {
      for (const Event& event : run.frame({seen(100.0, 60.0)}).events) {
        if (event.kind == EventKind::track_ended) place = event.place;
      }
    }
    EXPECT_EQ(place, LostPlace::open) << seed;
  }
}

TEST(LostPlace, AFastOneLeavesFromFarInside) {
  BoxRun run(monitor_config(5), 1.0, 384, 288);
  for (int frame = 0; frame < 6; ++frame) run.frame({at(40.0 + 60.0 * frame, 100.0), at(100.0, 200.0)});
  EXPECT_EQ(end_of(run, {at(100.0, 200.0)}).place, LostPlace::border) << "at 340 of 384, 60 px a frame";
}

TEST(LostPlace, WithoutAFrameThereIsNoBorder) {
  BoxRun run(monitor_config(5));
  for (int frame = 0; frame < 20; ++frame) run.frame({at(5.0, 5.0), at(100.0, 200.0)});
  EXPECT_EQ(end_of(run, {at(100.0, 200.0)}).place, LostPlace::open);
}

TEST(LostPlace, OtherEventsHaveNone) {
  BoxRun run(monitor_config(5), 0.1, 384, 288);
  for (const Event& event : run.frame({at(50.0, 50.0)}).events) EXPECT_EQ(event.place, LostPlace::none);
}

}  // namespace
}  // namespace survtrack
