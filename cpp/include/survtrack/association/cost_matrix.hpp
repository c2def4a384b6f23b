// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <limits>
#include <vector>

namespace survtrack {

/// Costs of tracks (rows) by detections (columns); infinite outside the gate. Reuses its memory.
class CostMatrix {
 public:
  static constexpr double gated = std::numeric_limits<double>::infinity();

  void resize(int rows, int columns) {
    rows_ = rows;
    columns_ = columns;
    values_.assign(static_cast<std::size_t>(rows) * static_cast<std::size_t>(columns), gated);
  }
  int rows() const { return rows_; }
  int columns() const { return columns_; }
  double& operator()(int row, int column) { return values_[offset(row, column)]; }
  double operator()(int row, int column) const { return values_[offset(row, column)]; }

 private:
  std::size_t offset(int row, int column) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column);
  }
  int rows_ = 0;
  int columns_ = 0;
  std::vector<double> values_;
};

}  // namespace survtrack
