// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "../error_message.hpp"
#include "survtrack/association/density.hpp"
#include "survtrack/core/errors.hpp"

namespace survtrack {
namespace {

constexpr double range = 255.0;
constexpr double start_scale = 15.0;

Density start() { return Density::two_sided_exponential(range, start_scale); }

/// Differences of known spread; the same on every platform.
class Differences {
 public:
  double laplace(double scale) { return (random_() % 2 == 0 ? -1.0 : 1.0) * -scale * std::log(unit()); }
  double gauss(double deviation) {
    return deviation * std::sqrt(-2.0 * std::log(unit())) * std::cos(2.0 * 3.14159265358979 * unit());
  }

 private:
  double unit() { return (static_cast<double>(random_()) + 0.5) / 4294967296.0; }
  std::mt19937 random_{20};
};

/// Where a density has fallen to a half, to the right of its peak.
double half_width(const Density& density) {
  double x = 0.0;
  while (density(x) > 0.5) x += 0.01;
  return x;
}

bool same(const Density& a, const Density& b) { return a.range() == b.range() && a.relative() == b.relative(); }

TEST(DensityLearner, StaysAtTheStartUntilEnoughWasSeen) {
  DensityLearner learner(start(), 200);
  for (int i = 0; i < 199; ++i) {
    learner.add(40.0);
    ASSERT_TRUE(same(learner.density(), start())) << i;
  }
  learner.add(40.0);
  EXPECT_FALSE(same(learner.density(), start()));
  EXPECT_EQ(learner.samples(), 200.0);
  EXPECT_GT(learner.density()(40.0), learner.density()(0.0));
}

TEST(DensityLearner, LearnsTheWidthOfLaplaceDifferences) {
  for (const double scale : {10.0, 15.0, 40.0}) {  // a bin is 1.3 wide
    Differences differences;
    DensityLearner learner(start(), 200);
    for (int i = 0; i < 10'000; ++i) learner.add(differences.laplace(scale));
    const double expected = scale * std::log(2.0);
    EXPECT_NEAR(half_width(learner.density()), expected, 0.25 * expected) << scale;
  }
}

TEST(DensityLearner, LearnsTheWidthOfGaussianDifferences) {
  for (const double deviation : {5.0, 15.0, 40.0}) {
    Differences differences;
    DensityLearner learner(start(), 200);
    for (int i = 0; i < 10'000; ++i) learner.add(differences.gauss(deviation));
    const double expected = deviation * std::sqrt(2.0 * std::log(2.0));
    EXPECT_NEAR(half_width(learner.density()), expected, 0.25 * expected) << deviation;
  }
}

TEST(DensityLearner, LeavesNothingImpossible) {
  DensityLearner learner(start(), 10);
  for (int i = 0; i < 1000; ++i) learner.add(0.0);
  for (double difference = -300.0; difference <= 300.0; difference += 10.0) {
    EXPECT_GT(learner.density()(difference), 0.0);
  }
}

TEST(DensityLearner, ForgetsWhatIsLongPast) {
  Differences differences;
  DensityLearner learner(start(), 200);
  for (int i = 0; i < 20'000; ++i) learner.add(differences.laplace(40.0));
  for (int i = 0; i < 100'000; ++i) learner.add(differences.laplace(10.0));
  EXPECT_NEAR(half_width(learner.density()), 10.0 * std::log(2.0), 0.25 * 10.0 * std::log(2.0));
  EXPECT_LE(learner.samples(), 20'000.0);
}

TEST(DensityLearner, DifferencesBeyondTheRangeCountInTheLastBin) {
  DensityLearner learner(start(), 10);
  for (int i = 0; i < 100; ++i) learner.add(i % 2 == 0 ? 1e300 : HUGE_VAL);
  EXPECT_EQ(learner.density()(range), 1.0);
  EXPECT_LT(learner.density()(0.0), 0.5);
}

TEST(DensityLearner, LearnAfter0NeverLearns) {
  DensityLearner learner(start(), 0);
  for (int i = 0; i < 1000; ++i) learner.add(40.0);
  EXPECT_TRUE(same(learner.density(), start()));
  EXPECT_EQ(learner.samples(), 0.0);
}

TEST(DensityLearner, LearnsHoweverLateItBegins) {
  DensityLearner learner(start(), 30'000);
  for (int i = 0; i < 29'999; ++i) learner.add(40.0);
  EXPECT_TRUE(same(learner.density(), start()));
  for (int i = 0; i < 100; ++i) learner.add(40.0);
  EXPECT_FALSE(same(learner.density(), start()));
}

TEST(DensityLearner, GoesOnFromWhatWasSaved) {
  Differences differences;
  DensityLearner learner(start(), 200);
  for (int i = 0; i < 5000; ++i) learner.add(differences.laplace(40.0));
  const Density saved = Density::from_values(range, learner.density().values(), "saved");
  DensityLearner again(start(), 200);
  again.restore(saved, learner.samples(), "saved");
  EXPECT_TRUE(same(again.density(), saved));
  EXPECT_EQ(again.samples(), 5000.0);
  for (int i = 0; i < 100; ++i) again.add(differences.laplace(40.0));
  EXPECT_NEAR(half_width(again.density()), half_width(saved), 0.1 * half_width(saved));
}

TEST(DensityLearner, DoesNotDriftWithRestarts) {
  Differences differences;
  DensityLearner first(start(), 200);
  for (int i = 0; i < 5000; ++i) first.add(differences.laplace(40.0));
  Density density = first.density();
  double samples = first.samples();
  for (int restart = 0; restart < 30; ++restart) {
    DensityLearner next(start(), 200);
    next.restore(Density::from_values(range, density.values(), "saved"), samples, "saved");
    for (int i = 0; i < 100; ++i) next.add(differences.laplace(40.0));
    density = next.density();
    samples = next.samples();
  }
  EXPECT_EQ(samples, 8000.0);
  EXPECT_NEAR(half_width(density), half_width(first.density()), 0.1 * half_width(first.density()));
  for (double difference = 100.0; difference <= 300.0; difference += 50.0) {
    EXPECT_NEAR(density(difference), first.density()(difference), 0.03) << difference;
  }
}

TEST(DensityLearner, AStartThatWasSavedIsNoExperience) {
  DensityLearner unused(start(), 200);
  for (int i = 0; i < 150; ++i) unused.add(60.0);
  DensityLearner again(start(), 200);
  again.restore(unused.density(), unused.samples(), "saved");
  EXPECT_TRUE(same(again.density(), start()));
  for (int i = 0; i < 200; ++i) again.add(60.0);
  EXPECT_GT(again.density()(60.0), 2.0 * again.density()(0.0));
}

TEST(DensityLearner, ATableOfAnotherRangeOrLengthIsRefusedByName) {
  DensityLearner learner(start(), 200);
  const auto refusal = [&](const Density& other) {
    return message_of<InputError>([&] { learner.restore(other, 500.0, "scene.y"); });
  };
  EXPECT_TRUE(contains(refusal(Density::two_sided_exponential(180.0, 15.0)), "scene.y: ", "+-180", "+-255"));
  EXPECT_TRUE(contains(refusal(Density::from_values(range, {0.0, 1.0 / 170.0, 0.0}, "few")), "scene.y: has 3 values"));
  EXPECT_TRUE(same(learner.density(), start()));
  EXPECT_EQ(learner.samples(), 0.0);
}

}  // namespace
}  // namespace survtrack
