// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "segmentation/mask_element.hpp"

#include <algorithm>
#include <cmath>

namespace survtrack::kernels {
namespace {

/// The pixels of a row of an element, as columns from 0 to the edge; end is one beyond.
struct Span {
  int begin;
  int end;
  bool operator==(const Span& other) const { return begin == other.begin && end == other.end; }
};

/// As OpenCV's getStructuringElement draws it: half a row is the rounded half chord of a circle around the origin.
Span row_of(MorphologyShape shape, int edge, int row) {
  const int origin = edge / 2;
  if (shape == MorphologyShape::square || (shape == MorphologyShape::cross && row == origin)) return {0, edge};
  if (shape == MorphologyShape::cross) return {origin, origin + 1};
  const double dy = row - origin;
  const int half = static_cast<int>(std::lrint(std::sqrt(static_cast<double>(origin) * origin - dy * dy)));
  return {std::max(origin - half, 0), std::min(origin + half + 1, edge)};
}

}  // namespace

/// Rows grow towards the origin's, so that the rows at least as wide as one of them are a rectangle.
MaskElement mask_element(MorphologyShape shape, int edge) {
  edge = std::max(edge, 1);
  const int origin = edge / 2;
  MaskElement element{static_cast<std::size_t>(edge), {}};
  for (int first = 0; first <= origin; ++first) {
    const Span span = row_of(shape, edge, first);
    if (first > 0 && span == row_of(shape, edge, first - 1)) continue;
    int last = origin;
    const auto holds = [&](int row) {
      const Span other = row_of(shape, edge, row);
      return other.begin <= span.begin && other.end >= span.end;
    };
    while (last + 1 < edge && holds(last + 1)) ++last;
    element.rectangles.push_back({static_cast<std::size_t>(origin - span.begin), static_cast<std::size_t>(origin - first),
                                  static_cast<std::size_t>(span.end - span.begin),
                                  static_cast<std::size_t>(last - first + 1)});
  }
  return element;
}

}  // namespace survtrack::kernels
