// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "survtrack/tracking/reentry.hpp"

#include <algorithm>
#include <cmath>

#include "survtrack/core/color_space.hpp"

namespace survtrack {
namespace {

/// Nobody keeps a velocity for longer while nobody looks.
constexpr double longest_extrapolation_s = 2.0;

double squared_length(const Point& p) { return p.x * p.x + p.y * p.y; }

/// Squared distance of `p` from the stretch between `a` and `a + along`.
double squared_distance(const Point& p, const Point& a, const Point& along) {
  const double whole = squared_length(along);
  const Point from = p - a;
  const double part = whole > 0.0 ? std::clamp((from.x * along.x + from.y * along.y) / whole, 0.0, 1.0) : 0.0;
  return squared_length(from - part * along);
}

}  // namespace

void ReentryMemory::remember(const OpenTrack& ended) {
  const Track& track = ended.track;
  const double now = track.end_time_s;
  // Who is over the time now stays so: times only grow.
  ended_.erase(std::remove_if(ended_.begin(), ended_.end(),
                              [&](const Ended& e) { return now - e.time_s > options_.max_away_s; }),
               ended_.end());
  ended_.push_back({track.id, ended.seen_position, ended.seen_velocity_px_per_s, ended.size_px(), track.mean_color, now});
}

double ReentryMemory::weight(const Ended& ended, const OpenTrack& newcomer) const {
  const double away_s = newcomer.track.start_time_s - ended.time_s;
  if (away_s <= 0.0 || away_s > options_.max_away_s) return 0.0;
  // At the border an object is cut off: the larger of the two is nearer to its size.
  const double size = std::max(ended.size_px, newcomer.size_px()) * options_.place_deviation;
  const Point along = std::min(away_s, longest_extrapolation_s) * ended.velocity_px_per_s;
  double deviations = squared_distance(newcomer.start_position, ended.position, along) / (size * size);
  if (options_.color_deviation > 0.0) {
    const double c = color_distance(ended.color, newcomer.track.mean_color) / options_.color_deviation;
    deviations += c * c;
  }
  return std::exp(-0.5 * deviations - away_s / options_.away_time_s);
}

std::vector<ReentryMemory::Identity> ReentryMemory::claim(const std::vector<const OpenTrack*>& newcomers) {
  const std::size_t rows = newcomers.size(), columns = ended_.size();
  std::vector<Identity> identities(rows);
  std::vector<double> weights(rows * columns), of_row(rows, 0.0), of_column(columns, 0.0);
  for (std::size_t r = 0; r < rows; ++r) {
    for (std::size_t c = 0; c < columns; ++c) {
      const double w = weights[r * columns + c] = weight(ended_[c], *newcomers[r]);
      of_row[r] += w;
      of_column[c] += w;
    }
  }
  std::vector<char> taken(columns, 0);
  for (std::size_t turn = 0; turn < std::min(rows, columns); ++turn) {
    Identity surest;
    std::size_t row = 0, column = 0;
    for (std::size_t r = 0; r < rows; ++r) {
      for (std::size_t c = 0; c < columns; ++c) {
        const double w = weights[r * columns + c];
        if (w <= 0.0 || identities[r].id != 0 || taken[c] != 0) continue;
        // Whoever else may be that track, and whoever else that newcomer may be.
        const double confidence = w / (options_.newcomer_weight + of_row[r] + (of_column[c] - w));
        if (confidence < options_.min_confidence || confidence <= surest.confidence) continue;
        surest = {ended_[c].id, confidence};
        row = r;
        column = c;
      }
    }
    if (surest.id == 0) break;
    identities[row] = surest;
    taken[column] = 1;
  }
  std::size_t kept = 0;
  for (std::size_t c = 0; c < columns; ++c) {
    if (taken[c] == 0) ended_[kept++] = ended_[c];
  }
  ended_.resize(kept);
  return identities;
}

}  // namespace survtrack
