// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

// The vicinity factor (Narayana 2007, 6), by one track whose displacements are known.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "../error_message.hpp"
#include "box_run.hpp"
#include "counted_config.hpp"

namespace survtrack {
namespace {

constexpr double exact = 1e-9;  // positions and times are rounded

Config grid_config(const GridVicinityOptions& options = {}) {
  Config config = counted_config();
  config.vicinity = options;
  config.outputs.vicinity = true;
  return config;
}

GridVicinityOptions form(VicinityForm form) {
  return {.form = form, .cell_px = 30, .max_factor = 5.0, .learning_rate = 0.1};
}

/// One blob that walks, in a frame of 320x240.
class Walk {
 public:
  explicit Walk(const Config& config, const Point& start = {45.0, 45.0}, int class_id = -1)
      : run_(config, 0.1, 320, 240), place_(start), class_id_(class_id) {
    step({0.0, 0.0});
  }

  void step(const Point& displacement) {
    place_ = place_ + displacement;
    Detection blob = blob_at(place_.x, place_.y);
    blob.class_id = class_id_;
    run_.see({blob});
  }
  void miss() { run_.see({}); }

  const TrackingResult& result() const { return run_.result(); }
  const VicinityGrid& grid() const { return run_.result().vicinity.at(-1); }
  const VicinityCell& cell() const { return run_.result().vicinity.at(class_id_).at(place_); }
  std::int64_t updates() const {
    std::int64_t sum = 0;
    for (const VicinityCell& each : run_.result().vicinity.at(class_id_).cells) sum += each.updates;
    return sum;
  }

