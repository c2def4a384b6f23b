// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "survtrack/tracking/region_planner.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "core/text_of.hpp"
#include "survtrack/core/errors.hpp"

namespace survtrack {
namespace {

/// The part of a box inside the frame; without size when it lies outside.
Box inside(const Box& box, double width, double height) {
  const double left = std::clamp(box.x, 0.0, width), right = std::clamp(box.right(), 0.0, width);
  const double top = std::clamp(box.y, 0.0, height), bottom = std::clamp(box.bottom(), 0.0, height);
  return {left, top, right - left, bottom - top};
}

/// Rounding may take a variance a little below 0.
Symmetric2 without_negative(const Symmetric2& C) { return {std::max(C.xx, 0.0), C.xy, std::max(C.yy, 0.0)}; }

bool is_finite(const ExpectedObject& object) {
  const Symmetric2& C = object.covariance_px2;
  const Box& box = object.box;
  const double sum = object.before.x + object.before.y + object.position.x + object.position.y + C.xx + C.xy + C.yy + box.x +
                     box.y + box.width + box.height;
  return std::isfinite(sum);
}

}  // namespace

void RegionPlanner::load_zones(const std::vector<Box>& zones) {
  if (zones.empty()) throw InputError("zones: are none; expected one or more");
  for (std::size_t i = 0; i < zones.size(); ++i) {
    const Box& zone = zones[i];
    const bool finite = std::isfinite(zone.x) && std::isfinite(zone.y) && std::isfinite(zone.width) && std::isfinite(zone.height);
    if (finite && zone.width > 0.0 && zone.height > 0.0) continue;
    throw InputError("zones[" + std::to_string(i) + "]: " + text_of({zone.x, zone.y, zone.width, zone.height}) +
                     " is not allowed; expected finite left and top, width and height above 0 px");
  }
  zones_ = zones;
}

void RegionPlanner::check(int frame_width, int frame_height) const {
  if (!wants_zones()) return;
  if (zones_.empty()) {
    throw InputError("regions.acquisition: \"zones\" needs zones, and none were given; "
                     "expected load_zones() or --zone LEFT,TOP,WIDTH,HEIGHT before the first frame");
  }
  for (std::size_t i = 0; i < zones_.size() && frame_width > 0; ++i) {
    const Box part = inside(zones_[i], frame_width, frame_height);
    if (part.width > 0.0 && part.height > 0.0) continue;
    throw InputError("zones[" + std::to_string(i) + "]: " + text_of({zones_[i].x, zones_[i].y, zones_[i].width, zones_[i].height}) + " lies outside of the frame of " +
                     std::to_string(frame_width) + "x" + std::to_string(frame_height) + " px; expected one that meets it");
  }
}

void RegionPlanner::plan(const TrackTable& table, int frame_width, int frame_height, std::vector<Region>& regions) const {
  regions.clear();
  const double width = frame_width, height = frame_height;
  const auto add = [&](const Box& box, RegionKind kind, std::int64_t track_id) {
    const Box part = inside(box, width, height);
    if (part.width > 0.0 && part.height > 0.0) regions.push_back({part, kind, track_id});
  };
  if (options_.acquisition == Acquisition::border) {
    const double band = std::clamp(options_.border * height, 1.0, 0.5 * std::min(width, height));
    for (const Box& side : {Box{0.0, 0.0, width, band}, Box{0.0, height - band, width, band},
                            Box{0.0, band, band, height - 2.0 * band}, Box{width - band, band, band, height - 2.0 * band}}) {
      add(side, RegionKind::acquisition, 0);
    }
  } else if (options_.acquisition == Acquisition::zones) {
    for (const Box& zone : zones_) add(zone, RegionKind::acquisition, 0);
  }
  for (int i = 0; i < table.size(); ++i) {
    const std::optional<Box> region = region_of(table, i);
    add(region.value_or(Box{0.0, 0.0, width, height}), RegionKind::predicted, table.row(i).track.id);
  }
}

/// Nothing when the object may be anywhere: after very long gaps numbers grow beyond all bounds.
std::optional<Box> RegionPlanner::region_of(const TrackTable& table, int i) const {
  const OpenTrack& row = table.row(i);
  ExpectedObject object;
  object.before = row.track.position;
  object.position = table.predicted_position(i);
  object.covariance_px2 = without_negative(table.predicted_covariance_px2(i));
  object.box = table.predicted_box(i);
  object.lost_s = table.lost_s(i);
  const std::optional<PathState> state = table.path_state(i);
  // What was cut off, by the border or by the region itself, is seen only when the region allows for it. What follows a path
  // may turn, and its height with it.
  const SceneScale scale = table.scale().scale();
  if (scale.known && !state) {
    const double missing = scale.height_px(object.box.bottom()) - object.box.height;
    if (missing > 0.0) object.box = {object.box.x, object.box.y - missing, object.box.width, object.box.height + missing};
  }
  if (!is_finite(object)) return std::nullopt;
  if (state) {
    const Symmetric2 covariance = without_negative(state->covariance_px2);
    if (!std::isfinite(covariance.xx) || !std::isfinite(covariance.yy)) return std::nullopt;
    return predicted_region(options_, object, *state->path, {state->place_before, state->predicted, covariance});
  }
  return predicted_region(options_, object);
}

}  // namespace survtrack
