// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "survtrack/association/assign.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

#include "survtrack/core/errors.hpp"

namespace survtrack {
namespace {

/// Sets of rows and columns that gates connect, by union-find over rows, then columns.
class Components {
 public:
  explicit Components(int count) : parent_(static_cast<std::size_t>(count)) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }
  int root(int i) {
    while (parent_[at(i)] != i) i = parent_[at(i)] = parent_[at(parent_[at(i)])];
    return i;
  }
  void join(int i, int j) {
    const int a = root(i);
    const int b = root(j);
    parent_[at(std::max(a, b))] = std::min(a, b);
  }

 private:
  static std::size_t at(int i) { return static_cast<std::size_t>(i); }
  std::vector<int> parent_;
};

/// Minimum-cost assignment of each of `n` rows to one of `m >= n` columns by shortest augmenting paths with
/// potentials. `cost(i, j)` is finite. Deterministic: of equal paths the lowest column wins.
template <class Cost>
std::vector<int> solve(int n, int m, const Cost& cost) {
  const auto columns = static_cast<std::size_t>(m) + 1;
  const double infinity = CostMatrix::gated;
  // Index 0 is the artificial start; rows and columns count from 1 here.
  std::vector<double> row_potential(static_cast<std::size_t>(n) + 1, 0.0), column_potential(columns, 0.0);
  std::vector<double> shortest(columns);
  std::vector<int> row_of(columns, 0), previous(columns, 0);
  std::vector<char> done(columns);
  for (int row = 1; row <= n; ++row) {
    row_of[0] = row;
    std::size_t current = 0;
    std::fill(shortest.begin(), shortest.end(), infinity);
    std::fill(done.begin(), done.end(), char{0});
    do {
      done[current] = 1;
      const int i = row_of[current];
      double delta = infinity;
      std::size_t next = 0;
      for (std::size_t j = 1; j < columns; ++j) {
        if (done[j]) continue;
        const double reduced =
            cost(i - 1, static_cast<int>(j) - 1) - row_potential[static_cast<std::size_t>(i)] - column_potential[j];
        if (reduced < shortest[j]) {
          shortest[j] = reduced;
          previous[j] = static_cast<int>(current);
        }
        if (shortest[j] < delta) {
          delta = shortest[j];
          next = j;
        }
      }
      for (std::size_t j = 0; j < columns; ++j) {
        if (done[j]) {
          row_potential[static_cast<std::size_t>(row_of[j])] += delta;
          column_potential[j] -= delta;
        } else {
          shortest[j] -= delta;
        }
      }
      current = next;
    } while (row_of[current] != 0);
    while (current != 0) {
      const auto before = static_cast<std::size_t>(previous[current]);
      row_of[current] = row_of[before];
      current = before;
    }
  }
  std::vector<int> column_of(static_cast<std::size_t>(n), -1);
  for (std::size_t j = 1; j < columns; ++j) {
    if (row_of[j] != 0) column_of[static_cast<std::size_t>(row_of[j]) - 1] = static_cast<int>(j) - 1;
  }
  return column_of;
}

/// Solves one connected part. Each pair counts by what it saves against its row staying alone; what saves
/// nothing counts 0, as an unassigned row does.
void solve_part(const CostMatrix& costs, const std::vector<int>& rows, const std::vector<int>& columns,
                double unassigned_cost, Assignment& assignment) {
  const bool swapped = rows.size() > columns.size();
  const auto n = static_cast<int>(swapped ? columns.size() : rows.size());
  const auto m = static_cast<int>(swapped ? rows.size() : columns.size());
  if (std::isinf(unassigned_cost)) {
    // Large enough that one more pair always outweighs any difference between the pairs.
    double low = CostMatrix::gated, high = -CostMatrix::gated;
    for (const int r : rows) {
      for (const int c : columns) {
        if (std::isinf(costs(r, c))) continue;
        low = std::min(low, costs(r, c));
        high = std::max(high, costs(r, c));
      }
    }
    unassigned_cost = high + (high - low + 1.0) * n;
  }
  const auto saving = [&](int i, int j) {
    const int r = rows[static_cast<std::size_t>(swapped ? j : i)];
    const int c = columns[static_cast<std::size_t>(swapped ? i : j)];
    return std::isinf(costs(r, c)) ? 0.0 : std::min(costs(r, c) - unassigned_cost, 0.0);
  };
  const std::vector<int> partner = solve(n, m, saving);
  for (int i = 0; i < n; ++i) {
    const int j = partner[static_cast<std::size_t>(i)];
    if (j < 0 || !(saving(i, j) < 0.0)) continue;
    assignment[static_cast<std::size_t>(rows[static_cast<std::size_t>(swapped ? j : i)])] =
        columns[static_cast<std::size_t>(swapped ? i : j)];
  }
}

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
  const int n = costs.rows();
  const int m = costs.columns();
  Components components(n + m);
  for (int r = 0; r < n; ++r) {
    for (int c = 0; c < m; ++c) {
      if (!std::isinf(costs(r, c))) components.join(r, n + c);
    }
  }
  std::vector<std::vector<int>> rows(static_cast<std::size_t>(n)), columns(static_cast<std::size_t>(n));
  for (int r = 0; r < n; ++r) rows[static_cast<std::size_t>(components.root(r))].push_back(r);
  for (int c = 0; c < m; ++c) {
    const int root = components.root(n + c);
    if (root < n) columns[static_cast<std::size_t>(root)].push_back(c);
  }
  Assignment assignment(static_cast<std::size_t>(n), -1);
  for (std::size_t part = 0; part < rows.size(); ++part) {
    if (rows[part].empty() || columns[part].empty()) continue;
    solve_part(costs, rows[part], columns[part], unassigned_cost, assignment);
  }
  return assignment;
}

Assignment assign(const AssignmentOptions& options, const CostMatrix& costs, double unassigned_cost) {
  if (std::holds_alternative<OldestFirstOptions>(options)) return assign_oldest_first(costs);
  return assign_hungarian(costs, unassigned_cost);
}

}  // namespace survtrack
