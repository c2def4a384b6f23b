// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <vector>

#include "survtrack/segmentation/tiled_morphology.hpp"

namespace survtrack::kernels {

/// A structuring element as a union of rectangles, each on the offsets -left to width - 1 - left and -up to
/// height - 1 - up from the origin.
struct MaskElement {
  struct Rectangle {
    std::size_t left;
    std::size_t up;
    std::size_t width;
    std::size_t height;
  };
  std::size_t edge = 1;
  std::vector<Rectangle> rectangles;
};

/// An edge of 0 counts as 1: the origin alone.
MaskElement mask_element(MorphologyShape shape, int edge);

}  // namespace survtrack::kernels
