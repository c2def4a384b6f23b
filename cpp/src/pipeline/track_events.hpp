// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "survtrack/core/detection.hpp"
#include "survtrack/core/event.hpp"
#include "survtrack/tracking/convergence.hpp"
#include "survtrack/tracking/groups.hpp"
#include "survtrack/tracking/measurement.hpp"

namespace survtrack {

/// What a track did in this frame.
Event event_of(EventKind kind, const Track& track, const Detections& now);

/// A track is believed from here on: it is new, or has the identity of one that ended.
Event start_of(const OpenTrack& row, const Detections& now);

/// A track's end, told from where it was measured last.
Event end_of(const OpenTrack& row, LostPlace place, const Detections& now);

/// Tracks that believe to be one blob.
Event meeting_of(const Convergence& met, const Detections& now);

/// Tracks that merged into one blob, or parted.
Event change_of(EventKind kind, const GroupChange& change, const Detections& now);

}  // namespace survtrack
