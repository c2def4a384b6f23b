// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

// The worked example of Narayana 2007, fig. 8.7: one row over (O1, O2, lost).

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "belief_rules.hpp"

namespace survtrack {
namespace {

constexpr double printed = 0.005;  // two digits
constexpr double velocity = 0.86 / 0.70;

using Row = std::vector<double>;

/// What O1 has shown so far; O2 shows nothing.
std::vector<Evidence> seen(double color, double position = 1.0, double factor = 1.0) {
  return {{color, position, 1.0, factor}, {}};
}

void expect_printed(const Row& row, const Row& expected) {
  ASSERT_EQ(row.size(), expected.size());
  for (std::size_t i = 0; i < row.size(); ++i) EXPECT_NEAR(row[i], expected[i], printed) << i;
}

TEST(BeliefExample, StepByStepAsPrinted) {
  // 0.50 are odds of 1, from 1/2 before: ratio 2. 0.70 are odds of 7/3.
  expect_printed(published(seen(1.0)), {0.33, 0.33, 0.33});
  expect_printed(published(seen(2.0)), {0.50, 0.25, 0.25});
  expect_printed(published(seen(2.0, 7.0 / 3.0)), {0.70, 0.15, 0.15});
  expect_printed(published(seen(2.0, 7.0 / 3.0, velocity)), {0.86, 0.07, 0.07});
}

TEST(BeliefExample, StepByStepByTheLiteralRule) {
  LiteralRow row(2);
  expect_printed(row.beliefs(), {0.33, 0.33, 0.33});
  row.observe(0, 2.0);
  expect_printed(row.beliefs(), {0.50, 0.25, 0.25});
  row.observe(0, 7.0 / 3.0);
  expect_printed(row.beliefs(), {0.70, 0.15, 0.15});
  row.multiply(0, velocity);
  expect_printed(row.beliefs(), {0.86, 0.07, 0.07});
}

TEST(BeliefExample, TheOrderFreeRuleNeedsALargerFactorForTheSame) {
  // Odds from 7/3 to 0.86 / 0.14.
  const double factor = (0.86 / 0.14) / (0.70 / 0.30);
  expect_printed(order_free(seen(2.0, 7.0 / 3.0)), {0.70, 0.15, 0.15});
  expect_printed(order_free(seen(2.0, 7.0 / 3.0, factor)), {0.86, 0.07, 0.07});
  EXPECT_LT(order_free(seen(2.0, 7.0 / 3.0, velocity))[0], 0.75);
}

TEST(BeliefExample, TheVelocityFactorCannotMakeABeliefCertain) {
  const Row row = published(seen(2.0, 7.0 / 3.0, 2.0));  // 1.40 before the clamp
  EXPECT_EQ(row[0], most_belief);
  EXPECT_GT(row[1], 0.0);
  EXPECT_NEAR(row[1], 0.5e-9, 1e-12);
}

/// Eq. 8.16 with p(c) by the letter of 8.10 to 8.12, where p(Assign) is always 1/(v + 1), and the rescaling of 8.19.
void observe_by_the_letter(Row& row, std::size_t blob, double if_assigned) {
  constexpr double if_not = 0.1;  // eq. 8.8
  const double prior = 1.0 / static_cast<double>(row.size());
  const double old = row[blob];
  row[blob] = if_assigned * old / (if_assigned * prior + if_not * (1.0 - prior));
  for (std::size_t m = 0; m < row.size(); ++m) {
    if (m != blob) row[m] *= 1.0 - (row[blob] - old) / (1.0 - old);
  }
}

TEST(BeliefExample, ByTheLetterBeliefsLeaveTheirRange) {
  // The erratum: a colour and a position at the peaks of their densities.
  Row letter(3, 1.0 / 3.0);
  observe_by_the_letter(letter, 0, 1.0);
  expect_printed(letter, {0.83, 0.08, 0.08});
  observe_by_the_letter(letter, 0, 1.0);
  expect_printed(letter, {2.08, -0.54, -0.54});
  // With the present belief as p(Assign): odds of 1/2 times 10 times 10.
  expect_printed(published(seen(10.0, 10.0)), {0.98, 0.01, 0.01});
}

}  // namespace
}  // namespace survtrack
