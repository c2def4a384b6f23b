// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "survtrack/core/geometry.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "survtrack/core/event.hpp"
#include "survtrack/core/scene_scale.hpp"
#include "survtrack/core/track.hpp"

namespace survtrack {
namespace {

TEST(Box, EdgesCentreAndArea) {
  const Box box{2.0, 3.0, 4.0, 6.0};
  EXPECT_EQ(box.right(), 6.0);
  EXPECT_EQ(box.bottom(), 9.0);
  EXPECT_EQ(box.area_px(), 24.0);
  EXPECT_EQ(box.center(), (Point{4.0, 6.0}));
  EXPECT_EQ(Box::around({4.0, 6.0}, 4.0, 6.0), box);
}

TEST(Box, ContainsItsLeftAndTopEdgeOnly) {
  const Box box{2.0, 3.0, 4.0, 6.0};
  EXPECT_TRUE(box.contains({2.0, 3.0}));
  EXPECT_FALSE(box.contains({6.0, 5.0}));
  EXPECT_FALSE(box.contains({4.0, 9.0}));
  EXPECT_FALSE(box.contains({1.9, 5.0}));
}

TEST(Box, IntersectionOverUnion) {
  const Box a{0.0, 0.0, 4.0, 4.0};
  EXPECT_EQ(intersection_px(a, {2.0, 1.0, 4.0, 2.0}), 4.0);
  EXPECT_EQ(iou(a, {2.0, 1.0, 4.0, 2.0}), 4.0 / 20.0);
  EXPECT_EQ(iou(a, a), 1.0);
  EXPECT_EQ(iou(a, {4.0, 0.0, 4.0, 4.0}), 0.0);  // only an edge in common
  EXPECT_EQ(iou(a, {9.0, 9.0, 1.0, 1.0}), 0.0);
  EXPECT_EQ(iou(Box{}, Box{}), 0.0);
}

TEST(SceneScale, IsLinearInTheLowerEdgeAndNeverBelowItsLeast) {
  SceneScale scale;
  scale.height_at_top_px = -10.0;
  scale.height_per_row = 0.5;
  scale.min_height_px = 4.0;
  EXPECT_EQ(scale.height_px(100.0), 40.0);
  EXPECT_EQ(scale.height_px(0.0), 4.0);
}

TEST(Names, AreDistinctAndWrittenAsInFiles) {
  std::set<std::string> events;
  for (const auto kind : {EventKind::track_started, EventKind::track_lost, EventKind::track_recovered,
                          EventKind::track_ended, EventKind::scene_changed}) {
    events.insert(to_string(kind));
  }
  EXPECT_EQ(events, (std::set<std::string>{"track_started", "track_lost", "track_recovered", "track_ended",
                                           "scene_changed"}));
  EXPECT_STREQ(to_string(TrackStatus::tentative), "tentative");
  EXPECT_STREQ(to_string(TrackStatus::confirmed), "confirmed");
  EXPECT_STREQ(to_string(TrackStatus::lost), "lost");
  EXPECT_STREQ(to_string(TrackStatus::closed), "closed");
}

}  // namespace
}  // namespace survtrack
