// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>

#include "segmentation/flow_pass.hpp"

namespace survtrack::kernels {

/// Two images and how their flow is sought.
struct FlowProblem {
  std::ptrdiff_t width = 0;
  std::ptrdiff_t height = 0;
  GreyRows previous;
  GreyRows current;
  Derivatives derivatives = Derivatives::hs1981;
  double smoothness = 0.0;  ///< a, of grey levels in 0 to 1
  int sweeps = 0;           ///< at most
  double tolerance_px = 0.0;
  const FlowPlanes* about = nullptr;  ///< `current` was warped by it; nullptr: by nothing
  const FlowPlanes* from = nullptr;   ///< where the sweeps start; nullptr: zeros
};

/// How the work is cut up; the results are the same.
struct FlowBlocking {
  int sweeps_in_pass = most_sweeps_in_pass;
  std::ptrdiff_t tile_columns = 0;  ///< 0: as many as is best
  /// Larger images derive anew in each pass, which takes less time than fetching derivatives from memory.
  std::ptrdiff_t most_kept_pixels = 1 << 18;
};

/// Horn and Schunck's iteration on one pair of images. Keeps the memory that it works in.
class FlowSolver {
 public:
  explicit FlowSolver(const FlowBlocking& blocking = {}) : blocking_(blocking) {}

  /// Sweeps until the largest change of a component is below the tolerance, or as often as allowed; writes the
  /// flow to `to`, which is not `from`. Returns the number of sweeps.
  int solve(const FlowProblem& problem, const FlowRows& to);

 private:
  FlowBlocking blocking_;
  AlignedFloats memory_;
  FlowPlane normalised_[3];
  FlowPlanes halfway_[2];
};

}  // namespace survtrack::kernels
