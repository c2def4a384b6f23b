// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "survtrack/tracking/belief_cost.hpp"

#include <cmath>

#include "survtrack/association/velocity_factor.hpp"
#include "survtrack/core/errors.hpp"

namespace survtrack {
namespace {

constexpr double not_assigned = 0.1;       // eq. 8.8 and 8.9
constexpr double weight_of_peak_1 = 30.0;  // Cf and Pf

struct Spread {
  double range;
  double scale;
};

/// The weights of 30 that bring the thesis's densities to a peak of 1 say how wide they are: 1 / (2 scale) = 1 / 30
/// gives 15 grey levels, and 15 px of 320x240.
std::array<Spread, 3> color_spreads(ColorSpace space) {
  switch (space) {
    case ColorSpace::hsv: return {{{180.0, 30.0}, {255.0, 30.0}, {255.0, 15.0}}};
    case ColorSpace::lab: return {{{100.0, 6.0}, {110.0, 5.0}, {110.0, 5.0}}};
    case ColorSpace::bgr: break;
  }
  return {{{255.0, 15.0}, {255.0, 15.0}, {255.0, 15.0}}};
}
constexpr Spread y_spread{0.5, 15.0 / 240.0};
constexpr Spread x_spread{0.5, 15.0 / 320.0};
constexpr Spread size_spread{3.0, 0.4};

DensityLearner learner(const Spread& spread, int learn_after) {
  return {Density::two_sided_exponential(spread.range, spread.scale), learn_after};
}

double size_difference(const OpenTrack& track, const Detection& blob) {
  return std::log(blob.box.area_px() / track.seen.area_px());
}

}  // namespace

BeliefDensities::BeliefDensities(ColorSpace space, int learn_after)
    : color{learner(color_spreads(space)[0], learn_after), learner(color_spreads(space)[1], learn_after),
            learner(color_spreads(space)[2], learn_after)},
      y(learner(y_spread, learn_after)),
      x(learner(x_spread, learn_after)),
      size(learner(size_spread, learn_after)) {}

BeliefCost::BeliefCost(const BeliefOptions& options)
    : options_(options), densities_(options.color_space, options.learn_after) {}

void BeliefCost::check(int frame_width, int frame_height) const {
  if (frame_width <= 0 || frame_height <= 0) {
    throw InputError("detections.frame_size: is not known, and cost.model belief needs it; expected (width, height) in px");
  }
}

void BeliefCost::look_at(const TrackTable& table, const Detections& detections) {
  colors_.resize(detections.items.size());
  positions_.resize(detections.items.size());
  for (std::size_t i = 0; i < colors_.size(); ++i) {
    colors_[i] = coordinates(detections.items[i].mean_color, options_.color_space);
    positions_[i] = table.measured(detections.items[i]);
  }
}

void BeliefCost::fill(const TrackTable& table, const Detections& detections, CostMatrix& costs) {
  look_at(table, detections);
  const int blobs = costs.columns();
  beliefs_.resize(costs.rows(), blobs + 1);
  evidence_.resize(static_cast<std::size_t>(blobs));
  for (int r = 0; r < costs.rows(); ++r) {
    observe(table, r, detections);
    double* const row = &beliefs_(r, 0);
    if (options_.order == BeliefOrder::free) {
      order_free_beliefs(evidence_, row);
    } else {
      published_beliefs(evidence_, row, scales_);
    }
    for (int c = 0; c < blobs; ++c) costs(r, c) = row[c] > row[blobs] ? 1.0 - row[c] : CostMatrix::gated;
  }
}

/// What each blob says of one track.
void BeliefCost::observe(const TrackTable& table, int row, const Detections& detections) {
  const OpenTrack& track = table.row(row);
  const BeliefDensities& p = densities_;
  const Point predicted = table.predicted_position(row);
  const TrackTable::Motion motion = table.motion(row);
  const ColorCoordinates color = coordinates(track.track.mean_color, options_.color_space);
  const double color_weight = options_.color_weight / weight_of_peak_1;
  const double color_peak = color_weight * color_weight * color_weight / not_assigned;
  const double position_weight = options_.position_weight / weight_of_peak_1;
  const double position_peak = position_weight * position_weight / not_assigned;
  const double size_peak = options_.size_weight / weight_of_peak_1 / not_assigned;
  const double per_height = 1.0 / detections.frame_height;
  const double per_width = 1.0 / detections.frame_width;
  for (std::size_t i = 0; i < evidence_.size(); ++i) {
    const Detection& blob = detections.items[i];
    const Point position = blob.shared ? table.observe(row, blob).position : positions_[i];
    Evidence e;
    if (color_peak > 0.0) {
      const ColorCoordinates d = color_difference(color, colors_[i], options_.color_space);
      e.color = color_peak * p.color[0].density()(d[0]) * p.color[1].density()(d[1]) * p.color[2].density()(d[2]);
    }
    if (position_peak > 0.0) {
      const Point d = position - predicted;
      e.position = position_peak * p.y.density()(per_height * d.y) * p.x.density()(per_width * d.x);
    }
    if (size_peak > 0.0) e.size = size_peak * p.size.density()(size_difference(track, blob));
    if (options_.velocity_break_point > 0.0) {
      const auto difference = motion.difference(position);
      if (difference) e.velocity = falling_velocity_factor(*difference, options_.velocity_break_point);
    }
    evidence_[i] = e;
  }
}

int BeliefCost::mutually_best(int row) const {
  const int blobs = beliefs_.columns() - 1;
  int blob = -1;
  for (int c = 0; c < blobs; ++c) {
    if (blob < 0 || beliefs_(row, c) > beliefs_(row, blob)) blob = c;
  }
  for (int r = 0; blob >= 0 && r < beliefs_.rows(); ++r) {
    if (r != row && beliefs_(r, blob) >= beliefs_(row, blob)) return -1;
  }
  return blob;
}

void BeliefCost::learn(const TrackTable& table, const Detections& detections) {
  if (options_.learn_after == 0) return;
  for (int r = 0; r < table.size(); ++r) {
    const OpenTrack& track = table.row(r);
    const int mate = mutually_best(r);
    if (mate < 0 || !track.believed() || track.track.matched_frames < 2 || track.track.lost_frames > 0) continue;
    const auto blob = static_cast<std::size_t>(mate);
    const ColorCoordinates track_color = coordinates(track.track.mean_color, options_.color_space);
    const ColorCoordinates d = color_difference(track_color, colors_[blob], options_.color_space);
    for (std::size_t i = 0; i < 3; ++i) densities_.color[i].add(d[i]);
    const Point offset = table.observe(r, detections.items[blob]).position - table.predicted_position(r);
    densities_.y.add(offset.y / detections.frame_height);
    densities_.x.add(offset.x / detections.frame_width);
    densities_.size.add(size_difference(track, detections.items[blob]));
  }
}

}  // namespace survtrack
