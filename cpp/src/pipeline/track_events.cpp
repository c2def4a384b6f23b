// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "pipeline/track_events.hpp"

#include <cmath>
#include <string>
#include <vector>

namespace survtrack {
namespace {

Event at(const Detections& now, EventKind kind) {
  Event event;
  event.kind = kind;
  event.index = now.index;
  event.time_s = now.time_s;
  return event;
}

/// An event of several tracks, the oldest first; `done` says what they did.
Event of_several(Event event, const std::vector<std::int64_t>& ids, const char* done) {
  event.track_id = ids.front();
  event.other_track_ids.assign(ids.begin() + 1, ids.end());
  event.text = "tracks " + std::to_string(ids.front());
  for (std::size_t i = 1; i < ids.size(); ++i) event.text += " and " + std::to_string(ids[i]);
  event.text += done;
  return event;
}

}  // namespace

Event event_of(EventKind kind, const Track& track, const Detections& now) {
  Event event = at(now, kind);
  event.track_id = track.id;
  event.position = track.position;
  event.box = track.box;
  event.position_covariance_px2 = track.position_covariance_px2;
  const std::string name = "track " + std::to_string(track.id);
  switch (kind) {
    case EventKind::track_started: event.text = name + " started"; break;
    case EventKind::track_reentered: event.text = name + " came back"; break;
    case EventKind::track_lost: event.text = name + " was lost"; break;
    case EventKind::track_recovered: event.text = name + " was found again"; break;
    case EventKind::anomalous_speed: event.text = name + " moves unlike others there"; break;
    default: event.text = name + " ended"; break;
  }
  return event;
}

Event start_of(const OpenTrack& row, const Detections& now) {
  if (row.reentry_confidence <= 0.0) return event_of(EventKind::track_started, row.track, now);
  Event event = event_of(EventKind::track_reentered, row.track, now);
  event.confidence = row.reentry_confidence;
  event.text += ", to " + std::to_string(std::lround(100.0 * row.reentry_confidence)) + " %";
  return event;
}

Event end_of(const OpenTrack& row, LostPlace place, const Detections& now) {
  Event event = event_of(EventKind::track_ended, row.track, now);
  event.position = row.seen_position;
  event.box = row.seen;
  event.place = place;
  switch (place) {
    case LostPlace::border: event.text += ": it was lost at the border"; break;
    case LostPlace::behind_object: event.text += ": it was lost behind another object"; break;
    case LostPlace::open: event.text += ": it was lost in the open"; break;
    case LostPlace::none: break;
  }
  return event;
}

Event meeting_of(const Convergence& met, const Detections& now) {
  Event event = of_several(at(now, EventKind::converged), met.track_ids, " met in one blob");
  const Detection& blob = now.items[static_cast<std::size_t>(met.detection)];
  event.position = blob.position;
  event.box = blob.box;
  return event;
}

Event change_of(EventKind kind, const GroupChange& change, const Detections& now) {
  Event event = of_several(at(now, kind), change.track_ids, kind == EventKind::merged ? " merged" : " parted");
  event.position = change.box.center();
  event.box = change.box;
  return event;
}

}  // namespace survtrack
