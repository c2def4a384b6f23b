// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <vector>

#include "survtrack/association/cost_matrix.hpp"

namespace survtrack {

/// A column a row, each column at most once; -1: the row stays alone.
using Assignment = std::vector<int>;

/// Optimal one-to-one assignment, reusing its memory from call to call. The parts that the gate leaves
/// connected are solved one by one, each by shortest augmenting paths (Jonker and Volgenant 1987) in O(n^2 m).
/// Deterministic: of equally good columns the first is taken.
class HungarianSolver {
 public:
  /// Assigns `rows` to the columns that `assignment`, of costs.rows() entries, has not given away. A row that
  /// stays alone costs `unassigned_cost`; infinite: as many pairs as possible, and of those the cheapest.
  void assign(const CostMatrix& costs, const std::vector<int>& rows, double unassigned_cost, Assignment& assignment);

 private:
  int root(int node);
  void connect(const CostMatrix& costs, const std::vector<int>& rows);
  void solve_part(const CostMatrix& costs, double unassigned_cost, Assignment& assignment);
  template <class Cost>
  void augment(int n, int m, const Cost& cost);

  std::vector<char> taken_;             ///< a column
  std::vector<int> columns_;            ///< those still free
  std::vector<int> parent_, order_;     ///< union-find over rows, then columns; the same sorted by part
  std::vector<int> part_rows_, part_columns_;
  // Of one part; index 0 is the artificial start, rows and columns count from 1.
  std::vector<double> row_potential_, column_potential_, shortest_;
  std::vector<int> row_of_, previous_;
  std::vector<char> done_;
};

}  // namespace survtrack
