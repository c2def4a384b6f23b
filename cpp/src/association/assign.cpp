// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "survtrack/association/assign.hpp"

#include <cmath>
#include <numeric>
#include <string>

#include "survtrack/core/errors.hpp"

namespace survtrack {
namespace {

/// What is no number has no order: no assignment would end.
void check_costs(const CostMatrix& costs) {
  for (int r = 0; r < costs.rows(); ++r) {
    for (int c = 0; c < costs.columns(); ++c) {
      if (!std::isnan(costs(r, c))) continue;
      throw InputError("costs(" + std::to_string(r) + ", " + std::to_string(c) +
                       "): is not a number; expected a cost, or infinity for a pair that is refused");
    }
  }
}

}  // namespace

Assignment assign_oldest_first(const CostMatrix& costs) {
  check_costs(costs);
  Assignment assignment(static_cast<std::size_t>(costs.rows()), -1);
  std::vector<char> taken(static_cast<std::size_t>(costs.columns()), char{0});
  for (int r = 0; r < costs.rows(); ++r) {
    int best = -1;
    for (int c = 0; c < costs.columns(); ++c) {
      if (taken[static_cast<std::size_t>(c)] || std::isinf(costs(r, c))) continue;
      if (best < 0 || costs(r, c) < costs(r, best)) best = c;
    }
    if (best < 0) continue;
    taken[static_cast<std::size_t>(best)] = 1;
    assignment[static_cast<std::size_t>(r)] = best;
  }
  return assignment;
}

Assignment assign_hungarian(const CostMatrix& costs, double unassigned_cost) {
  check_costs(costs);
  if (std::isnan(unassigned_cost)) throw InputError("unassigned_cost: is not a number");
  Assignment assignment(static_cast<std::size_t>(costs.rows()), -1);
  std::vector<int> rows(assignment.size());
  std::iota(rows.begin(), rows.end(), 0);
  HungarianSolver().assign(costs, rows, unassigned_cost, assignment);
  return assignment;
}

}  // namespace survtrack
