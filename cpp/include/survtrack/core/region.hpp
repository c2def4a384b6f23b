// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>

#include "survtrack/core/geometry.hpp"

namespace survtrack {

/// Why a part of a frame is read.
enum class RegionKind : std::uint8_t {
  whole_frame,  ///< everything: nothing is known yet, or regions would cost about as much
  predicted,    ///< where a track is expected
  acquisition,  ///< where newcomers appear
  refresh,      ///< in turn, so that the background stays up to date
};

/// Name of a kind, as written to files: "whole_frame", ...
const char* to_string(RegionKind kind);

/// A part of a frame that is read.
struct Region {
  Box box;                    ///< px
  RegionKind kind = RegionKind::predicted;
  std::int64_t track_id = 0;  ///< of a predicted one; 0: of a tentative track, or of none

  friend bool operator==(const Region& a, const Region& b) {
    return a.box == b.box && a.kind == b.kind && a.track_id == b.track_id;
  }
};

}  // namespace survtrack
