// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "survtrack/blobs/sharing.hpp"

#include <algorithm>
#include <cmath>

namespace survtrack {
namespace {

constexpr double larger_than_one = 1.6;  // sides of the track's box: more than it alone
constexpr double reach = 1.6;            // half sides around the track's centre; farther pixels are not its own
constexpr double min_share = 0.1;        // of the track's box area
constexpr double min_rest = 0.25;        // of the smallest box area, for what is far from all tracks

}  // namespace

void BlobSharer::share(const BlobOptions& options, const Expectation& expectation, double min_area_px,
                       std::vector<Run>& runs, std::vector<BlobPart>& parts) {
  find_divisions(options, expectation, parts);
  if (divisions_.empty()) return;
  cut_runs_.clear();
  for (const Run& run : runs) {
    const int division = division_of_part_[static_cast<std::size_t>(run.label)];
    if (division < 0) {
      cut_runs_.push_back(run);
    } else {
      cut_run(run, divisions_[static_cast<std::size_t>(division)], parts);
    }
  }
  runs.swap(cut_runs_);
  for (const Division& division : divisions_) settle(division, min_area_px, parts);
}

void BlobSharer::find_divisions(const BlobOptions& options, const Expectation& expectation,
                                std::vector<BlobPart>& parts) {
  tracks_.clear();
  divisions_.clear();
  division_of_part_.assign(parts.size(), -1);
  for (std::size_t i = 0; i < division_of_part_.size(); ++i) {
    if (parts[i].dropped) continue;
    const Box box = parts[i].box();
    const std::size_t first_track = tracks_.size();
    for (const PredictedTrack& track : expectation.tracks) {
      if (!track.confirmed || track.lost_s > options.share_lost_s) continue;
      if (intersection_px(track.box, box) > options.share_cover * track.box.area_px()) tracks_.push_back(&track);
    }
    parts[i].expected = tracks_.size() > first_track;
    if (!must_be_shared(parts[i], first_track)) {
      tracks_.resize(first_track);
      continue;
    }
    const std::size_t count = tracks_.size() - first_track;
    division_of_part_[i] = static_cast<int>(divisions_.size());
    divisions_.push_back({i, first_track, count, parts.size()});
    parts[i].dropped = true;
    parts.resize(parts.size() + count + 1);
  }
}

bool BlobSharer::must_be_shared(const BlobPart& part, std::size_t first_track) const {
  const std::size_t count = tracks_.size() - first_track;
  if (count != 1) return count > 1;
  const Box& box = tracks_[first_track]->box;
  return part.right - part.left > larger_than_one * box.width || part.bottom - part.top > larger_than_one * box.height;
}

/// The track nearest to a pixel's centre in half sides of its box, of equally near ones the first; beyond all
/// reaches division.count.
std::size_t BlobSharer::owner(const Division& division, int x, int y) const {
  double least = reach;
  std::size_t nearest = division.count;
  for (std::size_t i = 0; i < division.count; ++i) {
    const Box& box = tracks_[division.first_track + i]->box;
    const Point center = box.center();
    const double distance = std::max(std::abs(x + 0.5 - center.x) / (0.5 * box.width),
                                     std::abs(y + 0.5 - center.y) / (0.5 * box.height));
    if (distance < least || (distance == least && nearest == division.count)) {
      least = distance;
      nearest = i;
    }
  }
  return nearest;
}

/// Cuts one run where its pixels' owners change.
void BlobSharer::cut_run(const Run& run, const Division& division, std::vector<BlobPart>& parts) {
  for (int begin = run.x_begin; begin < run.x_end;) {
    const std::size_t current = owner(division, begin, run.y);
    int end = begin + 1;
    while (end < run.x_end && owner(division, end, run.y) == current) ++end;
    const std::size_t part = division.first_new_part + current;
    const Run piece{run.y, begin, end, static_cast<int>(part)};
    parts[part].add(piece);
    cut_runs_.push_back(piece);
    begin = end;
  }
}

void BlobSharer::settle(const Division& division, double min_area_px, std::vector<BlobPart>& parts) const {
  double smallest_px = tracks_[division.first_track]->box.area_px();
  for (std::size_t i = 0; i < division.count; ++i) {
    BlobPart& share = parts[division.first_new_part + i];
    const double area_px = tracks_[division.first_track + i]->box.area_px();
    smallest_px = std::min(smallest_px, area_px);
    share.expected = share.shared = true;
    share.dropped = static_cast<double>(share.area_px) < std::max({min_area_px, min_share * area_px, 1.0});
  }
  BlobPart& rest = parts[division.first_new_part + division.count];
  rest.dropped = static_cast<double>(rest.area_px) < std::max({min_area_px, min_rest * smallest_px, 1.0});
}

}  // namespace survtrack
