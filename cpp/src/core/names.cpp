// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "survtrack/core/event.hpp"
#include "survtrack/core/region.hpp"
#include "survtrack/core/track.hpp"

namespace survtrack {

const char* to_string(EventKind kind) {
  switch (kind) {
    case EventKind::track_started: return "track_started";
    case EventKind::track_reentered: return "track_reentered";
    case EventKind::track_lost: return "track_lost";
    case EventKind::track_recovered: return "track_recovered";
    case EventKind::track_ended: return "track_ended";
    case EventKind::merged: return "merged";
    case EventKind::split: return "split";
    case EventKind::converged: return "converged";
    case EventKind::anomalous_speed: return "anomalous_speed";
    case EventKind::scene_changed: return "scene_changed";
  }
  return "";
}

const char* to_string(LostPlace place) {
  switch (place) {
    case LostPlace::none: return "none";
    case LostPlace::border: return "border";
    case LostPlace::behind_object: return "behind_object";
    case LostPlace::open: return "open";
  }
  return "";
}

const char* to_string(RegionKind kind) {
  switch (kind) {
    case RegionKind::whole_frame: return "whole_frame";
    case RegionKind::predicted: return "predicted";
    case RegionKind::acquisition: return "acquisition";
    case RegionKind::refresh: return "refresh";
  }
  return "";
}

const char* to_string(TrackStatus status) {
  switch (status) {
    case TrackStatus::tentative: return "tentative";
    case TrackStatus::confirmed: return "confirmed";
    case TrackStatus::lost: return "lost";
    case TrackStatus::closed: return "closed";
  }
  return "";
}

}  // namespace survtrack
