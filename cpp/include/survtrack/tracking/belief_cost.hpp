// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <array>
#include <vector>

#include "survtrack/association/belief_matrix.hpp"
#include "survtrack/association/cost_matrix.hpp"
#include "survtrack/association/density.hpp"
#include "survtrack/association/options.hpp"
#include "survtrack/core/detection.hpp"
#include "survtrack/tracking/track_table.hpp"

namespace survtrack {

/// The densities of all differences that are looked at between a track and its blob.
struct BeliefDensities {
  std::array<DensityLearner, 3> color;  ///< in the coordinates of the colour space
  DensityLearner y, x;                  ///< from the predicted position, in parts of the frame's height and width
  DensityLearner size;                  ///< natural logarithm of the ratio of areas

  /// Those that stand in until enough was seen.
  BeliefDensities(ColorSpace space, int learn_after);
};

/// Bayesian correspondence (Narayana 2007, 8): fills the belief matrix, and learns its densities from what is matched.
class BeliefCost {
 public:
  explicit BeliefCost(const BeliefOptions& options);

  /// Throws `InputError` for a frame of unknown size.
  void check(int frame_width, int frame_height) const;

  /// Fills beliefs(), and the costs 1 - belief of the pairs that are more probable than "lost"; the others are gated.
  void fill(const TrackTable& table, const Detections& detections, CostMatrix& costs);

  /// Learns from the tracks matched before that have a velocity to be predicted by, and the blobs that are the most
  /// probable for them while they are so for the blob. Whether "lost" is more probable does not count: what is
  /// learned from accepted pairs alone grows narrower for ever.
  void learn(const TrackTable& table, const Detections& detections);

  /// Tracks by blobs, with a last column for "lost".
  const CostMatrix& beliefs() const { return beliefs_; }
  const BeliefOptions& options() const { return options_; }
  const BeliefDensities& densities() const { return densities_; }
  void restore(const BeliefDensities& densities) { densities_ = densities; }
  void clear() { densities_ = BeliefDensities(options_.color_space, options_.learn_after); }

 private:
  /// The blob whose most probable track is this one, which is most probable for this one too; -1: none.
  int mutually_best(int row) const;
  void look_at(const TrackTable& table, const Detections& detections);
  void observe(const TrackTable& table, int row, const Detections& detections);

  BeliefOptions options_;
  BeliefDensities densities_;
  CostMatrix beliefs_;
  std::vector<ColorCoordinates> colors_;  ///< a blob
  std::vector<Point> positions_;          ///< a blob, if it is not shared
  std::vector<Evidence> evidence_;        ///< a blob, of one track
  std::vector<double> scales_;
};

}  // namespace survtrack
