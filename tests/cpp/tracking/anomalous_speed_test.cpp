// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

// A displacement against the mean and the spread of its cell (Narayana 2007, 11.3).

#include <gtest/gtest.h>

#include <string>

#include "box_run.hpp"
#include "counted_config.hpp"

namespace survtrack {
namespace {

Config config_of(const GridVicinityOptions& options) {
  Config config = counted_config();
  config.vicinity = options;
  return config;
}

/// One blob that goes to and fro within a cell of 100 px.
class ToAndFro {
 public:
  explicit ToAndFro(const GridVicinityOptions& options) : run_(config_of(options), 0.1, 320, 240) { see(); }

  /// The events of so many steps of one size.
  std::string steps(int count, double size) {
    std::string events;
    for (int i = 0; i < count; ++i) {
      x_ += x_ > 150.0 ? -size : size;
      const std::string now = see();
      events += (events.empty() || now.empty() ? "" : ", ") + now;
    }
    return events;
  }

 private:
  std::string see() { return events_of(run_.see({blob_at(x_, 150.0)})); }

  BoxRun run_;
  double x_ = 140.0;
};

GridVicinityOptions options(int frames = 3) {
  return {.cell_px = 100,
          .anomaly_deviations = 4.0,
          .anomaly_after_updates = 50,
          .anomaly_frames = frames};
}

TEST(AnomalousSpeed, IsRaisedOnceARunAfterSomeFrames) {
  ToAndFro blob(options(3));
  EXPECT_EQ(blob.steps(200, 4.0), "");
  EXPECT_EQ(blob.steps(2, 30.0), "");
  EXPECT_EQ(blob.steps(1, 30.0), "anomalous_speed 1");
  EXPECT_EQ(blob.steps(2, 30.0), "");
}

TEST(AnomalousSpeed, IsRaisedAgainInAnotherRun) {
  ToAndFro blob(options(2));
  EXPECT_EQ(blob.steps(500, 4.0), "");
  EXPECT_EQ(blob.steps(3, 30.0), "anomalous_speed 1");
  EXPECT_EQ(blob.steps(5, 4.0), "");
  EXPECT_EQ(blob.steps(3, 30.0), "anomalous_speed 1");
}

TEST(AnomalousSpeed, IsThatOfTheSlowToo) {
  ToAndFro blob(options(3));
  blob.steps(200, 30.0);
  EXPECT_EQ(blob.steps(3, 1.0), "anomalous_speed 1");
}

TEST(AnomalousSpeed, NeedsEnoughUpdatesInItsCell) {
  ToAndFro blob(options(1));
  EXPECT_EQ(blob.steps(49, 4.0), "");
  EXPECT_EQ(blob.steps(1, 30.0), "");  // the 50th: 49 before it
  ToAndFro one_more(options(1));
  EXPECT_EQ(one_more.steps(50, 4.0), "");
  EXPECT_EQ(one_more.steps(1, 30.0), "anomalous_speed 1");
}

TEST(AnomalousSpeed, IsNotTheSpreadOfTheCell) {
  ToAndFro blob(options(1));
  for (int i = 0; i < 100; ++i) EXPECT_EQ(blob.steps(1, i % 2 == 0 ? 3.0 : 9.0), "");
  EXPECT_EQ(blob.steps(1, 15.0), "");  // mean 6, deviation 3
  EXPECT_EQ(blob.steps(1, 40.0), "anomalous_speed 1");
}

TEST(AnomalousSpeed, IsNotTheJitterOfACentroid) {
  ToAndFro blob(options(1));
  blob.steps(100, 4.0);
  EXPECT_EQ(blob.steps(20, 5.5), "");  // no cell is known to less than half a pixel
}

TEST(AnomalousSpeed, IsRaisedHoweverManyFramesItNeeds) {
  // What is anomalous must not become the rule before it is told.
  ToAndFro blob(options(10));
  blob.steps(60, 4.0);
  EXPECT_EQ(blob.steps(10, 30.0), "anomalous_speed 1");
}

TEST(AnomalousSpeed, IsAnOption) {
  GridVicinityOptions none = options(1);
  none.anomaly_deviations = 0.0;
  ToAndFro blob(none);
  blob.steps(200, 4.0);
  EXPECT_EQ(blob.steps(10, 60.0), "");
}

}  // namespace
}  // namespace survtrack
