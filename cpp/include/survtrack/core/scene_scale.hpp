// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cmath>

namespace survtrack {

/// How large an object should measure where its foot stands: with one camera over level ground the height of
/// upright objects is linear in the row of their lower edge. Learned by the tracker, used by the detector.
struct SceneScale {
  bool known = false;                ///< enough was seen for the law to be used
  double height_at_top_px = 0.0;     ///< at row 0
  double height_per_row = 0.0;       ///< px a row
  double min_height_px = 0.0;

  /// Expected height in px of an object whose lower edge is at row `bottom`.
  double height_px(double bottom) const { return std::fmax(height_at_top_px + height_per_row * bottom, min_height_px); }
};

}  // namespace survtrack
