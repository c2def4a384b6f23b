// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <string>
#include <vector>

#include "survtrack/tracking/path.hpp"

namespace survtrack {

struct NamedPath {
  std::string name;
  Path path;

  friend bool operator==(const NamedPath& a, const NamedPath& b) { return a.name == b.name && a.path == b.path; }
};

/// The paths of a scene by name, and the file that holds them:
///
///     {"frame_size": [640, 480],
///      "paths": [{"name": "lane", "closed": false, "kind": "line", "max_distance_px": 40,
///                 "points": [[0, 200], [639, 220]]}]}
///
/// frame_size, closed (false), kind (line) and max_distance_px (none) may be left out.
class Paths {
 public:
  int frame_width = 0;  ///< px, of the frames that the paths are drawn on; 0: not known
  int frame_height = 0;

  const std::vector<NamedPath>& items() const { return items_; }

  /// Throws `InputError` for a name that is there, is not 1 to 100 bytes of UTF-8, or has control characters.
  void add(const std::string& name, const Path& path);

  /// Text that from_json() reads back to the same paths.
  std::string to_json() const;

  /// Throws `InputError` that names `source`, the entry and what is expected there; unknown entries are refused.
  static Paths from_json(const std::string& json, const std::string& source);

 private:
  std::vector<NamedPath> items_;
};

}  // namespace survtrack
