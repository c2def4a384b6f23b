// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "survtrack/association/cost_matrix.hpp"
#include "survtrack/association/hungarian.hpp"

namespace survtrack {

// Infinite costs are never taken. Entries that are no numbers are refused with an `InputError`.

/// Rows in order, each takes its cheapest free column; of equal ones the first (Narayana 2007, 3.5.4).
Assignment assign_oldest_first(const CostMatrix& costs);

/// Optimal one-to-one assignment. A row that stays alone costs `unassigned_cost`: with the gate's value, a
/// pair is made only where it lowers the total; infinite (the default): as many pairs as possible, and of
/// those the cheapest. See `HungarianSolver`.
Assignment assign_hungarian(const CostMatrix& costs, double unassigned_cost = CostMatrix::gated);

}  // namespace survtrack
