// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "survtrack/tracking/matcher.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "survtrack/association/assign.hpp"
#include "survtrack/association/costs.hpp"
#include "survtrack/association/velocity_factor.hpp"

namespace survtrack {
namespace {

struct FillCosts {
  const TrackTable& table;
  const Detections& detections;
  std::optional<BeliefCost>& belief;
  CostMatrix& costs;

  void operator()(const GaussianCostOptions& o) const {
    for (int r = 0; r < costs.rows(); ++r) {
      const OpenTrack& row = table.row(r);
      const Symmetric2 S = table.innovation_covariance_px2(r);
      for (int c = 0; c < costs.columns(); ++c) {
        const Observation seen = table.observe(r, detections.items[static_cast<std::size_t>(c)]);
        const Symmetric2& extra = seen.extra_px2;
        const Innovation innovation{table.innovation(r, seen.position), {S.xx + extra.xx, S.xy + extra.xy, S.yy + extra.yy}};
        costs(r, c) = gaussian_cost(o, innovation, row.width_px * row.height_px);
      }
    }
  }

  void operator()(const MatchMatrixOptions& o) const {
    // A tracker on boxes alone may not know the frame: distances then count in px.
    const double width = detections.frame_width > 0 ? detections.frame_width : 1.0;
    const double height = detections.frame_height > 0 ? detections.frame_height : 1.0;
    for (int r = 0; r < costs.rows(); ++r) {
      const TrackTable::Motion motion = table.motion(r);
      for (int c = 0; c < costs.columns(); ++c) {
        const Detection& detection = detections.items[static_cast<std::size_t>(c)];
        const double cost =
            match_matrix_entry(table.row(r).track, detection, width, height) * factor(o, motion, table.measured(detection));
        costs(r, c) = o.max_match > 0.0 && cost > o.max_match ? CostMatrix::gated : cost;
      }
    }
  }

  void operator()(const DistanceOptions& o) const {
    for (int r = 0; r < costs.rows(); ++r) {
      const Point predicted = table.predicted_position(r);
      for (int c = 0; c < costs.columns(); ++c) {
        const Point seen = table.observe(r, detections.items[static_cast<std::size_t>(c)]).position;
        const double distance = std::hypot(seen.x - predicted.x, seen.y - predicted.y);
        costs(r, c) = o.max_distance_px > 0.0 && distance > o.max_distance_px ? CostMatrix::gated : distance;
      }
    }
  }

  void operator()(const BeliefOptions&) const { belief->fill(table, detections, costs); }

