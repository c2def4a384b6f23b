// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "survtrack/filtering/particle_filter.hpp"
#include "core/text_of.hpp"

namespace survtrack {

void check_particle_options(const ParticleFilterOptions& options) {
  if (options.count < 1 || options.count > 10'000'000) {
    throw InputError("count: is " + std::to_string(options.count) + "; expected 1 to 10000000 particles");
  }
  if (!(options.resample_below >= 0.0 && options.resample_below <= 1.0)) {
    throw InputError("resample_below: is " + text_of(options.resample_below) + "; expected a share, 0 to 1");
  }
}

void check_particle_weights(const Eigen::VectorXd& weights) {
  check_matrix("weights", weights, weights.size(), 1);
  if (weights.minCoeff() < 0.0 || !(weights.sum() > 0.0) || !std::isfinite(weights.sum())) {
    throw InputError("weights: expected numbers of at least 0 with a sum above 0");
  }
}

std::vector<int> systematic_resample(const Eigen::VectorXd& weights, double offset) {
  check_particle_weights(weights);
  if (!(offset >= 0.0 && offset < 1.0)) {
    throw InputError("offset: is " + text_of(offset) + "; expected a number from 0 up to 1, without 1");
  }
  const Eigen::Index count = weights.size();
  const double step = weights.sum() / static_cast<double>(count);
  std::vector<int> chosen(static_cast<std::size_t>(count));
  Eigen::Index item = 0;
  double reached = weights(0);
  for (Eigen::Index i = 0; i < count; ++i) {
    const double position = (static_cast<double>(i) + offset) * step;
    // Rounding may carry the last positions past the sum: what has no weight is not chosen even then.
    while (position >= reached && item + 1 < count) reached += weights(++item);
    while (weights(item) == 0.0) --item;
    chosen[static_cast<std::size_t>(i)] = static_cast<int>(item);
  }
  return chosen;
}

}  // namespace survtrack
