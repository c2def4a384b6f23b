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
  /// One believed, moving object seen whole, in a frame of `frame_height` px.
  void add(const Box& box, double frame_height);
  const SceneScale& scale() const { return scale_; }
  void clear() { *this = {}; }

 private:
  void solve(double frame_height);

  SceneScale scale_;
  int samples_ = 0;
  // Normal equations of h = a + b s, s = bottom / frame_height - 0.5.
  double sum_1_ = 0.0, sum_s_ = 0.0, sum_ss_ = 0.0, sum_h_ = 0.0, sum_sh_ = 0.0;
  double spread_ = 0.0;  ///< running mean of |ln(h / expected)|
};

}  // namespace survtrack
