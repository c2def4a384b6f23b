// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "survtrack/association/belief_matrix.hpp"

#include <algorithm>
#include <cstddef>

namespace survtrack {
namespace {

constexpr double most_belief = 1.0 - 1e-9;

/// Bayes' rule for one entry, with its present value as the prior (8.13).
double posterior(double prior, double ratio) {
  const double assigned = ratio * prior;
  return assigned / (assigned + (1.0 - prior));
}

/// What the other entries of a row are multiplied by when one goes from `before` to `after`: eq. 8.19, as one fraction.
double rescale(double before, double after) { return (1.0 - after) / (1.0 - before); }

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
    const double belief = std::min(posterior(untouched, e.color * e.position * e.size) * e.velocity, most_belief);
    row[i] = belief;
    // The factors of the steps telescope.
    scales[i] = rescale(untouched, belief);
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
