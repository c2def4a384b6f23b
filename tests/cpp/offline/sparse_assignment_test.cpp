// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "offline/sparse_assignment.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "survtrack/association/assign.hpp"

namespace survtrack {
namespace {

std::vector<std::vector<SparsePair>> pairs_of(const CostMatrix& costs) {
  std::vector<std::vector<SparsePair>> rows(static_cast<std::size_t>(costs.rows()));
  for (int r = 0; r < costs.rows(); ++r) {
    for (int c = 0; c < costs.columns(); ++c) {
      if (!std::isinf(costs(r, c))) rows[static_cast<std::size_t>(r)].push_back({c, costs(r, c)});
    }
  }
  return rows;
}

/// Also checks that it is one to one and that no pair is outside the gate or saves nothing.
double total_of(const CostMatrix& costs, const Assignment& assignment, double unassigned_cost) {
  EXPECT_EQ(static_cast<int>(assignment.size()), costs.rows());
  std::vector<char> taken(static_cast<std::size_t>(costs.columns()), 0);
  double total = 0.0;
  for (int r = 0; r < costs.rows(); ++r) {
    const int c = assignment[static_cast<std::size_t>(r)];
    total += c < 0 ? unassigned_cost : costs(r, c);
    if (c < 0) continue;
    EXPECT_EQ(taken[static_cast<std::size_t>(c)]++, 0);
    EXPECT_LT(costs(r, c), unassigned_cost);
  }
  return total;
}

TEST(SparseAssignment, CostsAsMuchAsTheHungarianMethods) {
  std::mt19937 random(17);
  std::uniform_real_distribution<double> cost(0.0, 10.0), part(0.0, 1.0);
  std::uniform_int_distribution<int> side(0, 12);
  for (int trial = 0; trial < 4000; ++trial) {
    CostMatrix costs;
    costs.resize(side(random), side(random));
    const double gated_part = part(random);
    const bool ties = trial % 2 == 0;
    for (int r = 0; r < costs.rows(); ++r) {
      for (int c = 0; c < costs.columns(); ++c) {
        if (part(random) < gated_part) continue;
        costs(r, c) = ties ? std::round(0.4 * cost(random)) : cost(random);
      }
    }
    for (const double unassigned_cost : {0.5, 3.0, 20.0}) {
      const double best = total_of(costs, assign_hungarian(costs, unassigned_cost), unassigned_cost);
      const double got = total_of(costs, assign_sparse(pairs_of(costs), costs.columns(), unassigned_cost), unassigned_cost);
      ASSERT_NEAR(got, best, 1e-9) << "trial " << trial << ", a row alone costs " << unassigned_cost;
    }
  }
}

TEST(SparseAssignment, ByHand) {
  EXPECT_TRUE(assign_sparse({}, 0, 1.0).empty());
  EXPECT_EQ(assign_sparse({{}, {}}, 3, 1.0), (Assignment{-1, -1}));
  EXPECT_EQ(assign_sparse({{{0, 0.5}}, {{0, 0.25}}}, 1, 1.0), (Assignment{-1, 0}));
  // The first row gives way to the second, which has no other.
  EXPECT_EQ(assign_sparse({{{0, 0.1}, {1, 0.5}}, {{0, 0.3}}}, 2, 1.0), (Assignment{1, 0}));
  // A pair that saves nothing is not made.
  EXPECT_EQ(assign_sparse({{{0, 1.0}}}, 1, 1.0), (Assignment{-1}));
}

TEST(SparseAssignment, OfEqualOnesTheFirst) {
  EXPECT_EQ(assign_sparse({{{0, 0.5}, {1, 0.5}}, {{0, 0.5}, {1, 0.5}}}, 2, 1.0), (Assignment{0, 1}));
}

}  // namespace
}  // namespace survtrack
