// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "tracking/region_growth.hpp"

#include <algorithm>

namespace survtrack {
namespace {

/// Whether a box lies in a place where newcomers are looked for: anywhere, when none is set apart for them.
bool is_acquired(const Box& box, const std::vector<Region>& regions) {
  bool set_apart = false;
  for (const Region& region : regions) {
    if (region.kind != RegionKind::acquisition) continue;
    if (intersection_px(region.box, box) > 0.0) return true;
    set_apart = true;
  }
  return !set_apart;
}

}  // namespace

void RegionGrowth::update(TrackTable& table, const Detections& detections, const Matches& matches) {
  const int open = table.size();
  int alive = 0;
  for (int i = 0; i < open; ++i) {
    keep_or_close(table, i, detections);
    if (table.row(i).track.status != TrackStatus::closed) ++alive;
  }
  for (int d = 0; d < static_cast<int>(detections.items.size()) && alive < options_.max_objects; ++d) {
    if (matches.track_of_detection[static_cast<std::size_t>(d)] >= 0 || !may_start(table, open, d, detections)) continue;
    const int i = table.start(d, detections);
    table.believe(i);
    table.set_reported(i, true);
    ++alive;
  }
}

/// Nothing found: the prediction is the position, and the region has grown with its covariance.
void RegionGrowth::keep_or_close(TrackTable& table, int i, const Detections& now) const {
  const Track& track = table.row(i).track;
  if (track.lost_frames == 0) {
    table.set_status(i, TrackStatus::confirmed);
  } else if (track.lost_frames > options_.lost_after_frames || outside_frame(track.box, now)) {
    table.set_status(i, TrackStatus::closed);
  } else {
    table.set_status(i, TrackStatus::lost);
  }
  table.set_reported(i, track.status != TrackStatus::closed);
}

/// A piece of an object that is followed is no newcomer.
bool RegionGrowth::may_start(const TrackTable& table, int open, int d, const Detections& detections) const {
  const Box& box = detections.items[static_cast<std::size_t>(d)].box;
  if (!table.accepts(detections.items[static_cast<std::size_t>(d)])) return false;
  if (!is_acquired(box, detections.regions)) return false;
  for (int i = 0; i < open; ++i) {
    const Track& track = table.row(i).track;
    if (track.status == TrackStatus::confirmed && 2.0 * intersection_px(track.box, box) > box.area_px()) return false;
  }
  return true;
}

}  // namespace survtrack
