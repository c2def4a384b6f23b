// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "survtrack/offline/link.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "offline/sparse_assignment.hpp"
#include "offline/track_end.hpp"
#include "survtrack/core/color_space.hpp"

namespace survtrack {
namespace {

constexpr double time_slack_s = 1e-6;  // frame times are sums of rounded steps

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// The two ends of a track.
struct Piece {
  const RecordedTrack* track = nullptr;
  TrackEnd start, end;
};

/// By start, so that what may follow a track stands together; by id where several start at once, so that the order
/// in which the tracks were given does not matter.
std::vector<Piece> pieces_of(const History& history, double end_s) {
  std::vector<Piece> pieces;
  for (const RecordedTrack& track : history.tracks) pieces.push_back({&track, start_of(track, end_s), end_of(track, end_s)});
  std::sort(pieces.begin(), pieces.end(), [](const Piece& a, const Piece& b) {
    return a.start.time_s != b.start.time_s ? a.start.time_s < b.start.time_s : a.track->id < b.track->id;
  });
  return pieces;
}

double part_of(double value, double limit) {
  if (limit > 0.0) return value / limit;
  return value > 0.0 ? std::numeric_limits<double>::infinity() : 0.0;
}

/// What joining costs; nothing when a limit is exceeded. What is no number is refused.
std::optional<Link> join(const Piece& a, const Piece& b, const LinkOptions& options) {
  Link link;
  link.earlier_id = a.track->id;
  link.later_id = b.track->id;
  link.gap_s = b.start.time_s - a.end.time_s;
  if (!(link.gap_s > 0.0 && link.gap_s <= options.max_gap_s + time_slack_s)) return {};
  const double size_px = 0.5 * (a.end.size_px + b.start.size_px);
  const double half_s = 0.5 * link.gap_s;
  const Point apart = (b.start.position - half_s * b.start.velocity_px_per_s) -
                      (a.end.position + half_s * a.end.velocity_px_per_s);
  link.distance = std::hypot(apart.x, apart.y) / size_px;
  const double farthest = options.max_distance + options.max_distance_growth * link.gap_s;
  if (!(link.distance <= farthest)) return {};
  const Point change = b.start.velocity_px_per_s - a.end.velocity_px_per_s;
  link.speed_difference = std::hypot(change.x, change.y) / size_px;
  if (!(link.speed_difference <= options.max_speed_difference)) return {};
  const Color &c = a.end.mean_color, &d = b.start.mean_color;  // Narayana 2007, eq. 3.6
  link.color_difference = color_distance(d, c);
  if (!(link.color_difference <= options.max_color_difference)) return {};
  link.cost = 0.25 * (part_of(link.gap_s, options.max_gap_s) + part_of(link.distance, farthest) +
                      part_of(link.speed_difference, options.max_speed_difference) +
                      part_of(link.color_difference, options.max_color_difference));
  if (!(link.cost < options.max_cost)) return {};
  return link;
}

/// All pairs within the limits: rows are the earlier ones, columns the later ones.
std::vector<std::vector<SparsePair>> pairs_of(const std::vector<Piece>& pieces, const LinkOptions& options) {
  std::vector<std::vector<SparsePair>> rows(pieces.size());
  for (std::size_t a = 0; a < pieces.size(); ++a) {
    const double end_s = pieces[a].end.time_s;
    const auto first = std::upper_bound(pieces.begin(), pieces.end(), end_s,
                                        [](double time_s, const Piece& piece) { return time_s < piece.start.time_s; });
    for (auto b = first; b != pieces.end() && b->start.time_s - end_s <= options.max_gap_s + time_slack_s; ++b) {
      if (const auto link = join(pieces[a], *b, options)) {
        rows[a].push_back({static_cast<int>(b - pieces.begin()), link->cost});
      }
    }
  }
  return rows;
}

/// Each chain as one track, by id.
History chained(const std::vector<Piece>& pieces, const Assignment& next) {
  std::vector<char> follows(pieces.size(), char{0});
  for (const int b : next) {
    if (b >= 0) follows[at(b)] = 1;
  }
  History history;
  for (int first = 0; first < static_cast<int>(pieces.size()); ++first) {
    if (follows[at(first)]) continue;
    RecordedTrack track = *pieces[at(first)].track;
    for (int b = next[at(first)]; b >= 0; b = next[at(b)]) {
      const auto& more = pieces[at(b)].track->points;
      track.points.insert(track.points.end(), more.begin(), more.end());
    }
    history.tracks.push_back(std::move(track));
  }
  std::sort(history.tracks.begin(), history.tracks.end(),
            [](const RecordedTrack& a, const RecordedTrack& b) { return a.id < b.id; });
  return history;
}

DroppedTrack measured(const RecordedTrack& track) {
  return {track.id, static_cast<std::int64_t>(track.points.size()), track.points.back().time_s - track.points.front().time_s,
          travel_of(track) / size_of(track)};
}

bool is_too_short(const DroppedTrack& track, const LinkOptions& options) {
  return track.frames < options.min_frames || track.duration_s < options.min_s - time_slack_s ||
         track.travel < options.min_travel;
}

}  // namespace

Linked link_tracks(const History& history, const LinkOptions& options) {
  check_fields(options);
  check_history(history);
  const std::vector<Piece> pieces = pieces_of(history, options.end_s);
  const Assignment next = assign_sparse(pairs_of(pieces, options), static_cast<int>(pieces.size()), options.max_cost);
  Linked linked;
  for (std::size_t a = 0; a < pieces.size(); ++a) {
    if (next[a] >= 0) linked.links.push_back(*join(pieces[a], pieces[at(next[a])], options));
  }
  for (RecordedTrack& track : chained(pieces, next).tracks) {
    const DroppedTrack facts = measured(track);
    if (is_too_short(facts, options)) {
      linked.dropped.push_back(facts);
    } else {
      linked.history.tracks.push_back(std::move(track));
    }
  }
  return linked;
}

}  // namespace survtrack
