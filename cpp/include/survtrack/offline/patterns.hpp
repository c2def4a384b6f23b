// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "survtrack/offline/history.hpp"
#include "survtrack/offline/pattern_options.hpp"

namespace survtrack {

/// A way that many tracks go, and how (Narayana 2007, 11.5). Deviations are standard deviations over its tracks.
struct Pattern {
  int id = 0;                     ///< from 1; the most frequent pattern first
  std::int64_t count = 0;         ///< tracks that it was learned from
  std::vector<Point> way;         ///< px, mean of their ways; at least two points
  std::vector<double> spread_px;  ///< at each point of the way: root mean square distance across it
  std::vector<double> time_s;     ///< at each point of the way: mean time since the first; never falls
  double size_px = 0.0;           ///< mean of the objects' sizes (root of the box area)
  double speed_px_per_s = 0.0;    ///< mean of the tracks' mean speeds, standing still counted
  double speed_deviation_px_per_s = 0.0;
  double duration_s = 0.0;        ///< mean
  double duration_deviation_s = 0.0;

  const Point& enters() const { return way.front(); }
  const Point& leaves() const { return way.back(); }
};

/// What a track does, seen by the patterns.
enum class ActivityKind {
  usual,      ///< follows a pattern at about its speed
  standing,   ///< has not gone `min_travel` away from its first place
  other_way,  ///< follows none of the patterns: elsewhere, in another direction, turning back
  too_fast,   ///< follows a pattern
  too_slow,   ///< follows a pattern; a halt on the way counts
};

/// What one track does, and the numbers that decided it.
struct Activity {
  std::int64_t track_id = 0;
  ActivityKind kind = ActivityKind::standing;
  std::optional<int> pattern;      ///< id of the pattern it follows, if any
  bool partial = false;            ///< it follows a stretch of the pattern's way, not the whole
  std::optional<double> distance;  ///< mean from the pattern's way, in object sizes; of the nearest when it follows none
  std::optional<double> angle_deg; ///< between the directions, 0 to 180
  double speed_px_per_s = 0.0;     ///< length of its way by its duration
  std::optional<double> speed_ratio;  ///< in parts of the pattern's, of a stretch in parts of its speed there

  bool unusual() const { return kind != ActivityKind::usual && kind != ActivityKind::standing; }
};

/// The patterns of activity in a scene. They judge tracks of other runs of the same camera.
class Patterns {
 public:
  PatternOptions options;         ///< in force for classify()
  int frame_width = 0;            ///< px, of the frames that the tracks come from; 0: not known
  int frame_height = 0;
  std::vector<Pattern> patterns;  ///< by id

  /// What each track does, by its id. A track that follows no whole way may follow a stretch of one: it may begin late,
  /// end early, or be still underway. Of several patterns within the limits the nearest is taken. Throws `InputError` as
  /// check_history() does, `ConfigError` for options out of their bounds.
  std::vector<Activity> classify(const History& history) const;
  Activity classify(const RecordedTrack& track) const;

  /// Text that from_json() reads back to the same patterns.
  std::string to_json() const;

  /// Throws `InputError` that names `source`, the entry and what is expected there.
  static Patterns from_json(const std::string& json, const std::string& source);
};

/// Groups tracks by the ways they go. A track is described by points evenly spaced along its way; two go the same way
/// when mean distance and angle are within the limits. The track with most like it leads the first group, of the rest
/// again the one with most, and so on; then each track goes to the group whose mean way is nearest, until none
/// changes. Takes time with the square of the number of tracks; their order does not matter. Throws `InputError` as
/// check_history() does, `ConfigError` for options out of their bounds.
Patterns learn_patterns(const History& history, const PatternOptions& options = {});

}  // namespace survtrack
