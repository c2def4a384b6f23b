// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <memory>

#include "survtrack/core/detection.hpp"
#include "survtrack/core/event.hpp"
#include "survtrack/core/matches.hpp"
#include "survtrack/tracking/options.hpp"
#include "survtrack/tracking/track_table.hpp"

namespace survtrack {

/// Decides, alone, which tracks are born, believed, coasting, closed and reported.
class Lifecycle {
 public:
  virtual ~Lifecycle() = default;

  /// One frame's decisions. The table's matched rows are already matched, the others missed; new tracks come
  /// from detections without a track. Closed tracks stay in the table, so that the result can show them.
  virtual void update(TrackTable& table, const Detections& detections, const Matches& matches) = 0;

  /// Forgets what it remembers beside the tracks.
  virtual void clear() {}
};

/// Whether the middle of a box lies outside of the frame; never while its size is unknown.
bool outside_frame(const Box& box, const Detections& now);

std::unique_ptr<Lifecycle> make_lifecycle(const LifecycleOptions& options);

}  // namespace survtrack
