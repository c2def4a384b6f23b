// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "survtrack/filtering/measured_track.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>
#include <string>

#include "filtering/straight_line.hpp"
#include "survtrack/core/errors.hpp"

namespace survtrack {
namespace {

template <class Value>
[[noreturn]] void refuse(const std::string& name, const Value& value, const std::string& expected) {
  std::ostringstream text;
  text << name << ": " << value << " is not allowed; expected " << expected;
  throw InputError(text.str());
}

std::string item(const std::string& list, std::size_t i) { return list + "[" + std::to_string(i) + "]"; }

void check(const std::string& name, const MeasuredTrack& track, std::size_t least) {
  const std::size_t count = track.times.size();
  if (count < least) refuse(name, std::to_string(count) + " measurements", "at least " + std::to_string(least));
  const auto fits = [&](const char* list, std::size_t size) {
    if (size != count) refuse(name + "." + list, std::to_string(size) + " values", std::to_string(count) + ", one a time");
  };
  fits("positions", track.positions.size());
  if (!track.lengths.empty()) fits("lengths", track.lengths.size());
  for (std::size_t i = 0; i < count; ++i) {
    const Point& p = track.positions[i];
    // Written so that NaN is refused too.
    if (!(std::abs(track.times[i]) <= 1e12)) refuse(item(name + ".times", i), track.times[i], "a finite time up to 1e12");
    if (!(std::abs(p.x) <= 1e9 && std::abs(p.y) <= 1e9)) {
      std::ostringstream place;
      place << "(" << p.x << ", " << p.y << ")";
      refuse(item(name + ".positions", i), place.str(), "finite numbers up to 1e9 px");
    }
    if (!track.lengths.empty() && !(track.lengths[i] >= 1e-3 && track.lengths[i] <= 1e9)) {
      refuse(item(name + ".lengths", i), track.lengths[i], "0.001 to 1e9 px");
    }
    if (i == 0) continue;
    const double step = track.times[i] - track.times[i - 1];
    if (!(step >= 1e-9 && step <= 1e6)) {
      refuse(item(name + ".times", i), track.times[i], "a time 1e-9 to 1e6 after the one before");
    }
  }
}

}  // namespace

void check_measured_tracks(const std::vector<MeasuredTrack>& tracks, std::size_t least) {
  if (tracks.empty()) throw InputError("tracks: there are none; expected at least one");
  for (std::size_t k = 0; k < tracks.size(); ++k) check(item("tracks", k), tracks[k], least);
}

bool stands_still(const MeasuredTrack& track, double max_speed, double max_range) {
  if (!(max_speed >= 0.0)) refuse("max_speed", max_speed, "a number of at least 0");
  if (!(max_range >= 0.0)) refuse("max_range", max_range, "a number of at least 0");
  check("track", track, 2);
  const double sum = std::accumulate(track.lengths.begin(), track.lengths.end(), 0.0);
  const double length = track.lengths.empty() ? 1.0 : sum / static_cast<double>(track.lengths.size());
  const auto range = [&](double Point::*axis) {
    const auto less = [axis](const Point& a, const Point& b) { return a.*axis < b.*axis; };
    const auto [low, high] = std::minmax_element(track.positions.begin(), track.positions.end(), less);
    return (*high).*axis - (*low).*axis;
  };
  if (range(&Point::x) > max_range * length || range(&Point::y) > max_range * length) return false;
  const Point slope = StraightLine(track).slope;
  return std::hypot(slope.x, slope.y) <= max_speed * length;
}

}  // namespace survtrack
