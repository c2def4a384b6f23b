// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

// Tracks by the belief matrix (Narayana 2007, 8).

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "../error_message.hpp"
#include "box_run.hpp"
#include "counted_config.hpp"

namespace survtrack {
namespace {

using Ids = std::vector<std::int64_t>;

constexpr int width = 320;
constexpr int height = 240;

Config with(const BeliefOptions& options) {
  Config config = belief_config();
  config.cost = options;
  return config;
}

void expect_rows_of_probabilities(const TrackingResult& result, std::size_t blobs) {
  const CostMatrix& beliefs = result.beliefs;
  ASSERT_EQ(static_cast<std::size_t>(beliefs.rows()), result.matrix_track_ids.size());
  ASSERT_EQ(static_cast<std::size_t>(beliefs.columns()), blobs + 1);
  for (int r = 0; r < beliefs.rows(); ++r) {
    double sum = 0.0;
    for (int c = 0; c < beliefs.columns(); ++c) {
      ASSERT_GE(beliefs(r, c), 0.0);
      ASSERT_LE(beliefs(r, c), 1.0);
      sum += beliefs(r, c);
    }
    ASSERT_NEAR(sum, 1.0, 1e-12);
  }
}

/// In the order of rows each takes its best free blob, and is lost when "lost" is no less probable (3.5.4 and 8).
void expect_published_rule(const TrackingResult& result) {
  const CostMatrix& beliefs = result.beliefs;
  const int lost = beliefs.columns() - 1;
  std::vector<bool> taken(static_cast<std::size_t>(lost), false);
  for (int r = 0; r < beliefs.rows(); ++r) {
    int best = -1;
    for (int c = 0; c < lost; ++c) {
      if (taken[static_cast<std::size_t>(c)] || beliefs(r, c) <= beliefs(r, lost)) continue;
      if (best < 0 || beliefs(r, c) > beliefs(r, best)) best = c;
    }
    ASSERT_EQ(result.matches.detection_of_track[static_cast<std::size_t>(r)], best) << "row " << r;
    if (best >= 0) taken[static_cast<std::size_t>(best)] = true;
  }
}

// ---------------------------------------------------------------- the matrix

TEST(BeliefTracking, TheMatrixIsTracksByBlobsAndLost) {
  BoxRun run(belief_config(), 0.1, width, height);
  run.see({blob_at(50, 50), blob_at(150, 50)});
  EXPECT_EQ(run.result().beliefs.rows(), 0);
  EXPECT_TRUE(run.result().matrix_track_ids.empty());
  run.see({blob_at(52, 50), blob_at(148, 50), blob_at(250, 150)});
  EXPECT_EQ(run.result().matrix_track_ids, (Ids{1, 2}));
  EXPECT_EQ(run.result().costs.columns(), 3);
  expect_rows_of_probabilities(run.result(), 3);
  run.see({});
  EXPECT_EQ(run.result().matrix_track_ids, (Ids{1, 2, 3}));
  expect_rows_of_probabilities(run.result(), 0);
  for (int r = 0; r < 3; ++r) EXPECT_EQ(run.result().beliefs(r, 0), 1.0);
}

TEST(BeliefTracking, TheMatrixIsAnOutputThatIsAskedFor) {
  Config config = belief_config();
  config.outputs.cost_matrix = false;
  BoxRun run(config, 0.1, width, height);
  for (int frame = 0; frame < 3; ++frame) run.see({blob_at(50 + frame, 50)});
  EXPECT_EQ(run.result().beliefs.rows(), 0);
  EXPECT_EQ(run.result().costs.rows(), 0);
  EXPECT_EQ(run.result().matrix_track_ids, (Ids{1}));
}

TEST(BeliefTracking, OtherCostsHaveNoBeliefs) {
  Config config = counted_config();
  config.outputs.cost_matrix = true;
  BoxRun run(config, 0.1, width, height);
  for (int frame = 0; frame < 2; ++frame) run.see({blob_at(50 + frame, 50)});
  EXPECT_EQ(run.result().costs.rows(), 1);
  EXPECT_EQ(run.result().beliefs.rows(), 0);
  EXPECT_EQ(run.result().matrix_track_ids, (Ids{1}));
}

TEST(BeliefTracking, TentativeRowsAreNamed0) {
  Config config = belief_config();
  config.lifecycle = ConfirmAndLoseOptions{.confirm_matches = 3, .confirm_s = 0.0, .confirm_travel = 0.0};
  BoxRun run(config, 0.1, width, height);
  for (int frame = 0; frame < 4; ++frame) run.see({blob_at(50 + frame, 50)});
  run.see({blob_at(54, 50), blob_at(200, 50)});
  run.see({blob_at(55, 50), blob_at(201, 50)});
  EXPECT_EQ(run.result().matrix_track_ids, (Ids{1, 0}));
}

TEST(BeliefTracking, ABeliefByHand) {
  // A blob where it is expected, in its colour: densities at their peaks, over 0.1 each. Odds to "lost" 10 * 10.
  BoxRun run(belief_config(), 0.1, width, height);
  for (int frame = 0; frame < 2; ++frame) run.see({blob_at(50, 50)});
  EXPECT_NEAR(run.result().beliefs(0, 0), 100.0 / 101.0, 1e-12);
  EXPECT_NEAR(run.result().beliefs(0, 1), 1.0 / 101.0, 1e-12);
  EXPECT_NEAR(run.result().costs(0, 0), 1.0 / 101.0, 1e-12);
  // 15 grey levels in one channel are one scale: 1/e, and nearly so in the table.
  Detection blue = blob_at(50, 50);
  blue.mean_color.blue += 15.0;
  run.see({blue});
  EXPECT_NEAR(run.result().beliefs(0, 0) / run.result().beliefs(0, 1), 100.0 / std::exp(1.0), 0.2);
}

TEST(BeliefTracking, WeightsScaleTheDensities) {
  BoxRun run(with({.color_weight = 15.0, .position_weight = 60.0, .learn_after = 0}), 0.1, width, height);
  for (int frame = 0; frame < 2; ++frame) run.see({blob_at(50, 50)});
  // Three densities of colour by 1/2, two of position by 2: 10 / 8 and 10 * 4.
  EXPECT_NEAR(run.result().beliefs(0, 0) / run.result().beliefs(0, 1), 1.25 * 40.0, 1e-9);
}

TEST(BeliefTracking, WhatHasNoWeightIsNotLookedAt) {
  BoxRun run(with({.color_weight = 0.0, .position_weight = 0.0, .size_weight = 0.0, .learn_after = 0}), 0.1, width, height);
  run.see({blob_at(50, 50)});
  run.see({blob_at(50, 50), blob_at(250, 200, 10.0), blob_at(10, 200, 250.0)});
  for (int c = 0; c < 4; ++c) EXPECT_NEAR(run.result().beliefs(0, c), 0.25, 1e-15);
}

TEST(BeliefTracking, SizeIsLookedAtWhenItHasAWeight) {
  Detection large = blob_at(50, 50);
  large.box = Box::around({50, 50}, 30.0, 30.0);
  for (const double weight : {0.0, 30.0}) {
    BoxRun run(with({.size_weight = weight, .learn_after = 0}), 0.1, width, height);
    run.see({blob_at(50, 50)});
    run.see({blob_at(50, 50), large});
    const double ratio = run.result().beliefs(0, 0) / run.result().beliefs(0, 1);
    // ln(900 / 144) = 1.83 in scales of 0.4.
    EXPECT_NEAR(ratio, weight == 0.0 ? 1.0 : std::exp(std::log(900.0 / 144.0) / 0.4), 0.02 * ratio);
  }
}

TEST(BeliefTracking, ColourIsComparedInItsSpace) {
  for (const ColorSpace space : {ColorSpace::bgr, ColorSpace::hsv, ColorSpace::lab}) {
    BoxRun run(with({.color_space = space, .learn_after = 0}), 0.1, width, height);
    Detection red = blob_at(50, 50), green = blob_at(50, 50);
    red.mean_color = {20.0, 20.0, 200.0};
    green.mean_color = {20.0, 200.0, 20.0};
    run.see({red});
    run.see({green, red});
    expect_rows_of_probabilities(run.result(), 2);
    EXPECT_GT(run.result().beliefs(0, 1), 0.9);
  }
}

// ---------------------------------------------------------------- who is lost

TEST(BeliefTracking, ATrackIsLostWhenNoFreeBlobIsMoreProbable) {
  BoxRun run(belief_config(), 0.1, width, height);
  run.see({blob_at(50, 50, 60.0)});
  run.see({blob_at(50, 50, 60.0)});
  run.see({blob_at(50, 50, 200.0)});  // another thing in its place: exp(-3 * 140 / 15)
  EXPECT_LT(run.result().beliefs(0, 0), run.result().beliefs(0, 1));
  EXPECT_TRUE(std::isinf(run.result().costs(0, 0)));
  EXPECT_EQ(events_of(run.result()), "track_lost 1, track_started 2");
}

TEST(BeliefTracking, ATrackWhoseBestBlobIsTakenGetsTheNextOrIsLost) {
  BoxRun run(belief_config(), 0.1, width, height);
  for (int frame = 0; frame < 2; ++frame) run.see({blob_at(100, 50), blob_at(112, 50)});
  run.see({blob_at(108, 50)});
  EXPECT_EQ(run.result().matches.detection_of_track, (std::vector<int>{0, -1}));
  expect_published_rule(run.result());
  BoxRun other(belief_config(), 0.1, width, height);
  for (int frame = 0; frame < 2; ++frame) other.see({blob_at(100, 50), blob_at(112, 50)});
  other.see({blob_at(108, 50), blob_at(140, 50)});
  EXPECT_EQ(other.result().matches.detection_of_track, (std::vector<int>{0, 1}));
  expect_published_rule(other.result());
}

TEST(BeliefTracking, AFrozenTrackIsFoundAgainWhereItWasExpected) {
  BoxRun run(belief_config(), 0.1, width, height);
  for (int frame = 0; frame < 6; ++frame) run.see({blob_at(50 + 6 * frame, 50)});
  run.see({});
  run.see({});
  EXPECT_EQ(events_of(run.see({blob_at(98, 50)})), "track_recovered 1");
}

// ---------------------------------------------------------------- properties

TEST(BeliefTracking, RowsAreProbabilitiesAndTheRuleHoldsWhateverHappens) {
  std::mt19937 random(30);
  const auto below = [&](unsigned n) { return static_cast<double>(random() % n); };
  for (const BeliefOrder order : {BeliefOrder::free, BeliefOrder::published}) {
    for (const ColorSpace space : {ColorSpace::bgr, ColorSpace::hsv, ColorSpace::lab}) {
      BoxRun run(with({.order = order,
                       .velocity_break_point = 10.0,
                       .color_weight = 300.0,
                       .position_weight = 30.0,
                       .size_weight = 30.0,
                       .color_space = space,
                       .learn_after = 20}),
                 0.1, width, height);
      for (int frame = 0; frame < 60; ++frame) {
        std::vector<Detection> blobs;
        for (unsigned i = random() % 8; i > 0; --i) {
          Detection blob = blob_at(below(width), below(height));
          blob.box = Box::around(blob.position, 1e-3 + below(300), 1.0 + below(200));
          blob.mean_color = {below(256), below(256), below(256)};
          if (random() % 4 == 0) blob.position = {-1e8 + below(3) * 1e8, below(3) * 1e8};
          blobs.push_back(blob);
        }
        run.see(blobs);
        expect_rows_of_probabilities(run.result(), blobs.size());
        expect_published_rule(run.result());
      }
    }
  }
}

TEST(BeliefTracking, AThousandBlobs) {
  for (const BeliefOrder order : {BeliefOrder::free, BeliefOrder::published}) {
    BoxRun run(with({.order = order, .velocity_break_point = 10.0, .learn_after = 0}), 0.1, 1600, 1000);
    std::vector<Detection> blobs;
    for (int i = 0; i < 1000; ++i) blobs.push_back(blob_at(20 + i % 40 * 39, 20 + i / 40 * 39, 5.0 * (i % 50)));
    for (int frame = 0; frame < 3; ++frame) {
      run.see(blobs);
      for (Detection& blob : blobs) blob = blob_at(blob.position.x + 1.0, blob.position.y, blob.mean_color.red);
    }
    expect_rows_of_probabilities(run.result(), 1000);
    ASSERT_EQ(run.result().tracks.size(), 1000U);
    for (const Track& track : run.result().tracks) EXPECT_EQ(track.matched_frames, 3);
  }
}

TEST(BeliefTracking, HundredsOfBlobsInOnePlace) {
  BoxRun run(belief_config(), 0.1, width, height);
  const std::vector<Detection> blobs(300, blob_at(100, 100));
  for (int frame = 0; frame < 3; ++frame) run.see(blobs);
  expect_rows_of_probabilities(run.result(), blobs.size());
}

TEST(BeliefTracking, NoTracksAndNoBlobs) {
  BoxRun run(belief_config(), 0.1, width, height);
  for (int frame = 0; frame < 3; ++frame) EXPECT_EQ(events_of(run.see({})), "");
}

// ---------------------------------------------------------------- what is refused

TEST(BeliefTracking, AFrameOfUnknownSizeIsRefusedAndTheRunGoesOn) {
  Tracker tracker(belief_config()), quiet(belief_config());
  for (int frame = 0; frame < 3; ++frame) {
    const std::vector<Box> boxes = {{40.0 + frame, 40.0, 9.0, 9.0}};
    for (const auto& [w, h] : {std::pair{0, 0}, std::pair{320, 0}}) {
      EXPECT_TRUE(contains(
          message_of<InputError>([&] { tracker.process(detections_of(boxes, 0.1 * frame, frame, w, h)); }),
          "detections.frame_size: is not known", "cost.model belief"));
    }
    const Detections good = detections_of(boxes, 0.1 * frame, frame, width, height);
    TrackingResult result;
    ASSERT_NO_THROW(result = tracker.process(good));
    EXPECT_EQ(result.tracks.at(0).position, quiet.process(good).tracks.at(0).position);
  }
}

TEST(BeliefTracking, AColourBeyond0To255IsRefused) {
  Tracker tracker(with({.color_space = ColorSpace::hsv, .learn_after = 5}));
  for (const Color& bad : {Color{-5.0, -5.0, 0.0}, Color{0.0, 0.0, 1e308}, Color{0.0, 256.0, 0.0}}) {
    Detections detections = detections_of({{40.0, 40.0, 9.0, 9.0}}, 0.0, 0, width, height);
    detections.items[0].mean_color = bad;
    EXPECT_TRUE(contains(message_of<InputError>([&] { tracker.process(detections); }), "detections[0].mean_color: ",
                         "expected 0 to 255"));
  }
}

}  // namespace
}  // namespace survtrack
