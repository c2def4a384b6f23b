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
  if (samples_ > samples_before_outliers) {
    const double error = std::abs(std::log(box.height / scale_.height_px(box.bottom())));
    spread_ += spread_gain * (std::min(error, 1.0) - spread_);
    if (error > outlier) weight = outlier_weight;
  }
  const double s = box.bottom() / frame_height - 0.5;
  const auto add_to = [&](double& sum, double value) { sum = forgetting * sum + weight * value; };
  add_to(sum_1_, 1.0);
  add_to(sum_s_, s);
  add_to(sum_ss_, s * s);
  add_to(sum_h_, box.height);
  add_to(sum_sh_, s * box.height);
  ++samples_;
  solve(frame_height);
}

void ScaleLearner::solve(double frame_height) {
  const double ss = sum_ss_ + ridge * sum_1_;
  const double determinant = sum_1_ * ss - sum_s_ * sum_s_;
  const double a = (ss * sum_h_ - sum_s_ * sum_sh_) / determinant;
  const double b = (sum_1_ * sum_sh_ - sum_s_ * sum_h_) / determinant;
  scale_.height_per_row = b / frame_height;
  scale_.height_at_top_px = a - 0.5 * b;
  scale_.min_height_px = smallest_height * frame_height;
  scale_.known = samples_ > samples_before_use && spread_ < known_spread;
}

}  // namespace survtrack
