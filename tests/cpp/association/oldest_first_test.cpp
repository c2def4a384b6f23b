// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include <gtest/gtest.h>

#include "cost_tables.hpp"
#include "survtrack/association/assign.hpp"

namespace survtrack {
namespace {

TEST(OldestFirst, TheOlderRowKeepsWhatAYoungerOneWantsMore) {
  EXPECT_EQ(assign_oldest_first(costs_of({{2.0, 3.0}, {0.1, 9.0}})), (Assignment{0, 1}));
}

TEST(OldestFirst, OfEqualColumnsTheFirst) {
  EXPECT_EQ(assign_oldest_first(costs_of({{1.0, 1.0, 1.0}, {1.0, 1.0, 1.0}})), (Assignment{0, 1}));
}

TEST(OldestFirst, NeverTakesAGatedEntry) {
  EXPECT_EQ(assign_oldest_first(costs_of({{1.0, gated}, {2.0, gated}})), (Assignment{0, -1}));
  EXPECT_EQ(assign_oldest_first(costs_of({{gated}})), (Assignment{-1}));
  EXPECT_EQ(assign_oldest_first(costs_of({{-gated, 5.0}})), (Assignment{1}));
}

TEST(OldestFirst, NegativeCosts) {
  EXPECT_EQ(assign_oldest_first(costs_of({{-1.0, -2.0}, {-5.0, -9.0}})), (Assignment{1, 0}));
}

TEST(OldestFirst, EmptyMatrices) {
  CostMatrix costs;
  EXPECT_TRUE(assign_oldest_first(costs).empty());
  costs.resize(0, 3);
  EXPECT_TRUE(assign_oldest_first(costs).empty());
  costs.resize(3, 0);
  EXPECT_EQ(assign_oldest_first(costs), (Assignment{-1, -1, -1}));
}

TEST(OldestFirst, IsNotTheOptimum) {
  const CostMatrix costs = costs_of({{2.0, 3.0}, {0.1, 9.0}});
  EXPECT_EQ(assign_oldest_first(costs), (Assignment{0, 1}));
  EXPECT_EQ(assign_hungarian(costs), (Assignment{1, 0}));
  EXPECT_EQ(assign_hungarian(costs, 1.0), (Assignment{-1, 0}));
}

}  // namespace
}  // namespace survtrack
