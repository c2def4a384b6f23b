// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "survtrack/filtering/unscented_kalman_filter.hpp"

#include <string>

#include "core/text_of.hpp"
#include "survtrack/core/errors.hpp"

namespace survtrack {

void check_sigma_points(const SigmaPoints& points, Eigen::Index n) {
  const auto refuse = [](const char* name, double value, const std::string& expected) {
    throw InputError(std::string(name) + ": is " + text_of(value) + "; expected " + expected);
  };
  // Below 1e-4 the weights are so large that rounding takes over.
  if (!(points.alpha >= 1e-4 && points.alpha <= 1.0)) refuse("alpha", points.alpha, "1e-4 to 1");
  if (!(points.beta >= 0.0 && points.beta <= 1e6)) refuse("beta", points.beta, "0 to 1e6");
  if (!(static_cast<double>(n) + points.kappa > 0.0 && points.kappa <= 1e6)) {
    refuse("kappa", points.kappa, "a number above -" + std::to_string(n) + " (minus the number of states), at most 1e6");
  }
}

}  // namespace survtrack
