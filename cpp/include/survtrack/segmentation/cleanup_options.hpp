// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "survtrack/core/fields.hpp"

namespace survtrack {

/// Noise removal on the mask, in this order: median, opening, closing. 0 leaves a step out.
struct CleanupOptions {
  int median_px = 5;
  int open_px = 0;
  int close_px = 0;

  static constexpr auto fields() {
    using O = CleanupOptions;
    return std::make_tuple(
        field("median_px", &O::median_px, "px", "side of the median's square", odd_up_to(31)),
        field("open_px", &O::open_px, "px", "side of the opening's square: removes what is thinner", odd_up_to(99)),
        field("close_px", &O::close_px, "px", "side of the closing's square: joins over narrower gaps",
              odd_up_to(99)));
  }
};

}  // namespace survtrack
