// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "offline/track_end.hpp"

#include <algorithm>
#include <cmath>

namespace survtrack {
namespace {

constexpr double time_slack_s = 1e-6;  // frame times are sums of rounded steps

using Iterator = std::vector<TrackPoint>::const_iterator;

double size_of(const TrackPoint& point) { return std::sqrt(point.box.area_px()); }

Point slope(Iterator first, Iterator last) {
  if (last - first < 2) return first->velocity_px_per_s;
  const double n = static_cast<double>(last - first);
  double mean_time = 0.0;
  Point mean;
  for (Iterator p = first; p != last; ++p) {
    // From the first point, so that large times and places lose no digits.
    mean_time += (p->time_s - first->time_s) / n;
    mean = mean + (1.0 / n) * (p->position - first->position);
  }
  double spread = 0.0;
  Point common;
  for (Iterator p = first; p != last; ++p) {
    const double dt = p->time_s - first->time_s - mean_time;
    spread += dt * dt;
    common = common + dt * (p->position - first->position - mean);
  }
  return (1.0 / spread) * common;
}

TrackEnd measured(const TrackPoint& outermost, Iterator first, Iterator last) {
  TrackEnd end{outermost.time_s, outermost.position, slope(first, last), 0.0, {}};
  const double n = static_cast<double>(last - first);
  for (Iterator p = first; p != last; ++p) {
    end.size_px += size_of(*p) / n;
    end.mean_color.blue += p->mean_color.blue / n;
    end.mean_color.green += p->mean_color.green / n;
    end.mean_color.red += p->mean_color.red / n;
  }
  return end;
}

}  // namespace

TrackEnd start_of(const RecordedTrack& track, double stretch_s) {
  const TrackPoint& first = track.points.front();
  const auto beyond = std::find_if(track.points.begin(), track.points.end(), [&](const TrackPoint& p) {
    return p.time_s - first.time_s > stretch_s + time_slack_s;
  });
  return measured(first, track.points.begin(), beyond);
}

TrackEnd end_of(const RecordedTrack& track, double stretch_s) {
  const TrackPoint& last = track.points.back();
  const auto beyond = std::find_if(track.points.rbegin(), track.points.rend(), [&](const TrackPoint& p) {
    return last.time_s - p.time_s > stretch_s + time_slack_s;
  });
  return measured(last, beyond.base(), track.points.end());
}

double size_of(const RecordedTrack& track) {
  double sum = 0.0;
  for (const TrackPoint& point : track.points) sum += size_of(point);
  return sum / static_cast<double>(track.points.size());
}

double travel_of(const RecordedTrack& track) {
  double farthest = 0.0;
  for (const TrackPoint& point : track.points) {
    const Point way = point.position - track.points.front().position;
    farthest = std::max(farthest, std::hypot(way.x, way.y));
  }
  return farthest;
}

}  // namespace survtrack
