// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "survtrack/tracking/convergence.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>

namespace survtrack {
namespace {

/// The most probable entry of a row: "lost" unless a blob is more probable; the first of equal blobs.
int most_probable(const CostMatrix& beliefs, int row) {
  int best = beliefs.columns() - 1;
  for (int c = 0; c + 1 < beliefs.columns(); ++c) {
    if (beliefs(row, c) > beliefs(row, best)) best = c;
  }
  return best;
}

}  // namespace

void ConvergenceWatch::update(const TrackTable& table, const CostMatrix& beliefs, const Matches& matches) {
  find_claims(table, beliefs);
  forget_parted(table, matches);
  met_.clear();
  for (const auto& [blob, claim] : claims_) {
    const std::vector<std::int64_t>& ids = claim.track_ids;
    bool news = false;
    for (std::size_t i = 0; i < ids.size(); ++i) {
      for (std::size_t j = i + 1; j < ids.size(); ++j) news = pairs_.emplace(ids[i], ids[j]).second || news;
    }
    if (news) met_.push_back(claim);
  }
}

void ConvergenceWatch::find_claims(const TrackTable& table, const CostMatrix& beliefs) {
  claims_.clear();
  for (int r = 0; r < beliefs.rows(); ++r) {
    const int blob = most_probable(beliefs, r);
    if (blob == beliefs.columns() - 1 || !table.row(r).believed()) continue;
    Convergence& claim = claims_[blob];
    claim.detection = blob;
    claim.track_ids.push_back(table.row(r).track.id);
  }
  for (auto& [blob, claim] : claims_) std::sort(claim.track_ids.begin(), claim.track_ids.end());
}

/// Those each of whom has a blob of its own, and who do not believe to be the same now; a closed track left them all.
void ConvergenceWatch::forget_parted(const TrackTable& table, const Matches& matches) {
  if (pairs_.empty()) return;
  struct Stand {
    bool has_blob = false;
    int believes = -1;
  };
  std::map<std::int64_t, Stand> open;
  for (std::size_t r = 0; r < matches.detection_of_track.size(); ++r) {
    open[table.row(static_cast<int>(r)).track.id].has_blob = matches.detection_of_track[r] >= 0;
  }
  for (const auto& [blob, claim] : claims_) {
    for (const std::int64_t id : claim.track_ids) open[id].believes = blob;
  }
  for (auto pair = pairs_.begin(); pair != pairs_.end();) {
    const auto a = open.find(pair->first), b = open.find(pair->second);
    const bool parted = a == open.end() || b == open.end() ||
                        (a->second.has_blob && b->second.has_blob && a->second.believes != b->second.believes);
    pair = parted ? pairs_.erase(pair) : std::next(pair);
  }
}

void ConvergenceWatch::clear() {
  pairs_.clear();
  claims_.clear();
  met_.clear();
}

}  // namespace survtrack
