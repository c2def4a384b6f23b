// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "survtrack/tracking/lost_place.hpp"

#include <algorithm>

namespace survtrack {
namespace {

constexpr double border_margin = 0.25;  // of the object's sides
constexpr double covered_part = 1.0 / 3.0;

bool at_border(const Box& box, const Detections& frame) {
  if (frame.frame_width <= 0 || frame.frame_height <= 0) return false;
  const double x = border_margin * box.width;
  const double y = border_margin * box.height;
  return touches_border({box.x - x, box.y - y, box.width + 2.0 * x, box.height + 2.0 * y}, frame.frame_width,
                        frame.frame_height);
}

bool covered(const Box& box, const Box& by) { return intersection_px(box, by) > covered_part * box.area_px(); }

}  // namespace

LostPlace lost_place(const TrackTable& table, int i, const Detections& detections) {
  const OpenTrack& lost = table.row(i);
  // Another step like the last: the prediction for now, many frames later, may have run away.
  const Box next{lost.seen.x + lost.step_px.x, lost.seen.y + lost.step_px.y, lost.seen.width, lost.seen.height};
  if (at_border(lost.seen, detections) || at_border(next, detections)) return LostPlace::border;
  for (int other = 0; other < table.size(); ++other) {
    const Track& track = table.row(other).track;
    if (other == i || !table.row(other).believed() || track.lost_frames > 0) continue;
    if (covered(lost.seen, track.box) || covered(lost.track.box, track.box)) return LostPlace::behind_object;
  }
  return LostPlace::open;
}

}  // namespace survtrack
