// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

// The tracker with filters over boxes: a track's size is the filter's.

#include <gtest/gtest.h>

#include "box_run.hpp"

namespace survtrack {
namespace {

Config box_config() {
  Config config;
  config.set("filter.model=kalman_box");
  return config;
}

/// Comes towards the camera: 20x40 px, and 2 % more each frame.
Box coming(int k) {
  const double scale = 1.0 + 0.02 * k;
  return Box::around({100.0 + 3.0 * k, 100.0 + k}, 20.0 * scale, 40.0 * scale);
}

TEST(BoxFilter, ASizeThatGrowsIsFollowedAndGoesOnWhileLost) {
  BoxRun filtered(box_config(), 0.1, 640, 480), mean(Config{}, 0.1, 640, 480);
  for (int k = 0; k < 60; ++k) {
    filtered.frame({coming(k)});
    mean.frame({coming(k)});
  }
  const Box truth = coming(59);
  const auto off = [&](const BoxRun& run) { return truth.height - run.result().tracks.at(0).box.height; };
  EXPECT_LT(std::abs(off(filtered)), 1.0);
  EXPECT_GT(off(mean), 2.0);  // a running mean stays behind
  filtered.frame({});
  mean.frame({});
  const double last = mean.result().tracks.at(0).box.height;
  mean.frame({});
  filtered.frame({});
  EXPECT_EQ(mean.result().tracks.at(0).box.height, last);
  EXPECT_GT(filtered.result().tracks.at(0).box.height, truth.height + 0.3);
  EXPECT_GT(iou(filtered.result().tracks.at(0).box, coming(61)), iou(mean.result().tracks.at(0).box, coming(61)));
}

TEST(BoxFilter, ATrackBeginsWithTheDetectionsBox) {
  BoxRun run(box_config(), 0.1, 640, 480);
  run.frame({Box{30.0, 40.0, 12.0, 50.0}});
  ASSERT_EQ(run.result().tentative.size(), 1U);
  EXPECT_EQ(run.result().tentative[0].box, (Box{30.0, 40.0, 12.0, 50.0}));
}

}  // namespace
}  // namespace survtrack
