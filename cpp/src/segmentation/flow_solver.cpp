// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "segmentation/flow_solver.hpp"

#include <algorithm>

namespace survtrack::kernels {

int FlowSolver::solve(const FlowProblem& problem, const FlowRows& to) {
  const int passes = (problem.sweeps + blocking_.sweeps_in_pass - 1) / blocking_.sweeps_in_pass;
  const auto smoothness = static_cast<float>(255.0 * problem.smoothness);
  float changes[most_sweeps_in_pass];
  FlowPass pass{.width = problem.width,
                .height = problem.height,
                .previous = problem.previous,
                .current = problem.current,
                .derivatives = problem.derivatives,
                .smoothness2 = smoothness * smoothness,
                .sweeps = 0,
                .normalised = {},
                .derive = true,
                .about = problem.about,
                .from = problem.from,
                .to = to,
                .largest_change = problem.tolerance_px > 0.0 ? changes : nullptr,
                .tile_columns = blocking_.tile_columns};
  const bool keep = passes > 1 && problem.width * problem.height <= blocking_.most_kept_pixels;
  for (int i = 0; keep && i < 3; ++i) {
    normalised_[i].create(problem.width, problem.height);
    pass.normalised[i] = &normalised_[i];
  }
  // One field is overwritten behind the wave, where no tile beside and no repetition needs it once more.
  const bool in_place = blocking_.tile_columns == 0 && problem.width <= most_tile_columns &&
                        problem.sweeps / passes > 1 && pass.largest_change == nullptr;
  int done = 0;
  for (int k = 0; k < passes; ++k) {
    const bool last = k == passes - 1;
    pass.sweeps = (problem.sweeps - done + passes - k - 1) / (passes - k);
    FlowPlanes& next = halfway_[in_place ? 0 : k % 2];
    if (!last) next.create(problem.width, problem.height);
    pass.to = last ? to : rows_of(next);
    run_flow_pass(pass, memory_);
    if (pass.largest_change != nullptr) {
      float* const end = changes + pass.sweeps;
      float* const small = std::find_if(changes, end, [&](float c) { return c < problem.tolerance_px; });
      if (small != end) {
        const int enough = static_cast<int>(small - changes) + 1;
        if (!last || enough < pass.sweeps) {  // once more, as far as the sweep that was enough
          pass.sweeps = enough;
          pass.to = to;
          run_flow_pass(pass, memory_);
        }
        return done + enough;
      }
    }
    done += pass.sweeps;
    pass.derive = !keep;
    pass.from = &next;
  }
  return done;
}

}  // namespace survtrack::kernels
