// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "survtrack/core/geometry.hpp"
#include "survtrack/core/scene_scale.hpp"

namespace survtrack {

/// Learns how large objects are, where: height linear in the row of the lower edge by weighted recursive
/// least squares with slow forgetting.
class ScaleLearner {
 public:
  /// What it takes to go on: the normal equations of h = a + b s, s = bottom / frame height - 0.5.
  struct State {
    int samples = 0;
    double frame_height = 0.0;
    double sum_1 = 0.0, sum_s = 0.0, sum_ss = 0.0, sum_h = 0.0, sum_sh = 0.0;
    double spread = 0.0;  ///< running mean of |ln(h / expected)|
  };

  /// One believed, moving object seen whole, in a frame of `frame_height` px.
  void add(const Box& box, double frame_height);
  const SceneScale& scale() const { return scale_; }
  const State& state() const { return state_; }
  void restore(const State& state);
  void clear() { *this = {}; }

 private:
  void solve();

  SceneScale scale_;
  State state_;
};

}  // namespace survtrack
