// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "survtrack/core/geometry.hpp"

namespace survtrack {

/// What one cell of the scene has learned from the tracks that moved there.
struct VicinityCell {
  double factor_y = 1.0;  ///< vicinity factor in Y, 1 to the largest
  double factor_x = 1.0;
  std::int64_t updates = 0;
  double mean_step_px = 0.0;      ///< length of a displacement, px per time unit
  double step_variance_px2 = 0.0;
};

/// The vicinity factor (Narayana 2007, 6): how much things move, and so how near they are, in each cell of the scene.
struct VicinityGrid {
  int cell_px = 0;
  int frame_width = 0;   ///< px
  int frame_height = 0;  ///< px
  int rows = 0;
  int columns = 0;
  double max_factor = 1.0;
  std::vector<VicinityCell> cells;  ///< row by row

  /// The cell that holds a point; the nearest one for points outside the frame.
  std::size_t index_of(const Point& p) const {
    const auto along = [this](double place, int count) {
      return static_cast<std::size_t>(std::clamp(std::floor(place / cell_px), 0.0, count - 1.0));
    };
    return along(p.y, rows) * static_cast<std::size_t>(columns) + along(p.x, columns);
  }
  const VicinityCell& at(const Point& p) const { return cells[index_of(p)]; }

  /// Relative size of objects (7.2): the length of the factor.
  static double relative_size(const VicinityCell& cell) { return std::hypot(cell.factor_y, cell.factor_x); }
  /// An active region (7.2): something was followed there.
  static bool active(const VicinityCell& cell) { return cell.updates > 0; }
};

}  // namespace survtrack
