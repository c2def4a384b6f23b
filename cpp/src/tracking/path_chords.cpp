// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "tracking/path_chords.hpp"

#include <limits>

#include "core/simd.hpp"

namespace survtrack {
namespace {

constexpr std::size_t lanes = PathChords::lanes;

SURVTRACK_SIMD_INLINE void look_into(const PathChords& chords, std::size_t block, const Point& p, NearestChord& best) {
  const std::size_t first = block * lanes;
  const double *x = &chords.x[first], *y = &chords.y[first], *dx = &chords.dx[first], *dy = &chords.dy[first];
  const double* inverse = &chords.inverse_px2[first];
  double distance[lanes];
  SURVTRACK_SIMD_LOOP for (std::size_t k = 0; k < lanes; ++k) {
    const double wx = p.x - x[k], wy = p.y - y[k];
    double t = (wx * dx[k] + wy * dy[k]) * inverse[k];
    t = t < 0.0 ? 0.0 : t;
    t = t > 1.0 ? 1.0 : t;
    const double rx = wx - t * dx[k], ry = wy - t * dy[k];
    distance[k] = rx * rx + ry * ry;
  }
  for (std::size_t k = 0; k < lanes; ++k) {
    const bool nearer = distance[k] < best.distance_px2;
    if (nearer || (distance[k] == best.distance_px2 && first + k < best.chord)) best = {distance[k], first + k};
  }
}

struct FindNearest {
  SURVTRACK_SIMD_INLINE void operator()(const PathChords& chords, const Point* points, std::size_t count,
                                        NearestChord* found) const {
    const std::size_t blocks = chords.blocks();
    std::size_t likely = 0;  // points come in no order, but often from the same place
    for (std::size_t i = 0; i < count; ++i) {
      NearestChord best{std::numeric_limits<double>::infinity(), 0};
      look_into(chords, likely, points[i], best);
      for (std::size_t block = 0; block < blocks; ++block) {
        if (block != likely && chords.least_px2(block, points[i]) <= best.distance_px2) {
          look_into(chords, block, points[i], best);
        }
      }
      found[i] = best;
      likely = best.chord / lanes;
    }
  }
};

}  // namespace

void PathChords::add(const Point& start, const Point& end) {
  const Point step = end - start;
  x.push_back(start.x);
  y.push_back(start.y);
  dx.push_back(step.x);
  dy.push_back(step.y);
  inverse_px2.push_back(1.0 / (step.x * step.x + step.y * step.y));
  ++count;
}

void PathChords::finish() {
  while (x.size() % lanes != 0) {
    for (auto* numbers : {&x, &y, &dx, &dy, &inverse_px2}) numbers->push_back(numbers->back());
  }
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double x0 = std::min(x[i], x[i] + dx[i]), x1 = std::max(x[i], x[i] + dx[i]);
    const double y0 = std::min(y[i], y[i] + dy[i]), y1 = std::max(y[i], y[i] + dy[i]);
    if (i % lanes == 0) {
      left.push_back(x0), top.push_back(y0), right.push_back(x1), bottom.push_back(y1);
      continue;
    }
    left.back() = std::min(left.back(), x0);
    top.back() = std::min(top.back(), y0);
    right.back() = std::max(right.back(), x1);
    bottom.back() = std::max(bottom.back(), y1);
  }
}

void find_nearest_chords(const PathChords& chords, const Point* points, std::size_t count, NearestChord* found) {
  simd::run<FindNearest>(chords, points, count, found);
}

}  // namespace survtrack
