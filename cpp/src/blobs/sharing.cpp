// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "blobs/sharing.hpp"

#include <algorithm>
#include <cmath>

namespace survtrack {
namespace {

constexpr double larger_than_one = 1.6;  // sides of the track's box: more than it alone
constexpr double reach = 1.6;            // half sides around the track's centre; farther pixels are not its own
constexpr double min_share = 0.1;        // of the track's box area
constexpr double min_rest = 0.25;        // of the smallest box area, for what is far from all tracks

using Tracks = std::vector<const PredictedTrack*>;

Tracks covered_tracks(const BlobPart& part, const BlobOptions& options, const Expectation& expectation) {
  Tracks covered;
  const Box box = part.box();
  for (const PredictedTrack& track : expectation.tracks) {
    if (!track.confirmed || track.lost_s > options.share_lost_s) continue;
    if (intersection_px(track.box, box) > options.share_cover * track.box.area_px()) covered.push_back(&track);
  }
  return covered;
}

bool must_be_shared(const BlobPart& part, const Tracks& tracks) {
  if (tracks.size() != 1) return tracks.size() > 1;
  const Box& box = tracks.front()->box;
  return part.right - part.left > larger_than_one * box.width || part.bottom - part.top > larger_than_one * box.height;
}

/// The track nearest to a pixel's centre in half sides of its box, or tracks.size() beyond all reaches.
std::size_t owner(const Tracks& tracks, int x, int y) {
  double least = reach;
  std::size_t nearest = tracks.size();
  for (std::size_t i = 0; i < tracks.size(); ++i) {
    const Box& box = tracks[i]->box;
    const Point center = box.center();
    const double distance = std::max(std::abs(x + 0.5 - center.x) / (0.5 * box.width),
                                     std::abs(y + 0.5 - center.y) / (0.5 * box.height));
    // Of two equally near ones the first keeps it.
    if (distance < least || (distance == least && nearest == tracks.size())) {
      least = distance;
      nearest = i;
    }
  }
  return nearest;
}

/// Cuts one run where its pixels' owners change.
void cut_run(const Run& run, const Tracks& tracks, std::size_t first_part, std::vector<Run>& runs,
             std::vector<BlobPart>& parts) {
  int begin = run.x_begin;
  std::size_t current = owner(tracks, begin, run.y);
  for (int x = run.x_begin + 1; x <= run.x_end; ++x) {
    const std::size_t next = x < run.x_end ? owner(tracks, x, run.y) : tracks.size() + 1;
    if (next == current) continue;
    const Run piece{run.y, begin, x, static_cast<int>(first_part + current)};
    parts[first_part + current].add(piece);
    runs.push_back(piece);
    begin = x;
    current = next;
  }
}

void settle_shares(const Tracks& tracks, std::size_t first_part, double min_area_px, std::vector<BlobPart>& parts) {
  double smallest_px = tracks.front()->box.area_px();
  for (std::size_t i = 0; i < tracks.size(); ++i) {
    BlobPart& share = parts[first_part + i];
    const double area_px = tracks[i]->box.area_px();
    smallest_px = std::min(smallest_px, area_px);
    share.expected = share.shared = true;
    share.dropped = static_cast<double>(share.area_px) < std::max({min_area_px, min_share * area_px, 1.0});
  }
  BlobPart& rest = parts[first_part + tracks.size()];
  rest.dropped = static_cast<double>(rest.area_px) < std::max({min_area_px, min_rest * smallest_px, 1.0});
}

}  // namespace

void share_blobs(const BlobOptions& options, const Expectation& expectation, double min_area_px, std::vector<Run>& runs,
                 std::vector<BlobPart>& parts) {
  std::vector<std::vector<Run>> runs_of(parts.size());
  std::vector<Tracks> tracks_of(parts.size());
  bool any = false;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (parts[i].dropped) continue;
    Tracks tracks = covered_tracks(parts[i], options, expectation);
    parts[i].expected = !tracks.empty();
    if (!must_be_shared(parts[i], tracks)) continue;
    tracks_of[i] = std::move(tracks);
    any = true;
  }
  if (!any) return;
  std::vector<Run> kept;
  for (const Run& run : runs) {
    const auto label = static_cast<std::size_t>(run.label);
    (tracks_of[label].empty() ? kept : runs_of[label]).push_back(run);
  }
  for (std::size_t i = 0; i < tracks_of.size(); ++i) {
    if (tracks_of[i].empty()) continue;
    const std::size_t first_part = parts.size();
    parts[i].dropped = true;
    parts.resize(first_part + tracks_of[i].size() + 1);
    for (const Run& run : runs_of[i]) cut_run(run, tracks_of[i], first_part, kept, parts);
    settle_shares(tracks_of[i], first_part, min_area_px, parts);
  }
  runs = std::move(kept);
}

}  // namespace survtrack
