// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "survtrack/core/geometry.hpp"

namespace survtrack {

/// What happened.
enum class EventKind : std::uint8_t {
  track_started,    ///< a track was confirmed: its first reported frame
  track_reentered,  ///< the same of one that continues a track that had ended, and has its id again
  track_lost,       ///< a confirmed track found no detection and is predicted from here on
  track_recovered,  ///< a lost track found a detection again
  track_ended,      ///< a confirmed track was closed
  merged,           ///< tracks share one detection from here on: a group
  split,            ///< tracks of a group have detections of their own again
  converged,        ///< two tracks or more believe to be the same blob (Narayana 2007, 8.1)
  anomalous_speed,  ///< a track moves unlike those before it in its cell of the vicinity grid (11.3)
  scene_changed,    ///< the whole scene changed (light, camera): the background starts anew
};

/// Name of a kind, as written to files: "track_started", ...
const char* to_string(EventKind kind);

/// Where a track was when it was seen last.
enum class LostPlace : std::uint8_t {
  none,           ///< the event is no loss
  border,         ///< at the frame's border: it left
  behind_object,  ///< beside or behind another track: occluded, or merged with it
  open,           ///< with nothing near: it stopped, or went behind the scene
};

/// Name of a place, as written to files: "border", ...
const char* to_string(LostPlace place);

/// Something that happened in one frame.
struct Event {
  EventKind kind = EventKind::track_started;
  std::int64_t index = 0;        ///< the frame's index in its source
  double time_s = 0.0;
  std::int64_t track_id = 0;     ///< 0: concerns no track
  std::vector<std::int64_t> other_track_ids;
  double confidence = 1.0;       ///< of a track that came back: that it is the same, 0 to 1
  Point position;                ///< px, last position known; of a track that ended the last one measured
  Box box;                       ///< the same of its box
  LostPlace place = LostPlace::none;  ///< of a track that ended: where it was lost
  Symmetric2 position_covariance_px2;
  std::string text;              ///< one readable sentence
};

}  // namespace survtrack
