// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <initializer_list>

#include "survtrack/association/cost_matrix.hpp"

namespace survtrack {

/// A matrix of costs from its rows, all of one length.
inline CostMatrix costs_of(std::initializer_list<std::initializer_list<double>> rows) {
  CostMatrix costs;
  costs.resize(static_cast<int>(rows.size()), rows.size() == 0 ? 0 : static_cast<int>(rows.begin()->size()));
  int r = 0;
  for (const auto& row : rows) {
    int c = 0;
    for (const double cost : row) costs(r, c++) = cost;
    ++r;
  }
  return costs;
}

constexpr double gated = CostMatrix::gated;

}  // namespace survtrack
