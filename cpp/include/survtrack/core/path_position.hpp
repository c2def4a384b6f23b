// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

namespace survtrack {

/// A place or a velocity by a path: along it and across it, px or px/s.
struct PathPosition {
  double s_px = 0.0;  ///< length along the path from its start
  double t_px = 0.0;  ///< distance across it, positive to the right of who goes along it, as seen in the picture

  friend bool operator==(const PathPosition& a, const PathPosition& b) { return a.s_px == b.s_px && a.t_px == b.t_px; }
};

}  // namespace survtrack
