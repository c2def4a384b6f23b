// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "survtrack/association/belief_matrix.hpp"

#include <cstddef>

namespace survtrack {
namespace {

constexpr double most_belief = 1.0 - 1e-9;

/// A belief and what is left beside it: near 1 the difference from 1 would have few digits.
struct Entry {
  double belief;
  double rest;
};

/// Bayes' rule for one entry, with its present value as the prior (8.13); then the velocity factor.
Entry posterior(double prior, double ratio, double velocity) {
  const double assigned = ratio * prior;
  const double sum = assigned + (1.0 - prior);
  const double belief = assigned / sum;
  if (belief * velocity > most_belief) return {most_belief, 1.0 - most_belief};
  return {belief * velocity, (1.0 - prior) / sum + belief * (1.0 - velocity)};
}

}  // namespace

void order_free_beliefs(const std::vector<Evidence>& evidence, double* row) {
  const std::size_t blobs = evidence.size();
  double sum = 1.0;
  for (std::size_t i = 0; i < blobs; ++i) {
    const Evidence& e = evidence[i];
    row[i] = e.color * e.position * e.size * e.velocity;
    sum += row[i];
  }
  const double scale = 1.0 / sum;
  for (std::size_t i = 0; i < blobs; ++i) row[i] *= scale;
  row[blobs] = scale;
}

void published_beliefs(const std::vector<Evidence>& evidence, double* row, std::vector<double>& scales) {
  const std::size_t blobs = evidence.size();
  scales.resize(blobs);
  // Blobs not yet looked at, and "lost", share one value; those looked at are only rescaled from then on. So one pass
  // forwards and one backwards do what rescaling the whole row at each step would do.
  double untouched = 1.0 / (static_cast<double>(blobs) + 1.0);
  for (std::size_t i = 0; i < blobs; ++i) {
    const Evidence& e = evidence[i];
    // Bayes' rule step by step multiplies the odds step by step.
    const Entry entry = posterior(untouched, e.color * e.position * e.size, e.velocity);
    row[i] = entry.belief;
    // What the others are multiplied by, eq. 8.19 as one fraction: the factors of the steps telescope. "Lost" is among
    // the untouched, so that their value is at most a half.
    scales[i] = entry.rest / (1.0 - untouched);
    untouched *= scales[i];
  }
  double later = 1.0;
  for (std::size_t i = blobs; i-- > 0;) {
    row[i] *= later;
    later *= scales[i];
  }
  row[blobs] = untouched;
}

}  // namespace survtrack
