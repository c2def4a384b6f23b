// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "offline/sparse_assignment.hpp"

#include <algorithm>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

namespace survtrack {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

constexpr double infinite = std::numeric_limits<double>::infinity();

/// Costs count from `unassigned_cost`: useful pairs are negative, a row that stays alone costs 0.
class SparseAssigner {
 public:
  SparseAssigner(const std::vector<std::vector<SparsePair>>& rows, int columns, double unassigned_cost)
      : rows_(rows),
        unassigned_cost_(unassigned_cost),
        assignment_(rows.size(), -1),
        row_potential_(rows.size(), 0.0),
        row_of_(at(columns), -1),
        column_potential_(at(columns), 0.0),
        shortest_(at(columns), infinite),
        previous_(at(columns), -1),
        done_(at(columns), char{0}) {}

  Assignment solve() {
    for (int row = 0; row < static_cast<int>(rows_.size()); ++row) augment(row);
    return std::move(assignment_);
  }

 private:
  /// Finds the shortest path from a row to a free column, or to a row that gives its column away and stays alone.
  void augment(int root) {
    start(root);
    look(root, 0.0);
    double alone = -row_potential_[at(root)];  // length of the shortest path that leaves a row alone
    int alone_row = root, free_column = -1;
    double length = alone;
    while (!queue_.empty()) {
      const auto [distance, column] = queue_.top();
      queue_.pop();
      if (done_[at(column)] || distance > shortest_[at(column)]) continue;
      if (distance >= alone) break;
      if (row_of_[at(column)] < 0) {
        free_column = column;
        length = distance;
        break;
      }
      done_[at(column)] = 1;
      const int row = row_of_[at(column)];
      look(row, distance);
      if (distance - row_potential_[at(row)] < alone) {
        alone = distance - row_potential_[at(row)];
        alone_row = row;
      }
    }
    if (free_column < 0) length = alone;
    update_potentials(root, length);
    int column = free_column;
    if (free_column < 0) column = std::exchange(assignment_[at(alone_row)], -1);
    give_along_path(root, alone_row, column, free_column >= 0);
  }

  void start(int root) {
    for (const int column : touched_) {
      shortest_[at(column)] = infinite;
      done_[at(column)] = 0;
    }
    touched_.clear();
    queue_ = {};
    double least = 0.0;
    for (const SparsePair& pair : rows_[at(root)]) {
      least = std::min(least, pair.cost - unassigned_cost_ - column_potential_[at(pair.column)]);
    }
    row_potential_[at(root)] = least;
  }

  void look(int row, double distance) {
    for (const SparsePair& pair : rows_[at(row)]) {
      const double cost = pair.cost - unassigned_cost_;
      if (!(cost < 0.0) || done_[at(pair.column)]) continue;
      const double reduced = cost - row_potential_[at(row)] - column_potential_[at(pair.column)];
      const double length = distance + std::max(reduced, 0.0);  // below 0 by rounding only
      if (!(length < shortest_[at(pair.column)])) continue;
      if (shortest_[at(pair.column)] == infinite) touched_.push_back(pair.column);
      shortest_[at(pair.column)] = length;
      previous_[at(pair.column)] = row;
      queue_.emplace(length, pair.column);
    }
  }

  void update_potentials(int root, double length) {
    row_potential_[at(root)] += length;
    for (const int column : touched_) {
      if (!done_[at(column)]) continue;
      column_potential_[at(column)] -= length - shortest_[at(column)];
      row_potential_[at(row_of_[at(column)])] += length - shortest_[at(column)];
    }
  }

  /// Moves every row on the path from `column` back to the root one column on.
  void give_along_path(int root, int alone_row, int column, bool to_free_column) {
    if (!to_free_column && alone_row == root) return;
    while (true) {
      const int row = previous_[at(column)];
      row_of_[at(column)] = row;
      const int before = std::exchange(assignment_[at(row)], column);
      if (row == root) return;
      column = before;
    }
  }

  const std::vector<std::vector<SparsePair>>& rows_;
  double unassigned_cost_;
  Assignment assignment_;
  std::vector<double> row_potential_;
  // A column each.
  std::vector<int> row_of_;
  std::vector<double> column_potential_, shortest_;
  std::vector<int> previous_;
  std::vector<char> done_;
  std::vector<int> touched_;
  using Reached = std::pair<double, int>;
  std::priority_queue<Reached, std::vector<Reached>, std::greater<>> queue_;
};

}  // namespace

Assignment assign_sparse(const std::vector<std::vector<SparsePair>>& rows, int columns, double unassigned_cost) {
  return SparseAssigner(rows, columns, unassigned_cost).solve();
}

}  // namespace survtrack
