// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "survtrack/core/detection.hpp"
#include "survtrack/core/event.hpp"
#include "survtrack/tracking/track_table.hpp"

namespace survtrack {

/// Where row `i`, which is not matched now, was when it was seen last: at the border if its last box reached it or
/// would have within a quarter of its size, there or one more step like its last on; else behind an object if a track that is matched now covers a third of that
/// box or of the one predicted for now; else in the open.
LostPlace lost_place(const TrackTable& table, int i, const Detections& detections);

}  // namespace survtrack
