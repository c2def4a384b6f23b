// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "survtrack/association/density.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>
#include <string>
#include <vector>

#include "../error_message.hpp"
#include "survtrack/core/errors.hpp"

namespace survtrack {
namespace {

/// Five bins of width 2, with the middles -4, -2, 0, 2, 4, and the integral 1.
Density stairs() { return Density::from_values(5.0, {0.05, 0.1, 0.2, 0.1, 0.05}, "stairs"); }

std::string refusal(double range, const std::vector<double>& values) {
  return message_of<InputError>([&] { Density::from_values(range, values, "scene.x"); });
}

TEST(Density, HasThePeak1) {
  EXPECT_DOUBLE_EQ(stairs()(0.0), 1.0);
  EXPECT_DOUBLE_EQ(Density::two_sided_exponential(255.0, 15.0)(0.0), 1.0);
}

TEST(Density, IsLinearBetweenTheMiddlesOfBins) {
  const Density density = stairs();
  EXPECT_DOUBLE_EQ(density(-4.0), 0.25);
  EXPECT_DOUBLE_EQ(density(-2.0), 0.5);
  EXPECT_DOUBLE_EQ(density(1.0), 0.75);
  EXPECT_DOUBLE_EQ(density(2.0), 0.5);
  EXPECT_DOUBLE_EQ(density(-3.5), 0.3125);
}

TEST(Density, BeyondTheRangeTheLastBinCounts) {
  const Density density = Density::from_values(5.0, {0.05, 0.1, 0.2, 0.15, 0.0}, "uneven");
  for (const double far : {4.5, 5.0, 5.1, 1e300, std::numeric_limits<double>::infinity()}) {
    EXPECT_DOUBLE_EQ(density(-far), 0.25);
    EXPECT_DOUBLE_EQ(density(far), 0.0);
  }
}

TEST(Density, TheExponentialFallsByOneEthEveryScale) {
  const Density density = Density::two_sided_exponential(255.0, 15.0);
  for (const double difference : {-45.0, -15.0, 15.0, 30.0, 60.0}) {
    EXPECT_NEAR(density(difference) / std::exp(-std::abs(difference) / 15.0), 1.0, 0.01);
  }
}

TEST(Density, ValuesAreItsTableWithTheIntegral1) {
  const Density exponential = Density::two_sided_exponential(0.5, 0.0625);
  const std::vector<double> values = exponential.values();
  const double bin = 2.0 * exponential.range() / static_cast<double>(values.size());
  EXPECT_NEAR(std::accumulate(values.begin(), values.end(), 0.0) * bin, 1.0, 1e-12);
  const std::vector<double> expected = {0.05, 0.1, 0.2, 0.1, 0.05};
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_DOUBLE_EQ(stairs().values()[i], expected[i]);
}

TEST(Density, SurvivesItsOwnTable) {
  const Density density = Density::two_sided_exponential(180.0, 30.0);
  const Density again = Density::from_values(density.range(), density.values(), "again");
  for (double difference = -200.0; difference <= 200.0; difference += 0.7) {
    EXPECT_NEAR(again(difference), density(difference), 1e-14);
  }
}

TEST(Density, ATableThatIsNotNormalisedIsRefusedWithItsIntegral) {
  EXPECT_TRUE(contains(refusal(5.0, {0.05, 0.1, 0.3, 0.1, 0.05}), "scene.x.values: ", "is 1.2; expected 1"));
  EXPECT_TRUE(contains(refusal(5.0, {1e308, 1e308, 1e308}), "scene.x.values: ", "expected 1"));
  EXPECT_NO_THROW(Density::from_values(5.0, {0.05, 0.1, 0.2 + 4e-7, 0.1, 0.05}, "scene.x"));
  EXPECT_THROW(Density::from_values(5.0, {0.05, 0.1, 0.2 + 6e-7, 0.1, 0.05}, "scene.x"), InputError);
}

TEST(Density, ATableWithoutMassIsRefused) {
  EXPECT_TRUE(contains(refusal(5.0, {0.0, 0.0, 0.0}), "scene.x.values: have no mass"));
}

TEST(Density, AValueThatIsNoProbabilityIsRefusedByItsPlace) {
  for (const double bad : {-0.1, -1e-300, std::nan(""), HUGE_VAL, -HUGE_VAL}) {
    EXPECT_TRUE(contains(refusal(5.0, {0.1, bad, 0.1}), "scene.x.values[1]: is ", "expected a finite number of at least 0"));
  }
}

TEST(Density, ARangeThatIsNoLengthIsRefused) {
  for (const double bad : {0.0, -5.0, std::nan(""), HUGE_VAL}) {
    EXPECT_TRUE(contains(refusal(bad, {0.1, 0.1, 0.1}), "scene.x.range: is ", "expected a finite number above 0"));
  }
}

TEST(Density, FewerThanThreeValuesAreRefused) {
  EXPECT_TRUE(contains(refusal(1.0, {}), "scene.x.values: are ", "expected at least 3"));
  EXPECT_TRUE(contains(refusal(1.0, {0.5, 0.5}), "scene.x.values: are ", "expected at least 3"));
}

}  // namespace
}  // namespace survtrack
