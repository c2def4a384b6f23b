// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "survtrack/association/hungarian.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace survtrack {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// What a row that stays alone must cost so that one more pair outweighs any difference between pairs.
double more_than_any_pair(const CostMatrix& costs, const std::vector<int>& rows, const std::vector<int>& columns) {
  double low = CostMatrix::gated, high = -CostMatrix::gated;
  for (const int r : rows) {
    for (const int c : columns) {
      if (std::isinf(costs(r, c))) continue;
      low = std::min(low, costs(r, c));
      high = std::max(high, costs(r, c));
    }
  }
  return high + (high - low + 1.0) * static_cast<double>(std::min(rows.size(), columns.size()));
}

}  // namespace

int HungarianSolver::root(int node) {
  while (parent_[at(node)] != node) node = parent_[at(node)] = parent_[at(parent_[at(node)])];
  return node;
}

/// Sorts rows (0 to n - 1) and free columns (from n) by the connected part they belong to.
void HungarianSolver::connect(const CostMatrix& costs, const std::vector<int>& rows) {
  const auto n = static_cast<int>(rows.size());
  const auto m = static_cast<int>(columns_.size());
  parent_.resize(at(n + m));
  std::iota(parent_.begin(), parent_.end(), 0);
  for (int r = 0; r < n; ++r) {
    for (int c = 0; c < m; ++c) {
      if (std::isinf(costs(rows[at(r)], columns_[at(c)]))) continue;
      const int a = root(r), b = root(n + c);
      parent_[at(std::max(a, b))] = std::min(a, b);
    }
  }
  for (int node = 0; node < n + m; ++node) parent_[at(node)] = root(node);
  order_.resize(at(n + m));
  std::iota(order_.begin(), order_.end(), 0);
  std::sort(order_.begin(), order_.end(), [&](int a, int b) {
    return parent_[at(a)] != parent_[at(b)] ? parent_[at(a)] < parent_[at(b)] : a < b;
  });
}

void HungarianSolver::assign(const CostMatrix& costs, const std::vector<int>& rows, double unassigned_cost,
                             Assignment& assignment) {
  taken_.assign(at(costs.columns()), char{0});
  for (const int c : assignment) {
    if (c >= 0) taken_[at(c)] = 1;
  }
  columns_.clear();
  for (int c = 0; c < costs.columns(); ++c) {
    if (!taken_[at(c)]) columns_.push_back(c);
  }
  connect(costs, rows);
  const auto n = static_cast<int>(rows.size());
  for (std::size_t begin = 0; begin < order_.size();) {
    const int part = parent_[at(order_[begin])];
    part_rows_.clear();
    part_columns_.clear();
    for (; begin < order_.size() && parent_[at(order_[begin])] == part; ++begin) {
      const int node = order_[begin];
      if (node < n) {
        part_rows_.push_back(rows[at(node)]);
      } else {
        part_columns_.push_back(columns_[at(node - n)]);
      }
    }
    if (!part_rows_.empty() && !part_columns_.empty()) solve_part(costs, unassigned_cost, assignment);
  }
}

/// Each pair counts by what it saves against its row staying alone; what saves nothing counts 0, as an
/// unassigned row does.
void HungarianSolver::solve_part(const CostMatrix& costs, double unassigned_cost, Assignment& assignment) {
  const bool swapped = part_rows_.size() > part_columns_.size();
  const std::vector<int>& few = swapped ? part_columns_ : part_rows_;
  const std::vector<int>& many = swapped ? part_rows_ : part_columns_;
  if (std::isinf(unassigned_cost)) unassigned_cost = more_than_any_pair(costs, part_rows_, part_columns_);
  const auto saving = [&](int i, int j) {
    const double cost = swapped ? costs(many[at(j)], few[at(i)]) : costs(few[at(i)], many[at(j)]);
    return std::isinf(cost) ? 0.0 : std::min(cost - unassigned_cost, 0.0);
  };
  augment(static_cast<int>(few.size()), static_cast<int>(many.size()), saving);
  for (int j = 0; j < static_cast<int>(many.size()); ++j) {
    const int i = row_of_[at(j + 1)] - 1;
    if (i < 0 || !(saving(i, j) < 0.0)) continue;
    assignment[at(swapped ? many[at(j)] : few[at(i)])] = swapped ? few[at(i)] : many[at(j)];
  }
}

/// Gives each of `n` rows one of `m >= n` columns at the least total of the finite `cost(i, j)`; the row of
/// column j, from 1, is then row_of_[j], 0 for none.
template <class Cost>
void HungarianSolver::augment(int n, int m, const Cost& cost) {
  const std::size_t columns = at(m) + 1;
  row_potential_.assign(at(n) + 1, 0.0);
  column_potential_.assign(columns, 0.0);
  row_of_.assign(columns, 0);
  previous_.assign(columns, 0);
  for (int row = 1; row <= n; ++row) {
    row_of_[0] = row;
    std::size_t current = 0;
    shortest_.assign(columns, CostMatrix::gated);
    done_.assign(columns, char{0});
    do {
      done_[current] = 1;
      const int i = row_of_[current];
      double delta = CostMatrix::gated;
      std::size_t next = 0;
      for (std::size_t j = 1; j < columns; ++j) {
        if (done_[j]) continue;
        const double reduced = cost(i - 1, static_cast<int>(j) - 1) - row_potential_[at(i)] - column_potential_[j];
        if (reduced < shortest_[j]) {
          shortest_[j] = reduced;
          previous_[j] = static_cast<int>(current);
        }
        if (shortest_[j] < delta) {
          delta = shortest_[j];
          next = j;
        }
      }
      for (std::size_t j = 0; j < columns; ++j) {
        if (done_[j]) {
          row_potential_[at(row_of_[j])] += delta;
          column_potential_[j] -= delta;
        } else {
          shortest_[j] -= delta;
        }
      }
      current = next;
    } while (row_of_[current] != 0);
    while (current != 0) {
      const std::size_t before = at(previous_[current]);
      row_of_[current] = row_of_[before];
      current = before;
    }
  }
}

}  // namespace survtrack
