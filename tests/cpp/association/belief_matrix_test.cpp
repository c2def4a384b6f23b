// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <random>
#include <vector>

#include "belief_rules.hpp"

namespace survtrack {
namespace {

constexpr double tolerance = 1e-12;
const std::vector<std::size_t> row_lengths = {0, 1, 2, 3, 7, 30, 300};

void expect_near(const std::vector<double>& row, const std::vector<double>& expected, double within = tolerance) {
  ASSERT_EQ(row.size(), expected.size());
  for (std::size_t i = 0; i < row.size(); ++i) {
    ASSERT_NEAR(row[i], expected[i], within) << "entry " << i << " of " << row.size();
  }
}

void expect_probabilities(const std::vector<double>& row) {
  for (const double belief : row) {
    ASSERT_GE(belief, 0.0);  // and is no NaN
    ASSERT_LE(belief, 1.0);
  }
  ASSERT_NEAR(std::accumulate(row.begin(), row.end(), 0.0), 1.0, tolerance);
}

TEST(BeliefMatrix, PublishedIsTheRuleWordForWord) {
  RandomEvidence random(1);
  for (const std::size_t blobs : row_lengths) {
    for (int round = 0; round < 20; ++round) {
      for (const auto& evidence : {random.mild(blobs), random.small(blobs), random.extreme(blobs)}) {
        expect_near(published(evidence), literal_published_beliefs(evidence));
      }
    }
  }
}

TEST(BeliefMatrix, OrderFreeIsTheClosedForm) {
  RandomEvidence random(2);
  for (const std::size_t blobs : row_lengths) {
    const auto evidence = random.extreme(blobs);
    std::vector<double> products;
    for (const Evidence& e : evidence) products.push_back(e.color * e.position * e.size * e.velocity);
    products.push_back(1.0);  // "lost"
    const double sum = std::accumulate(products.begin(), products.end(), 0.0);
    for (double& product : products) product /= sum;
    expect_near(order_free(evidence), products);
  }
}

TEST(BeliefMatrix, OrderFreeIsTheRuleWithTheVelocityFactorOnTheOdds) {
  RandomEvidence random(3);
  for (const std::size_t blobs : row_lengths) {
    const auto evidence = random.mild(blobs);
    expect_near(order_free(evidence), literal_beliefs_of_odds(evidence));
  }
}

TEST(BeliefMatrix, WithoutVelocityTheTwoOrdersAgree) {
  RandomEvidence random(4);
  for (const std::size_t blobs : row_lengths) {
    auto evidence = random.mild(blobs);
    for (Evidence& e : evidence) e.velocity = 1.0;
    expect_near(published(evidence), order_free(evidence));
  }
}

/// The rows of shuffled blobs, put back into the order of the blobs.
template <class Rule>
std::vector<double> shuffled(const std::vector<Evidence>& evidence, unsigned seed, Rule&& rule) {
  std::vector<std::size_t> order(evidence.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::shuffle(order.begin(), order.end(), std::mt19937(seed));
  std::vector<Evidence> moved;
  for (const std::size_t i : order) moved.push_back(evidence[i]);
  const std::vector<double> row = rule(moved);
  std::vector<double> back(row.size());
  for (std::size_t i = 0; i < order.size(); ++i) back[order[i]] = row[i];
  back.back() = row.back();
  return back;
}

TEST(BeliefMatrix, TheOrderOfBlobsDoesNotMatterToTheOrderFreeRule) {
  RandomEvidence random(5);
  for (const std::size_t blobs : row_lengths) {
    const auto evidence = random.extreme(blobs);
    expect_near(shuffled(evidence, 6, order_free), order_free(evidence));
  }
}

TEST(BeliefMatrix, TheOrderOfBlobsMattersToThePublishedRuleOnlyThroughVelocity) {
  std::vector<Evidence> evidence = {{3.0, 2.0, 1.0, 1.0}, {2.0, 4.0, 1.0, 1.0}};
  const auto first_of_reversed = [&] { return published({evidence[1], evidence[0]})[1]; };
  EXPECT_NEAR(published(evidence)[0], first_of_reversed(), tolerance);
  evidence[0].velocity = 1.5;
  EXPECT_GT(std::abs(published(evidence)[0] - first_of_reversed()), 0.01);
}

TEST(BeliefMatrix, WithoutBlobsATrackIsLost) {
  EXPECT_EQ(order_free({}), (std::vector<double>{1.0}));
  EXPECT_EQ(published({}), (std::vector<double>{1.0}));
}

TEST(BeliefMatrix, WithoutEvidenceTheRowIsThePrior) {
  // Eq. 8.10 and 8.15.
  for (const std::size_t blobs : row_lengths) {
    const std::vector<double> prior(blobs + 1, 1.0 / (static_cast<double>(blobs) + 1.0));
    expect_near(order_free(std::vector<Evidence>(blobs)), prior);
    expect_near(published(std::vector<Evidence>(blobs)), prior);
  }
}

TEST(BeliefMatrix, RowsAreProbabilitiesWhateverTheEvidence) {
  RandomEvidence random(7);
  for (const std::size_t blobs : {std::size_t{0}, std::size_t{1}, std::size_t{2}, std::size_t{10}, std::size_t{1000}}) {
    for (int round = 0; round < 50; ++round) {
      const auto evidence = random.extreme(blobs);
      expect_probabilities(order_free(evidence));
      expect_probabilities(published(evidence));
    }
  }
}

TEST(BeliefMatrix, RowsAreProbabilitiesWhenAllBlobsSayTheSame) {
  for (const double ratio : {0.0, 1e-300, 1.0, 1e6}) {
    for (const double velocity : {0.0, 0.2, 2.0}) {
      for (const std::size_t blobs : {std::size_t{1}, std::size_t{2}, std::size_t{1000}}) {
        const std::vector<Evidence> evidence(blobs, Evidence{ratio, ratio, ratio, velocity});
        expect_probabilities(order_free(evidence));
        expect_probabilities(published(evidence));
      }
    }
  }
}

TEST(BeliefMatrix, APublishedBeliefIsNeverCertain) {
  const std::vector<Evidence> evidence(3, Evidence{1e6, 1e6, 1e6, 2.0});
  for (const double belief : published(evidence)) EXPECT_LE(belief, most_belief);
}

}  // namespace
}  // namespace survtrack
