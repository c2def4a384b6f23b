// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "tracking/count_median.hpp"

#include <algorithm>

namespace survtrack {

/// The running median; the first count fills the whole window.
int CountMedian::median_with(int count) {
  if (counts_.empty()) counts_.assign(static_cast<std::size_t>(std::max(options_.median_frames, 1)), count);
  counts_[oldest_] = count;
  oldest_ = (oldest_ + 1) % counts_.size();
  sorted_ = counts_;
  const auto middle = sorted_.begin() + static_cast<std::ptrdiff_t>(sorted_.size() / 2);
  std::nth_element(sorted_.begin(), middle, sorted_.end());
  return *middle;
}

void CountMedian::update(TrackTable& table, const Detections& detections, const Matches& matches) {
  // Of contacts that share a blob each counts.
  int seen = 0;
  for (const Detection& detection : detections.items) seen += table.accepts(detection);
  for (int i = 0; i < table.size(); ++i) {
    seen += table.row(i).track.group != 0 && matches.detection_of_track[static_cast<std::size_t>(i)] < 0;
  }
  const int count = std::min(seen, options_.max_contacts);
  // Before anything was seen there is nothing to take the median of.
  if (counts_.empty() && count == 0) return;
  const int expected = median_with(count);
  for (int i = 0; i < table.size(); ++i) {
    const OpenTrack& row = table.row(i);
    const Track& track = row.track;
    const bool back = track.lost_frames == 0 && options_.restart_after_s > 0.0 && row.step_s > options_.restart_after_s;
    if (back) table.restart(i);
    table.set_status(i, track.lost_frames == 0 ? TrackStatus::confirmed : TrackStatus::lost);
    table.set_reported(i, track.lost_frames == 0 || is_of_use(track, detections));
  }
  const int open = table.size();
  if (!options_.keep_contacts) close_missing(table, open - expected);
  int left = 0;
  for (int i = 0; i < open; ++i) left += table.row(i).track.status != TrackStatus::closed;
  start_newcomers(table, detections, matches, expected - left);
}

/// Whether the prediction of a missing contact still says where it may be. One that is kept is predicted for ever: out
/// of the frame, and with its last acceleration.
bool CountMedian::is_of_use(const Track& track, const Detections& now) const {
  const bool restarts = options_.restart_after_s > 0.0 && now.time_s - track.end_time_s > options_.restart_after_s;
  return !restarts && !outside_frame(track.box, now);
}

/// Of the missing those go that are missing for longest; of equal ones the youngest.
void CountMedian::close_missing(TrackTable& table, int surplus) {
  chosen_.clear();
  for (int i = 0; i < table.size(); ++i) {
    if (table.row(i).track.lost_frames > 0) chosen_.push_back(i);
  }
  std::sort(chosen_.begin(), chosen_.end(), [&](int a, int b) {
    const int lost_a = table.row(a).track.lost_frames;
    const int lost_b = table.row(b).track.lost_frames;
    return lost_a != lost_b ? lost_a > lost_b : a > b;
  });
  for (int k = 0; k < std::min(surplus, static_cast<int>(chosen_.size())); ++k) {
    table.set_status(chosen_[static_cast<std::size_t>(k)], TrackStatus::closed);
    table.set_reported(chosen_[static_cast<std::size_t>(k)], false);
  }
}

/// The largest detections that no track has.
void CountMedian::start_newcomers(TrackTable& table, const Detections& detections, const Matches& matches, int places) {
  chosen_.clear();
  for (std::size_t d = 0; d < detections.items.size(); ++d) {
    if (matches.track_of_detection[d] < 0 && table.accepts(detections.items[d])) chosen_.push_back(static_cast<int>(d));
  }
  const auto area = [&](int d) { return detections.items[static_cast<std::size_t>(d)].area_px; };
  std::stable_sort(chosen_.begin(), chosen_.end(), [&](int a, int b) { return area(a) > area(b); });
  if (static_cast<int>(chosen_.size()) > places) chosen_.resize(static_cast<std::size_t>(std::max(places, 0)));
  // Ids go from top to bottom, the order that the blobs have in the thesis.
  std::sort(chosen_.begin(), chosen_.end(), [&](int a, int b) {
    const Point& p = detections.items[static_cast<std::size_t>(a)].position;
    const Point& q = detections.items[static_cast<std::size_t>(b)].position;
    return p.y != q.y ? p.y < q.y : a < b;
  });
  for (const int d : chosen_) {
    const int i = table.start(d, detections);
    table.believe(i);
    table.set_reported(i, true);
  }
}

void CountMedian::clear() {
  counts_.clear();
  oldest_ = 0;
}

}  // namespace survtrack
