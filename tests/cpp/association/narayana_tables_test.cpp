// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include <gtest/gtest.h>

#include "cost_tables.hpp"
#include "survtrack/association/assign.hpp"

namespace survtrack {
namespace {

// The Euclidean match matrices printed in Narayana 2007 and the assignments it reports: rows are tracks in
// order of number, columns blobs from 1 there and from 0 here.

TEST(NarayanaTables, Figure313) {
  const CostMatrix costs = costs_of({{1.18, 0.02, 0.13, 1.10},    // track 3 -> blob 2
                                     {1.21, 0.12, 0.03, 1.10},    // track 13 -> blob 3
                                     {0.36, 1.03, 1.00, 0.21},    // track 16 -> blob 4
                                     {0.11, 1.28, 1.28, 0.33}});  // track 19 -> blob 1
  EXPECT_EQ(assign_oldest_first(costs), (Assignment{1, 2, 3, 0}));
  EXPECT_EQ(assign_hungarian(costs), (Assignment{1, 2, 3, 0}));
}

TEST(NarayanaTables, Figure314LeavesBlobs1And5ToNewTracks) {
  const CostMatrix costs = costs_of({{1.30, 0.04, 0.12, 1.22, 1.31},    // track 3 -> blob 2
                                     {1.28, 0.12, 0.03, 1.18, 1.26},    // track 13 -> blob 3
                                     {0.32, 1.15, 1.17, 0.05, 0.22}});  // track 16 -> blob 4
  EXPECT_EQ(assign_oldest_first(costs), (Assignment{1, 2, 3}));
  EXPECT_EQ(assign_hungarian(costs), (Assignment{1, 2, 3}));
}

TEST(NarayanaTables, Figure315LosesTrack20) {
  const CostMatrix costs = costs_of({{1.28, 0.01, 0.13, 1.05},    // track 3 -> blob 2
                                     {1.31, 0.13, 0.01, 1.06},    // track 13 -> blob 3
                                     {0.31, 1.16, 1.16, 0.11},    // track 16 -> blob 4
                                     {0.04, 1.27, 1.30, 0.40},    // track 19 -> blob 1
                                     {0.32, 1.29, 1.29, 0.23}});  // track 20 lost
  EXPECT_EQ(assign_oldest_first(costs), (Assignment{1, 2, 3, 0, -1}));
  EXPECT_EQ(assign_hungarian(costs), (Assignment{1, 2, 3, 0, -1}));
}

TEST(NarayanaTables, Figure93Euclidean) {
  const CostMatrix costs = costs_of({{0.17, 0.03, 1.45},    // track 3 -> blob 2
                                     {0.03, 0.15, 1.44},    // track 7 -> blob 1
                                     {1.29, 1.36, 0.29}});  // track 12 -> blob 3
  EXPECT_EQ(assign_oldest_first(costs), (Assignment{1, 0, 2}));
  EXPECT_EQ(assign_hungarian(costs), (Assignment{1, 0, 2}));
}

/// Beliefs as costs, by the thesis's rule (8): a track takes its best free blob, and is lost when that one's belief
/// is not above the "lost" entry, which is each row's last.
CostMatrix costs_of_beliefs(std::initializer_list<std::initializer_list<double>> rows) {
  const CostMatrix beliefs = costs_of(rows);
  const int lost = beliefs.columns() - 1;
  CostMatrix costs;
  costs.resize(beliefs.rows(), lost);
  for (int r = 0; r < beliefs.rows(); ++r) {
    for (int c = 0; c < lost; ++c) costs(r, c) = beliefs(r, c) > beliefs(r, lost) ? -beliefs(r, c) : gated;
  }
  return costs;
}

TEST(NarayanaTables, Figure88LosesTracks3And11) {
  const CostMatrix costs = costs_of_beliefs({{0.00, 0.10, 0.90},    // track 3 lost
                                             {0.00, 1.00, 0.00},    // track 7 -> blob 2
                                             {0.00, 0.39, 0.61},    // track 11 lost
                                             {1.00, 0.00, 0.00}});  // track 12 -> blob 1
  EXPECT_EQ(assign_oldest_first(costs), (Assignment{-1, 1, -1, 0}));
  EXPECT_EQ(assign_hungarian(costs), (Assignment{-1, 1, -1, 0}));
}

TEST(NarayanaTables, Figure93BeliefLosesTrack12AndLeavesBlob3ToANewTrack) {
  const CostMatrix costs = costs_of_beliefs({{0.35, 0.55, 0.00, 0.10},    // track 3 -> blob 2
                                             {0.38, 0.52, 0.00, 0.10},    // track 7 -> blob 1
                                             {0.00, 0.00, 0.49, 0.51}});  // track 12 lost
  EXPECT_EQ(assign_oldest_first(costs), (Assignment{1, 0, -1}));
  EXPECT_EQ(assign_hungarian(costs), (Assignment{1, 0, -1}));
}

}  // namespace
}  // namespace survtrack
