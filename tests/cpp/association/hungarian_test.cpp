// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "../error_message.hpp"
#include "cost_tables.hpp"
#include "survtrack/association/assign.hpp"
#include "survtrack/core/errors.hpp"

namespace survtrack {
namespace {

/// What an assignment is judged by: pairs first when rows alone cost infinitely much, then the total.
struct Value {
  int pairs = 0;
  double total = 0.0;

  bool better_than(const Value& other, double unassigned_cost) const {
    if (std::isinf(unassigned_cost) && pairs != other.pairs) return pairs > other.pairs;
    return total < other.total;
  }
};

/// Tries every assignment of the rows from `row` on.
Value best_of_all(const CostMatrix& costs, double unassigned_cost, int row, std::vector<char>& taken) {
  if (row == costs.rows()) return {};
  Value best = best_of_all(costs, unassigned_cost, row + 1, taken);
  if (std::isfinite(unassigned_cost)) best.total += unassigned_cost;
  for (int c = 0; c < costs.columns(); ++c) {
    char& used = taken[static_cast<std::size_t>(c)];
    if (used != 0 || std::isinf(costs(row, c))) continue;
    used = 1;
    Value value = best_of_all(costs, unassigned_cost, row + 1, taken);
    used = 0;
    value.total += costs(row, c);
    ++value.pairs;
    if (value.better_than(best, unassigned_cost)) best = value;
  }
  return best;
}

/// Also checks that the assignment is one to one and inside the gate.
Value value_of(const CostMatrix& costs, double unassigned_cost, const Assignment& assignment) {
  Value value;
  EXPECT_EQ(static_cast<int>(assignment.size()), costs.rows());
  std::vector<char> taken(static_cast<std::size_t>(costs.columns()), 0);
  for (int r = 0; r < costs.rows(); ++r) {
    const int c = assignment[static_cast<std::size_t>(r)];
    if (c == -1) {
      if (std::isfinite(unassigned_cost)) value.total += unassigned_cost;
      continue;
    }
    EXPECT_TRUE(c >= 0 && c < costs.columns());
    EXPECT_EQ(taken[static_cast<std::size_t>(c)]++, 0) << "column " << c << " twice";
    EXPECT_TRUE(std::isfinite(costs(r, c)));
    value.total += costs(r, c);
    ++value.pairs;
  }
  return value;
}

struct Kind {
  const char* name;
  double low, high;
  bool whole_numbers;  ///< many ties
  double gated_part;
};

class HungarianAgainstAll : public testing::TestWithParam<Kind> {};

TEST_P(HungarianAgainstAll, RandomMatrices) {
  const Kind kind = GetParam();
  std::mt19937 random(7);
  std::uniform_real_distribution<double> cost(kind.low, kind.high), part(0.0, 1.0);
  std::uniform_int_distribution<int> side(0, 5);
  for (int trial = 0; trial < 1500; ++trial) {
    CostMatrix costs;
    costs.resize(side(random), side(random));
    for (int r = 0; r < costs.rows(); ++r) {
      for (int c = 0; c < costs.columns(); ++c) {
        if (part(random) < kind.gated_part) continue;
        costs(r, c) = kind.whole_numbers ? std::round(cost(random)) : cost(random);
      }
    }
    for (const double unassigned_cost : {gated, 0.5 * (kind.low + kind.high), kind.high + 1.0}) {
      std::vector<char> taken(static_cast<std::size_t>(costs.columns()), 0);
      const Value best = best_of_all(costs, unassigned_cost, 0, taken);
      const Value got = value_of(costs, unassigned_cost, assign_hungarian(costs, unassigned_cost));
      ASSERT_NEAR(got.total, best.total, 1e-9) << "trial " << trial << ", a row alone costs " << unassigned_cost;
      ASSERT_TRUE(std::isfinite(unassigned_cost) || got.pairs == best.pairs) << "trial " << trial;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, HungarianAgainstAll,
                         testing::Values(Kind{"Plain", 0.0, 10.0, false, 0.0}, Kind{"Gated", 0.0, 10.0, false, 0.5},
                                         Kind{"Sparse", -3.0, 3.0, false, 0.8}, Kind{"Negative", -9.0, -1.0, false, 0.3},
                                         Kind{"Ties", 0.0, 3.0, true, 0.3}, Kind{"AllEqual", 2.0, 2.0, true, 0.2}),
                         [](const auto& tested) { return std::string(tested.param.name); });

TEST(Hungarian, OneByOne) {
  EXPECT_EQ(assign_hungarian(costs_of({{5.0}})), (Assignment{0}));
  EXPECT_EQ(assign_hungarian(costs_of({{gated}})), (Assignment{-1}));
  EXPECT_EQ(assign_hungarian(costs_of({{5.0}}), 4.0), (Assignment{-1}));
  EXPECT_EQ(assign_hungarian(costs_of({{5.0}}), 6.0), (Assignment{0}));
}

TEST(Hungarian, EmptyAndAllGated) {
  CostMatrix costs;
  EXPECT_TRUE(assign_hungarian(costs).empty());
  costs.resize(0, 4);
  EXPECT_TRUE(assign_hungarian(costs).empty());
  costs.resize(4, 0);
  EXPECT_EQ(assign_hungarian(costs), (Assignment{-1, -1, -1, -1}));
  costs.resize(2, 3);
  EXPECT_EQ(assign_hungarian(costs), (Assignment{-1, -1}));
  EXPECT_EQ(assign_hungarian(costs, 1.0), (Assignment{-1, -1}));
}

TEST(Hungarian, MorePairsComeBeforeCheaperOnes) {
  // Row 0 would rather have column 0, but then row 1 has none.
  EXPECT_EQ(assign_hungarian(costs_of({{0.0, 1000.0}, {1.0, gated}})), (Assignment{1, 0}));
  EXPECT_EQ(assign_hungarian(costs_of({{0.0, 1000.0}, {1.0, gated}}), 10.0), (Assignment{0, -1}));
}

TEST(Hungarian, MinusInfinityIsNeverTakenEither) {
  EXPECT_EQ(assign_hungarian(costs_of({{-gated, 5.0}, {2.0, 1.0}})), (Assignment{1, 0}));
}

TEST(Hungarian, RefusesWhatIsNoNumber) {
  const double nan = std::nan("");
  EXPECT_TRUE(contains(message_of<InputError>([&] { assign_hungarian(costs_of({{1.0, 2.0}, {3.0, nan}})); }),
                       "costs(1, 1): is not a number"));
  EXPECT_THROW(assign_oldest_first(costs_of({{nan}})), InputError);
  EXPECT_TRUE(contains(message_of<InputError>([&] { assign_hungarian(costs_of({{1.0}}), nan); }), "unassigned_cost"));
}

TEST(Hungarian, EachIndexOnceInAHundredByNinety) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> cost(0.0, 1.0);
  CostMatrix costs;
  costs.resize(100, 90);
  for (int r = 0; r < 100; ++r) {
    for (int c = 0; c < 90; ++c) costs(r, c) = cost(random);
  }
  const Value all = value_of(costs, gated, assign_hungarian(costs));
  EXPECT_EQ(all.pairs, 90);
  EXPECT_LT(all.total, value_of(costs, gated, assign_oldest_first(costs)).total);
}

}  // namespace
}  // namespace survtrack
