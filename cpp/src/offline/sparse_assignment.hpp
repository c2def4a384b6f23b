// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <vector>

#include "survtrack/association/hungarian.hpp"

namespace survtrack {

/// One pair that may be made.
struct SparsePair {
  int column = 0;
  double cost = 0.0;  ///< finite
};

/// The assignment of `assign_hungarian` for matrices that are nearly empty and may be very large: the pairs that each row
/// may make, by column, instead of a matrix. `unassigned_cost` is finite; a pair that costs as much is not made. By
/// shortest augmenting paths, each found by Dijkstra's method with potentials (Edmonds and Karp 1972; Tomizawa 1971).
/// Deterministic.
Assignment assign_sparse(const std::vector<std::vector<SparsePair>>& rows, int columns, double unassigned_cost);

}  // namespace survtrack
