// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include <gtest/gtest.h>

#include <cmath>

#include "survtrack/association/costs.hpp"

namespace survtrack {
namespace {

TEST(SquaredMahalanobis, WorkedByHand) {
  EXPECT_EQ(squared_mahalanobis({{3.0, 4.0}, {1.0, 0.0, 1.0}}), 25.0);
  EXPECT_EQ(squared_mahalanobis({{3.0, 4.0}, {9.0, 0.0, 4.0}}), 5.0);
  // S = [[4, 1], [1, 2]], its inverse [[2, -1], [-1, 4]] / 7: (2 - 4 + 16) / 7.
  EXPECT_NEAR(squared_mahalanobis({{1.0, 2.0}, {4.0, 1.0, 2.0}}), 2.0, 1e-15);
}

TEST(GaussianCost, IsDistancePlusSpread) {
  GaussianCostOptions options;
  options.gate = 9.0;
  const Innovation innovation{{2.0, 0.0}, {4.0, 0.0, 25.0}};
  // d^2 = 1; det S = 100 over the area's square 400.
  EXPECT_NEAR(gaussian_cost(options, innovation, 20.0), 1.0 + std::log(0.25), 1e-15);
}

TEST(GaussianCost, IsTheSameAtAnyScale) {
  GaussianCostOptions options;
  options.gate = 9.0;
  const double small = gaussian_cost(options, {{2.0, 1.0}, {4.0, 1.0, 9.0}}, 20.0);
  const double large = gaussian_cost(options, {{20.0, 10.0}, {400.0, 100.0, 900.0}}, 2000.0);
  EXPECT_NEAR(small, large, 1e-12);
}

TEST(GaussianCost, GateHoldsItsOwnValue) {
  GaussianCostOptions options;
  options.gate = 9.0;
  EXPECT_TRUE(std::isfinite(gaussian_cost(options, {{3.0, 0.0}, {1.0, 0.0, 1.0}}, 1.0)));
  EXPECT_EQ(gaussian_cost(options, {{3.0 + 1e-9, 0.0}, {1.0, 0.0, 1.0}}, 1.0), CostMatrix::gated);
}

TEST(GaussianCost, OfTwoEquallyFarTheSurerTrackIsCheaper) {
  GaussianCostOptions options;
  options.gate = 9.0;
  const double sure = gaussian_cost(options, {{1.0, 0.0}, {1.0, 0.0, 1.0}}, 1.0);
  const double unsure = gaussian_cost(options, {{2.0, 0.0}, {4.0, 0.0, 4.0}}, 1.0);
  EXPECT_LT(sure, unsure);
}

TEST(GaussianCost, WithoutCovarianceNothingIsInTheGate) {
  const GaussianCostOptions options;
  EXPECT_EQ(gaussian_cost(options, {{1.0, 0.0}, {}}, 1.0), CostMatrix::gated);
  EXPECT_EQ(gaussian_cost(options, {{0.0, 0.0}, {}}, 1.0), CostMatrix::gated);
}

}  // namespace
}  // namespace survtrack
