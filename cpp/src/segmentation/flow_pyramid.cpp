// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "segmentation/flow_pyramid.hpp"

#include <algorithm>
#include <cmath>

namespace survtrack::kernels {
namespace {

std::ptrdiff_t inside(std::ptrdiff_t at, std::ptrdiff_t length) {
  return std::clamp<std::ptrdiff_t>(at, 0, length - 1);
}

void finer(const FlowPlane& coarse, FlowPlane& fine) {
  for (std::ptrdiff_t y = 0; y < fine.height(); ++y) {
    const float* const above = coarse.row(y / 2);
    const float* const below = coarse.row(inside((y + 1) / 2, coarse.height()));
    float* const row = fine.row(y);
    for (std::ptrdiff_t x = 0; x < fine.width(); ++x) {
      const std::ptrdiff_t left = x / 2;
      const std::ptrdiff_t right = inside((x + 1) / 2, coarse.width());
      row[x] = 0.5f * ((above[left] + above[right]) + (below[left] + below[right]));  // of four quarters, doubled
    }
    fine.repeat_edges(y);
  }
}

/// Keys's weights of the four pixels around a place `t` pixels behind the second of them.
struct CubicWeights {
  explicit CubicWeights(float t)
      : of{((-0.5f * t + 1.0f) * t - 0.5f) * t, (1.5f * t - 2.5f) * t * t + 1.0f, ((-1.5f * t + 2.0f) * t + 0.5f) * t,
           (0.5f * t - 0.5f) * t * t} {}
  float of[4];
};

float interpolated(const FlowPlane& image, float x, float y) {
  const float left = std::floor(x);
  const float top = std::floor(y);
  const CubicWeights across(x - left);
  const CubicWeights down(y - top);
  const auto column = static_cast<std::ptrdiff_t>(left);
  const auto line = static_cast<std::ptrdiff_t>(top);
  float sum = 0.0f;
  for (std::ptrdiff_t j = 0; j < 4; ++j) {
    const float* const row = image.row(inside(line + j - 1, image.height()));
    float of_row = 0.0f;
    for (std::ptrdiff_t i = 0; i < 4; ++i) of_row += across.of[i] * row[inside(column + i - 1, image.width())];
    sum += down.of[j] * of_row;
  }
  return sum;
}

}  // namespace

void halve(const FlowPlane& fine, FlowPlane& coarse, float gain) {
  constexpr float weights[5] = {1.0f / 16, 4.0f / 16, 6.0f / 16, 4.0f / 16, 1.0f / 16};
  coarse.create((fine.width() + 1) / 2, (fine.height() + 1) / 2);
  FlowPlane smooth;  // one row
  smooth.create(fine.width(), 1);
  for (std::ptrdiff_t y = 0; y < coarse.height(); ++y) {
    float* const line = smooth.row(0);
    std::fill_n(line, fine.width(), 0.0f);
    for (std::ptrdiff_t j = 0; j < 5; ++j) {
      const float* const row = fine.row(inside(2 * y + j - 2, fine.height()));
      for (std::ptrdiff_t x = 0; x < fine.width(); ++x) line[x] += weights[j] * row[x];
    }
    for (std::ptrdiff_t x = 0; x < coarse.width(); ++x) {
      float sum = 0.0f;
      for (std::ptrdiff_t i = 0; i < 5; ++i) sum += weights[i] * line[inside(2 * x + i - 2, fine.width())];
      coarse.row(y)[x] = gain * sum;
    }
    coarse.repeat_edges(y);
  }
}

void finer_field(const FlowPlanes& coarse, std::ptrdiff_t width, std::ptrdiff_t height, FlowPlanes& fine) {
  fine.create(width, height);
  finer(coarse.u, fine.u);
  finer(coarse.v, fine.v);
}

void warp(const FlowPlane& previous, const FlowPlane& current, const FlowPlanes& field, FlowPlane& warped) {
  warped.create(current.width(), current.height());
  const auto last_column = static_cast<float>(current.width() - 1);
  const auto last_line = static_cast<float>(current.height() - 1);
  for (std::ptrdiff_t y = 0; y < current.height(); ++y) {
    for (std::ptrdiff_t x = 0; x < current.width(); ++x) {
      const float to_x = static_cast<float>(x) + field.u.row(y)[x];
      const float to_y = static_cast<float>(y) + field.v.row(y)[x];
      const bool there = to_x >= 0.0f && to_x <= last_column && to_y >= 0.0f && to_y <= last_line;
      warped.row(y)[x] = there ? interpolated(current, to_x, to_y) : previous.row(y)[x];
    }
  }
}

}  // namespace survtrack::kernels
