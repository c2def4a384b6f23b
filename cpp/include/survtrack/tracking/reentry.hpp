// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <vector>

#include "survtrack/core/geometry.hpp"
#include "survtrack/tracking/identity_options.hpp"
#include "survtrack/tracking/measurement.hpp"

namespace survtrack {

/// The tracks that ended, and which of them a newcomer is.
class ReentryMemory {
 public:
  explicit ReentryMemory(const RememberOptions& options) : options_(options) {}

  /// A believed track that is closed now.
  void remember(const OpenTrack& ended);

  struct Identity {
    std::int64_t id = 0;      ///< 0: someone new
    double confidence = 0.0;  ///< 0 to 1, see RememberOptions
  };
  /// Which tracks the newcomers of one frame continue; those are then no longer remembered. The surest goes first, and
  /// the newcomers' order does not matter. Of a newcomer's velocity nothing is known: its first place counts.
  std::vector<Identity> claim(const std::vector<const OpenTrack*>& newcomers);

  void clear() { ended_.clear(); }

 private:
  struct Ended {
    std::int64_t id = 0;
    Point position;           ///< px, measured last
    Point velocity_px_per_s;
    double size_px = 0.0;
    Color color;
    double time_s = 0.0;      ///< of the last detection
  };
  double weight(const Ended& ended, const OpenTrack& newcomer) const;

  RememberOptions options_;
  std::vector<Ended> ended_;  ///< in the order in which they were closed
};

}  // namespace survtrack