 private:
  BoxRun run_;
  Point place_;
  int class_id_;
};

TEST(Vicinity, TheGridCoversTheFrame) {
  const VicinityGrid grid = Walk(grid_config()).grid();
  EXPECT_EQ(grid.rows, 8);
  EXPECT_EQ(grid.columns, 11);
  EXPECT_EQ(grid.cells.size(), 88U);
  EXPECT_EQ(grid.cell_px, 30);
  EXPECT_EQ(grid.frame_width, 320);
  EXPECT_EQ(grid.frame_height, 240);
  EXPECT_EQ(grid.max_factor, 5.0);
}

TEST(Vicinity, EveryCellStartsHalfWay) {
  // Eq. 6.1: (1 + 5) / 2.
  const VicinityGrid grid = Walk(grid_config()).grid();
  for (const VicinityCell& cell : grid.cells) {
    EXPECT_EQ(cell.factor_y, 3.0);
    EXPECT_EQ(cell.factor_x, 3.0);
    EXPECT_EQ(cell.updates, 0);
    EXPECT_FALSE(VicinityGrid::active(cell));
  }
}

TEST(Vicinity, APointBelongsToTheCellThatHoldsIt) {
  const VicinityGrid grid = Walk(grid_config()).grid();
  EXPECT_EQ(grid.index_of({0.0, 0.0}), 0U);
  EXPECT_EQ(grid.index_of({29.9, 29.9}), 0U);
  EXPECT_EQ(grid.index_of({30.0, 0.0}), 1U);
  EXPECT_EQ(grid.index_of({0.0, 30.0}), 11U);
  EXPECT_EQ(grid.index_of({319.0, 239.0}), 87U);
  EXPECT_EQ(grid.index_of({-500.0, 1e9}), 77U);  // outside: the nearest
}

// ---------------------------------------------------------------- forms

TEST(Vicinity, SettlingByHand) {
  Walk walk(grid_config(form(VicinityForm::settling)));
  walk.step({4.0, 2.0});  // the mean is the displacement: the target is the start
  EXPECT_NEAR(walk.cell().factor_x, 3.0, exact);
  EXPECT_NEAR(walk.cell().factor_y, 3.0, exact);
  walk.step({8.0, -1.0});  // means 6 and 1.5: targets 3 * 8 / 6 = 4 and 3 * 1 / 1.5 = 2
  EXPECT_NEAR(walk.cell().factor_x, 3.1, exact);
  EXPECT_NEAR(walk.cell().factor_y, 2.9, exact);
}

TEST(Vicinity, PublishedConstantByHand) {
  Walk walk(grid_config(form(VicinityForm::published_constant)));
  walk.step({2.0, 0.5});  // eq. 6.4: (2 - 1) * 5 * 0.1 and (0.5 - 1) * 5 * 0.1
  EXPECT_NEAR(walk.cell().factor_x, 3.5, exact);
  EXPECT_NEAR(walk.cell().factor_y, 2.75, exact);
  walk.step({-9.0, 0.0});
  EXPECT_EQ(walk.cell().factor_x, 5.0);  // clamped
  EXPECT_NEAR(walk.cell().factor_y, 2.25, exact);
}

TEST(Vicinity, PublishedMeanByHand) {
  Walk walk(grid_config(form(VicinityForm::published_mean)));
  walk.step({4.0, 2.0});
  EXPECT_NEAR(walk.cell().factor_x, 3.0, exact);
  EXPECT_NEAR(walk.cell().factor_y, 3.0, exact);
  walk.step({8.0, -1.0});  // means 6 and 1.5: (8 - 6) * 0.5 and (1 - 1.5) * 0.5
  EXPECT_NEAR(walk.cell().factor_x, 4.0, exact);
  EXPECT_NEAR(walk.cell().factor_y, 2.75, exact);
}

TEST(Vicinity, DisplacementsCountWithoutTheirSign) {
  // The erratum of eq. 6.4.
  for (const VicinityForm each : {VicinityForm::settling, VicinityForm::published_constant, VicinityForm::published_mean}) {
    Walk right(grid_config(form(each)));
    Walk left(grid_config(form(each)));
    for (const double size : {2.0, 3.0, 1.5}) {
      right.step({size, size / 2});
      left.step({-size, -size / 2});
      EXPECT_NEAR(right.cell().factor_x, left.cell().factor_x, exact);
      EXPECT_NEAR(right.cell().factor_y, left.cell().factor_y, exact);
    }
  }
}

TEST(Vicinity, PublishedConstantRunsToItsClamp) {
  // |d| = 1.1 adds 0.05 each time: from 3 to 5 in 40 updates, and no further.
  Walk walk(grid_config(form(VicinityForm::published_constant)));
  for (int i = 0; i < 39; ++i) walk.step({i % 2 == 0 ? 1.1 : -1.1, 0.0});
  EXPECT_NEAR(walk.cell().factor_x, 4.95, exact);
  walk.step({-1.1, 0.0});
  walk.step({1.1, 0.0});
  EXPECT_EQ(walk.cell().factor_x, 5.0);
  EXPECT_EQ(walk.cell().updates, 41);
  EXPECT_EQ(walk.cell().factor_y, 1.0);  // and without motion to the other one
}

TEST(Vicinity, SettlingDoesNot) {
  Walk walk(grid_config(form(VicinityForm::settling)));
  for (int i = 0; i < 400; ++i) {
    walk.step({i % 2 == 0 ? 1.1 : -1.1, 0.0});
    ASSERT_NEAR(walk.cell().factor_x, 3.0, exact);
    ASSERT_EQ(walk.cell().factor_y, 3.0);
  }
}

TEST(Vicinity, SettlingTellsNearFromFar) {
  // One moves 6 px a frame, the other 2: the mean is 4, the targets are 3 * 6 / 4 and 3 * 2 / 4.
  BoxRun run(grid_config(form(VicinityForm::settling)), 0.1, 320, 240);
  for (int i = 0; i < 200; ++i) {
    const int side = i % 2;
    run.see({blob_at(45.0 + 6.0 * side, 195.0), blob_at(255.0 + 2.0 * side, 15.0)});
  }
  const VicinityGrid& grid = run.result().vicinity.at(-1);
  EXPECT_NEAR(grid.at({45.0, 195.0}).factor_x, 4.5, 0.1);
  EXPECT_NEAR(grid.at({255.0, 15.0}).factor_x, 1.5, 0.1);
}

TEST(Vicinity, EveryFactorStaysBetween1AndTheLargest) {
  for (const VicinityForm each : {VicinityForm::settling, VicinityForm::published_constant, VicinityForm::published_mean}) {
    Walk walk(grid_config(form(each)), {160.0, 120.0});
    for (int i = 0; i < 200; ++i) {
      const double size = i % 7 == 0 ? 90.0 : i % 3 == 0 ? 0.0 : 3.0;
      walk.step({i % 14 < 7 ? size : -size, i % 2 == 0 ? size : -size});
      for (const VicinityCell& cell : walk.grid().cells) {
        ASSERT_GE(std::min(cell.factor_x, cell.factor_y), 1.0);
        ASSERT_LE(std::max(cell.factor_x, cell.factor_y), 5.0);
      }
    }
  }
}

// ---------------------------------------------------------------- what counts as an update

TEST(Vicinity, TheCellOfTheNewPositionLearns) {
  Walk walk(grid_config());
  walk.step({40.0, 0.0});
  EXPECT_EQ(walk.grid().at({45.0, 45.0}).updates, 0);
  EXPECT_EQ(walk.grid().at({85.0, 45.0}).updates, 1);
  EXPECT_TRUE(VicinityGrid::active(walk.grid().at({85.0, 45.0})));
  EXPECT_NEAR(walk.grid().at({85.0, 45.0}).mean_step_px, 40.0, exact);
}

TEST(Vicinity, AfterMissedFramesADisplacementIsNoFaster) {
  Walk walk(grid_config());
  walk.miss();
  walk.miss();
  EXPECT_EQ(walk.updates(), 0);
  walk.step({9.0, 12.0});  // in three frames
  EXPECT_EQ(walk.updates(), 1);
  EXPECT_NEAR(walk.cell().mean_step_px, 5.0, exact);
}

TEST(Vicinity, ACellKnowsTheMeanAndTheSpreadOfItsDisplacements) {
  Walk walk(grid_config());
  for (const double size : {3.0, 5.0, 3.0, 5.0}) walk.step({0.6 * size, 0.8 * size});
  EXPECT_EQ(walk.cell().updates, 4);
  EXPECT_NEAR(walk.cell().mean_step_px, 4.0, exact);
  EXPECT_NEAR(walk.cell().step_variance_px2, 1.0, exact);
}

TEST(Vicinity, RelativeSizeIsTheLengthOfTheFactor) {
  VicinityCell cell;
  cell.factor_y = 3.0;
  cell.factor_x = 4.0;
  EXPECT_DOUBLE_EQ(VicinityGrid::relative_size(cell), 5.0);
}

TEST(Vicinity, EachClassHasItsGrid) {
  Walk cars(grid_config(), {45.0, 45.0}, 7);
  cars.step({9.0, 0.0});
  EXPECT_EQ(cars.result().vicinity.size(), 2U);
  EXPECT_EQ(cars.updates(), 1);
  EXPECT_EQ(cars.grid().at({54.0, 45.0}).updates, 0);  // that of blobs without class
}

TEST(Vicinity, TentativeTracksTeachNothing) {
  Config config = grid_config();
  config.lifecycle = ConfirmAndLoseOptions{.confirm_matches = 3, .confirm_s = 0.0, .confirm_travel = 0.0};
  Walk walk(config);
  walk.step({2.0, 0.0});
  EXPECT_EQ(walk.updates(), 0);
  for (int i = 0; i < 3; ++i) walk.step({2.0, 0.0});
  EXPECT_GT(walk.updates(), 0);
}

TEST(Vicinity, TheExpectationHasTheGridOfBlobs) {
  Tracker tracker(grid_config());
  EXPECT_FALSE(tracker.predict(0.0).vicinity.has_value());
  TrackingResult result;
  tracker.update(detections_of({{40.0, 40.0, 9.0, 9.0}}, 0.0, 0, 320, 240), result);
  ASSERT_TRUE(tracker.predict(0.1).vicinity.has_value());
  EXPECT_EQ(tracker.predict(0.2).vicinity->rows, 8);
  tracker.reset();
  EXPECT_FALSE(tracker.predict(0.0).vicinity.has_value());
}

TEST(Vicinity, ResetForgetsTheGridsEvenInAResultUsedAgain) {
  Tracker tracker(grid_config());
  TrackingResult result;
  Detections detections = detections_of({{40.0, 40.0, 9.0, 9.0}}, 0.0, 0, 320, 240);
  for (int frame = 0; frame < 3; ++frame) {
    detections.time_s = 0.1 * frame;
    detections.items[0].class_id = 4;
    tracker.predict(detections.time_s);
    tracker.update(detections, result);
  }
  EXPECT_EQ(result.vicinity.size(), 2U);
  tracker.reset();
  tracker.predict(0.0);
  tracker.update(detections_of({}, 0.0, 0, 320, 240), result);
  EXPECT_EQ(result.vicinity.size(), 1U);
}

// ---------------------------------------------------------------- what is refused

TEST(Vicinity, AFrameOfUnknownSizeIsRefusedAndTheRunGoesOn) {
  Tracker tracker(grid_config());
  for (const auto& [width, height] : {std::pair{0, 0}, std::pair{320, 0}, std::pair{0, 240}}) {
    const Detections bad = detections_of({{40.0, 40.0, 9.0, 9.0}}, 0.0, 0, width, height);
    EXPECT_TRUE(contains(message_of<InputError>([&] { tracker.process(bad); }), "detections.frame_size: is not known",
                         "vicinity.model grid"));
  }
  EXPECT_NO_THROW(tracker.process(detections_of({}, 0.0, 0, 320, 240)));
}

TEST(Vicinity, ACellLargerThanTheFrameIsRefusedByName) {
  Tracker tracker(grid_config({.cell_px = 241}));
  EXPECT_TRUE(contains(message_of<InputError>([&] { tracker.process(detections_of({}, 0.0, 0, 320, 240)); }),
                       "vicinity.cell_px: 241 is larger than the frame of 320x240 px; expected at most 240"));
  Tracker whole(grid_config({.cell_px = 240}));
  EXPECT_NO_THROW(whole.process(detections_of({}, 0.0, 0, 320, 240)));
}

TEST(Vicinity, AnotherFrameSizeIsRefusedAndTheRunGoesOn) {
  Tracker tracker(grid_config());
  tracker.process(detections_of({}, 0.0, 0, 320, 240));
  EXPECT_TRUE(contains(message_of<InputError>([&] { tracker.process(detections_of({}, 0.1, 1, 640, 480)); }),
                       "frame: is 640x480", "320x240"));
  EXPECT_NO_THROW(tracker.process(detections_of({}, 0.1, 1, 320, 240)));
}

TEST(Vicinity, AnOutputOfAGridThatIsNotLearnedIsRefused) {
  Config config = grid_config();
  config.vicinity = NoVicinityOptions{};
  EXPECT_TRUE(contains(message_of<ConfigError>([&] { Tracker{config}; }), "outputs.vicinity: ", "vicinity.model"));
  config.outputs.vicinity = false;
  config.blobs.merge = CloseMergeOptions{.vicinity_scaled = true};
  EXPECT_TRUE(contains(message_of<ConfigError>([&] { Tracker{config}; }), "blobs.merge.vicinity_scaled: ", "vicinity.model"));
}

}  // namespace
}  // namespace survtrack
