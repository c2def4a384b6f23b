// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "segmentation/flow_solver.hpp"

namespace survtrack::kernels {

/// A field or image without margins; what lies outside repeats the edge.
struct PlainPlane {
  PlainPlane(std::ptrdiff_t columns, std::ptrdiff_t lines)
      : width(columns), height(lines), values(static_cast<std::size_t>(columns * lines)) {}
  float& at(std::ptrdiff_t x, std::ptrdiff_t y) {
    x = std::clamp<std::ptrdiff_t>(x, 0, width - 1);
    y = std::clamp<std::ptrdiff_t>(y, 0, height - 1);
    return values[static_cast<std::size_t>(y * width + x)];
  }
  std::ptrdiff_t width;
  std::ptrdiff_t height;
  std::vector<float> values;
};

/// The method in plain words, one sweep over the whole image after the other: the judge of the fast loops, which
/// must not differ by a bit.
class PlainFlow {
 public:
  PlainFlow(const FlowProblem& problem, PlainPlane about_u, PlainPlane about_v, PlainPlane from_u, PlainPlane from_v)
      : problem_(problem), u(std::move(from_u)), v(std::move(from_v)),
        a_(u), b_(u), c_(u), about_u_(std::move(about_u)), about_v_(std::move(about_v)) {}

  int solve() {
    derive();
    for (int done = 1;; ++done) {
      const float change = sweep();
      if (done == problem_.sweeps || (problem_.tolerance_px > 0 && change < problem_.tolerance_px)) return done;
    }
  }

 private:
  float level(const GreyRows& rows, std::ptrdiff_t x, std::ptrdiff_t y) const {
    x = std::clamp<std::ptrdiff_t>(x, 0, u.width - 1);
    y = std::clamp<std::ptrdiff_t>(y, 0, u.height - 1);
    return rows.bytes != nullptr ? rows.bytes[y * rows.stride + x] : rows.floats[y * rows.stride + x];
  }
  float sum(std::ptrdiff_t x, std::ptrdiff_t y) const {
    return level(problem_.previous, x, y) + level(problem_.current, x, y);
  }
  float difference(std::ptrdiff_t x, std::ptrdiff_t y) const {
    return level(problem_.current, x, y) - level(problem_.previous, x, y);
  }

  void derive() {
    const auto smoothness = static_cast<float>(255.0 * problem_.smoothness);
    for (std::ptrdiff_t y = 0; y < u.height; ++y) {
      for (std::ptrdiff_t x = 0; x < u.width; ++x) {
        float ix, iy, it;
        if (problem_.derivatives == Derivatives::sobel) {
          ix = ((sum(x + 1, y - 1) - sum(x - 1, y - 1)) + (sum(x + 1, y + 1) - sum(x - 1, y + 1)) +
                (sum(x + 1, y) - sum(x - 1, y)) * 2) / 16;
          iy = ((sum(x - 1, y + 1) - sum(x - 1, y - 1)) + (sum(x + 1, y + 1) - sum(x + 1, y - 1)) +
                (sum(x, y + 1) - sum(x, y - 1)) * 2) / 16;
          it = difference(x, y);
        } else {
          ix = ((sum(x + 1, y) - sum(x, y)) + (sum(x + 1, y + 1) - sum(x, y + 1))) / 4;
          iy = ((sum(x, y + 1) - sum(x, y)) + (sum(x + 1, y + 1) - sum(x + 1, y))) / 4;
          it = ((difference(x, y) + difference(x + 1, y)) + (difference(x, y + 1) + difference(x + 1, y + 1))) / 4;
        }
        if (problem_.about != nullptr) it -= ix * about_u_.at(x, y) + iy * about_v_.at(x, y);
        const float scale = 1.0f / std::sqrt(smoothness * smoothness + ix * ix + iy * iy);
        a_.at(x, y) = ix * scale;
        b_.at(x, y) = iy * scale;
        c_.at(x, y) = it * scale;
      }
    }
  }

  static float mean(PlainPlane& f, std::ptrdiff_t x, std::ptrdiff_t y) {
    const auto t = [&](std::ptrdiff_t at) { return f.at(at, y - 1) + f.at(at, y + 1); };
    const auto w = [&](std::ptrdiff_t at) { return t(at) * 0.5f + f.at(at, y); };
    return ((w(x - 1) + w(x + 1)) + t(x)) * (1.0f / 6.0f);
  }

  float sweep() {
    PlainPlane next_u = u;
    PlainPlane next_v = v;
    float change = 0;
    for (std::ptrdiff_t y = 0; y < u.height; ++y) {
      for (std::ptrdiff_t x = 0; x < u.width; ++x) {
        const float mean_u = mean(u, x, y);
        const float mean_v = mean(v, x, y);
        const float error = (a_.at(x, y) * mean_u + b_.at(x, y) * mean_v) + c_.at(x, y);
        next_u.at(x, y) = mean_u - a_.at(x, y) * error;
        next_v.at(x, y) = mean_v - b_.at(x, y) * error;
        change = std::max({change, std::abs(next_u.at(x, y) - u.at(x, y)), std::abs(next_v.at(x, y) - v.at(x, y))});
      }
    }
    std::swap(u, next_u);
    std::swap(v, next_v);
    return change;
  }

  FlowProblem problem_;

 public:
  PlainPlane u;
  PlainPlane v;

 private:
  PlainPlane a_, b_, c_;
  PlainPlane about_u_, about_v_;
};

}  // namespace survtrack::kernels
