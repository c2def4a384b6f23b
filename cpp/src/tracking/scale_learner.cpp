// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "survtrack/tracking/scale_learner.hpp"

#include <algorithm>
#include <cmath>

namespace survtrack {
namespace {

constexpr double forgetting = 0.999;       // a sample: a memory of about a thousand
constexpr int samples_before_outliers = 50;
constexpr int samples_before_use = 100;
constexpr double known_spread = 0.3;
constexpr double outlier = 0.5;            // |ln(h / expected)|
constexpr double outlier_weight = 0.1;
constexpr double spread_gain = 0.01;
constexpr double ridge = 0.002;             // without spread in rows the law is a constant
constexpr double smallest_height = 0.02;   // of the frame's height

}  // namespace

void ScaleLearner::add(const Box& box, double frame_height) {
  double weight = 1.0;
  if (state_.samples > samples_before_outliers) {
    const double error = std::abs(std::log(box.height / scale_.height_px(box.bottom())));
    state_.spread += spread_gain * (std::min(error, 1.0) - state_.spread);
    if (error > outlier) weight = outlier_weight;
  }
  const double s = box.bottom() / frame_height - 0.5;
  const auto add_to = [&](double& sum, double value) { sum = forgetting * sum + weight * value; };
  add_to(state_.sum_1, 1.0);
  add_to(state_.sum_s, s);
  add_to(state_.sum_ss, s * s);
  add_to(state_.sum_h, box.height);
  add_to(state_.sum_sh, s * box.height);
  ++state_.samples;
  state_.frame_height = frame_height;
  solve();
}

void ScaleLearner::restore(const State& state) {
  state_ = state;
  scale_ = {};
  if (state.samples > 0) solve();
}

void ScaleLearner::solve() {
  const double ss = state_.sum_ss + ridge * state_.sum_1;
  const double determinant = state_.sum_1 * ss - state_.sum_s * state_.sum_s;
  const double a = (ss * state_.sum_h - state_.sum_s * state_.sum_sh) / determinant;
  const double b = (state_.sum_1 * state_.sum_sh - state_.sum_s * state_.sum_h) / determinant;
  scale_.height_per_row = b / state_.frame_height;
  scale_.height_at_top_px = a - 0.5 * b;
  scale_.min_height_px = smallest_height * state_.frame_height;
  scale_.known = state_.samples > samples_before_use && state_.spread < known_spread;
}

}  // namespace survtrack