  static double factor(const MatchMatrixOptions& o, const TrackTable::Motion& motion, const Point& position) {
    if (o.velocity_break_point <= 0.0) return 1.0;
    const std::optional<double> difference = motion.difference(position);
    return difference ? velocity_factor(*difference, o.velocity_break_point) : 1.0;
  }
};

}  // namespace

Matcher::Matcher(const CostOptions& cost, const AssignmentOptions& assignment, const AppearanceOptions& appearance)
    : cost_(cost), assignment_(assignment), appearance_(appearance) {
  if (const auto* belief = std::get_if<BeliefOptions>(&cost)) belief_.emplace(*belief);
}

void Matcher::match(const TrackTable& table, const Detections& detections, Matches& matches) {
  const int rows = table.size();
  const auto columns = static_cast<int>(detections.items.size());
  costs_.resize(rows, columns);
  std::visit(FillCosts{table, detections, belief_, costs_}, cost_);
  refuse_foreign(table, detections);
  add_appearance(table, detections);
  assign_rows(table, detections, matches.detection_of_track);
  matches.track_of_detection.assign(static_cast<std::size_t>(columns), -1);
  matches.candidates.clear();
  for (int r = 0; r < rows; ++r) {
    const int chosen = matches.detection_of_track[static_cast<std::size_t>(r)];
    if (chosen >= 0) matches.track_of_detection[static_cast<std::size_t>(chosen)] = r;
    for (int c = 0; c < columns; ++c) {
      if (std::isinf(costs_(r, c))) continue;
      matches.candidates.push_back({r, c, table.row(r).track.id, costs_(r, c), c == chosen});
    }
  }
  if (belief_) belief_->learn(table, detections);
}

void Matcher::add_appearance(const TrackTable& table, const Detections& detections) {
  const auto* colors = std::get_if<ColorHistogramOptions>(&appearance_);
  if (colors == nullptr) return;
  for (int r = 0; r < costs_.rows(); ++r) {
    for (int c = 0; c < costs_.columns(); ++c) {
      if (std::isinf(costs_(r, c))) continue;
      const double common = histogram_intersection(table.histogram(r), detections.histograms[static_cast<std::size_t>(c)]);
      costs_(r, c) = common < colors->min_intersection ? CostMatrix::gated : costs_(r, c) + colors->weight * (1.0 - common);
    }
  }
}

/// What the filters cannot take for an object is nobody's.
void Matcher::refuse_foreign(const TrackTable& table, const Detections& detections) {
  for (int c = 0; c < costs_.columns(); ++c) {
    if (table.accepts(detections.items[static_cast<std::size_t>(c)])) continue;
    for (int r = 0; r < costs_.rows(); ++r) costs_(r, c) = CostMatrix::gated;
  }
}

/// Of equally large ones the first.
void Matcher::assign_largest(const Detections& detections, Assignment& assignment) {
  assignment.assign(static_cast<std::size_t>(costs_.rows()), -1);
  rows_.assign(detections.items.size(), 0);  // whether a detection is taken
  for (int r = 0; r < costs_.rows(); ++r) {
    int best = -1;
    double largest = 0.0;
    for (int c = 0; c < costs_.columns(); ++c) {
      const auto at = static_cast<std::size_t>(c);
      const double area = detections.items[at].area_px;
      if (rows_[at] != 0 || std::isinf(costs_(r, c)) || (best >= 0 && !(area > largest))) continue;
      best = c;
      largest = area;
    }
    if (best < 0) continue;
    rows_[static_cast<std::size_t>(best)] = 1;
    assignment[static_cast<std::size_t>(r)] = best;
  }
}

/// Topmost detections first, of equally high ones the leftmost; pairs that the gate refuses stay apart.
void Matcher::assign_in_row_order(const Detections& detections, Assignment& assignment) {
  rows_.resize(detections.items.size());
  std::iota(rows_.begin(), rows_.end(), 0);
  std::sort(rows_.begin(), rows_.end(), [&](int a, int b) {
    const Point& p = detections.items[static_cast<std::size_t>(a)].position;
    const Point& q = detections.items[static_cast<std::size_t>(b)].position;
    if (p.y != q.y) return p.y < q.y;
    return p.x != q.x ? p.x < q.x : a < b;
  });
  assignment.assign(rows_.begin(), rows_.end());
  for (std::size_t r = 0; r < assignment.size(); ++r) {
    if (std::isinf(costs_(static_cast<int>(r), assignment[r]))) assignment[r] = -1;
  }
}

void Matcher::assign_rows(const TrackTable& table, const Detections& detections, Assignment& assignment) {
  if (std::holds_alternative<OldestFirstOptions>(assignment_)) {
    assignment = assign_oldest_first(costs_);
    return;
  }
  if (std::holds_alternative<LargestOptions>(assignment_)) {
    assign_largest(detections, assignment);
    return;
  }
  if (std::holds_alternative<RowOrderOptions>(assignment_) && costs_.rows() == costs_.columns()) {
    assign_in_row_order(detections, assignment);
    return;
  }
  const auto* hungarian = std::get_if<HungarianOptions>(&assignment_);
  assignment.assign(static_cast<std::size_t>(table.size()), -1);
  const auto assign_those = [&](const auto& chosen) {
    rows_.clear();
    for (int r = 0; r < table.size(); ++r) {
      if (chosen(table.row(r))) rows_.push_back(r);
    }
    solver_.assign(costs_, rows_, CostMatrix::gated, assignment);
  };
  if (hungarian != nullptr && hungarian->confirmed_first) {
    assign_those([](const OpenTrack& row) { return row.believed(); });
    assign_those([](const OpenTrack& row) { return !row.believed(); });
  } else {
    assign_those([](const OpenTrack&) { return true; });
  }
}

}  // namespace survtrack
