// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "survtrack/tracking/groups.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

#include "survtrack/association/costs.hpp"
#include "survtrack/core/color_space.hpp"

namespace survtrack {
namespace {

constexpr double least_deviation = 0.25;  // object sizes
constexpr double time_slack_s = 1e-6;  // frame times are sums of rounded steps

/// Part of `box` that lies in `other`, 0 to 1.
double covered(const Box& box, const Box& other) { return intersection_px(box, other) / box.area_px(); }

const Detection& item(const Detections& detections, int d) { return detections.items[static_cast<std::size_t>(d)]; }

/// Ids of rows, the oldest first.
std::vector<std::int64_t> ids_of(const TrackTable& table, const std::vector<int>& rows) {
  std::vector<std::int64_t> ids;
  for (const int i : rows) ids.push_back(table.row(i).track.id);
  std::sort(ids.begin(), ids.end());
  return ids;
}

}  // namespace

void GroupWatch::update(TrackTable& table, const Detections& detections, Matches& matches) {
  rows_of_group_.clear();
  for (int i = 0; i < table.size(); ++i) {
    if (table.row(i).track.group != 0) rows_of_group_[table.row(i).track.group].push_back(i);
  }
  divide(table, detections, matches);
  shared_.assign(static_cast<std::size_t>(table.size()), -1);
  rows_of_detection_.clear();
  for (int i = 0; i < table.size(); ++i) {
    const int host = host_of(table, detections, matches, i);
    if (host < 0) continue;
    const int d = matches.detection_of_track[static_cast<std::size_t>(host)];
    std::vector<int>& rows = rows_of_detection_[d];
    if (rows.empty()) rows.push_back(host);
    rows.push_back(i);
  }
  for (const auto& [d, rows] : rows_of_detection_) {
    for (const int i : rows) shared_[static_cast<std::size_t>(i)] = d;
  }
  find_splits(table, matches);
  write_groups(table, detections);
}

void GroupWatch::divide(const TrackTable& table, const Detections& detections, Matches& matches) {
  for (const auto& [group, rows] : rows_of_group_) {
    const auto last = boxes_.find(group);
    if (rows.size() > 1 && last != boxes_.end()) divide_one(table, detections, rows, last->second, matches);
  }
}

/// Gives the detections that members have, or that lie free where the group was, to the members whom they fit best.
void GroupWatch::divide_one(const TrackTable& table, const Detections& detections, const std::vector<int>& rows,
                            const Box& last, Matches& matches) {
  found_.clear();
  for (int d = 0; d < static_cast<int>(detections.items.size()); ++d) {
    const int owner = matches.track_of_detection[static_cast<std::size_t>(d)];
    const bool of_member = owner >= 0 && std::find(rows.begin(), rows.end(), owner) != rows.end();
    const bool free = owner < 0 || !table.row(owner).believed();
    if (of_member || (free && covered(item(detections, d).box, last) > options_.min_cover)) found_.push_back(d);
  }
  if (found_.size() < 2) return;
  costs_.resize(static_cast<int>(rows.size()), static_cast<int>(found_.size()));
  for (int r = 0; r < costs_.rows(); ++r) {
    for (int c = 0; c < costs_.columns(); ++c) {
      costs_(r, c) = cost(table, rows[static_cast<std::size_t>(r)], item(detections, found_[static_cast<std::size_t>(c)]));
    }
  }
  local_rows_.resize(rows.size());
  std::iota(local_rows_.begin(), local_rows_.end(), 0);
  assignment_.assign(rows.size(), -1);
  solver_.assign(costs_, local_rows_, std::numeric_limits<double>::infinity(), assignment_);
  for (const int d : found_) {
    int& owner = matches.track_of_detection[static_cast<std::size_t>(d)];
    if (owner >= 0) matches.detection_of_track[static_cast<std::size_t>(owner)] = -1;
    owner = -1;
  }
  for (std::size_t r = 0; r < rows.size(); ++r) {
    if (assignment_[r] < 0) continue;
    const int d = found_[static_cast<std::size_t>(assignment_[r])];
    matches.detection_of_track[static_cast<std::size_t>(rows[r])] = d;
    matches.track_of_detection[static_cast<std::size_t>(d)] = rows[r];
  }
  for (Match& pair : matches.candidates) {
    pair.assigned = matches.detection_of_track[static_cast<std::size_t>(pair.track)] == pair.detection;
  }
}

double GroupWatch::cost(const TrackTable& table, int row, const Detection& detection) const {
  const Observation seen = table.observe(row, detection);
  Innovation innovation{seen.position - table.predicted_position(row),
                        table.innovation_covariance_px2(row, seen.extra_px2)};
  // Within a group a place is known no better than that, whatever the filter says; some have no covariance at all.
  const double least = least_deviation * table.row(row).size_px();
  innovation.covariance_px2.xx += least * least;
  innovation.covariance_px2.yy += least * least;
  double sum = 0.5 * squared_mahalanobis(innovation);
  if (options_.color_deviation > 0.0) {
    const double c = color_distance(table.row(row).track.mean_color, detection.mean_color) / options_.color_deviation;
    sum += 0.5 * c * c;
  }
  return sum;
}

/// The row with whose detection a row without one is in a group; -1: none.
int GroupWatch::host_of(const TrackTable& table, const Detections& detections, const Matches& matches, int row) const {
  const OpenTrack& lost = table.row(row);
  if (!lost.believed() || matches.detection_of_track[static_cast<std::size_t>(row)] >= 0) return -1;
  const std::int64_t group = lost.track.group;
  const double unseen_s = detections.time_s - lost.seen_time_s;
  // Who was seen in the frame before may join however long that is ago.
  const bool just_seen = group == 0 && lost.track.lost_frames == 0;
  if (!just_seen && unseen_s > (group != 0 ? options_.max_s : options_.join_s) + time_slack_s) return -1;
  const Box predicted = table.predicted_box(row);
  int host = -1;
  double most = 0.0;
  for (int i = 0; i < table.size(); ++i) {
    const int d = matches.detection_of_track[static_cast<std::size_t>(i)];
    if (i == row || d < 0 || !table.row(i).believed()) continue;
    const double cover = covered(predicted, item(detections, d).box);
    // Of a group that shrinks, as when one is hidden by a smaller one, nobody is thrown out for that.
    const bool together = group != 0 && table.row(i).track.group == group;
    if (cover > (together ? 0.0 : options_.min_cover) && cover > most) {
      most = cover;
      host = i;
    }
  }
  return host;
}

/// A group has split when its tracks have two detections or more; who has none of them is lost and no matter.
void GroupWatch::find_splits(const TrackTable& table, const Matches& matches) {
  split_.clear();
  for (const auto& [group, rows] : rows_of_group_) {
    found_.clear();
    local_rows_.clear();
    for (const int i : rows) {
      const int own = matches.detection_of_track[static_cast<std::size_t>(i)];
      const int d = own >= 0 ? own : shared_[static_cast<std::size_t>(i)];
      if (d < 0) continue;
      local_rows_.push_back(i);
      if (std::find(found_.begin(), found_.end(), d) == found_.end()) found_.push_back(d);
    }
    if (found_.size() < 2) continue;
    const auto last = boxes_.find(group);
    split_.push_back({ids_of(table, local_rows_), last != boxes_.end() ? last->second : Box{}});
  }
}

void GroupWatch::write_groups(TrackTable& table, const Detections& detections) {
  merged_.clear();
  next_boxes_.clear();
  for (int i = 0; i < table.size(); ++i) {
    if (shared_[static_cast<std::size_t>(i)] < 0 && table.row(i).track.group != 0) table.set_group(i, 0);
  }
  for (const auto& [d, rows] : rows_of_detection_) {
    const std::vector<std::int64_t> ids = ids_of(table, rows);
    const std::int64_t before = table.row(rows.front()).track.group;
    const bool same = before != 0 && std::all_of(rows.begin(), rows.end(), [&](int i) {
      return table.row(i).track.group == before;
    });
    if (!same) merged_.push_back({ids, item(detections, d).box});
    for (const int i : rows) table.set_group(i, ids.front());
    next_boxes_[ids.front()] = item(detections, d).box;
  }
  boxes_.swap(next_boxes_);
}

void GroupWatch::clear() {
  boxes_.clear();
  merged_.clear();
  split_.clear();
}

}  // namespace survtrack
