// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <opencv2/core/mat.hpp>

#include "survtrack/segmentation/horn_schunck_options.hpp"

namespace survtrack {

/// Options of `horn_schunck`. With `levels` 1 and `warps` 0 it is the method as published; more levels find
/// movements of more than a pixel or two. The defaults suit several levels.
struct FlowOptions {
  double smoothness = 0.05;
  int sweeps = 100;
  double tolerance = 0.0;
  Derivatives derivatives = Derivatives::hs1981;
  int levels = 1;
  int warps = 0;

  static constexpr auto fields() {
    using O = FlowOptions;
    return std::make_tuple(
        field("smoothness", &O::smoothness, "", "a: weight of a smooth field, for grey levels in 0 to 1",
              smoothness_bounds),
        field("sweeps", &O::sweeps, "", "iterations, at most; after each warp", sweeps_bounds),
        field("tolerance", &O::tolerance, "px", "no more sweeps when one changes nothing by as much; 0: never",
              tolerance_bounds),
        field("derivatives", &O::derivatives, "", "cubes of 2 x 2 x 2 as published, or Sobel's kernels"),
        field("levels", &O::levels, "", "images of a pyramid, each half the size of the one before; 1: the image alone",
              between(1, 30)),
        field("warps", &O::warps, "",
              "times that the later frame is moved by the flow so far, at each level; 0: none at one level, 5 at more",
              between(0, 1000)));
  }
};

/// A flow field: how far each pixel of the earlier frame moves to the right and down, px. CV_32FC1 both.
struct FlowField {
  cv::Mat u;
  cv::Mat v;
};

/// Optical flow from `previous` to `current` (Horn and Schunck, *Determining optical flow*, 1981), on one thread.
/// The frames are HxW (grey) or HxWx3 (BGR, turned to grey) uint8, of one size; `flow` is reused when it has that
/// size. Each sweep gives every pixel, from the means of its neighbourhood,
///
///     u = mean u - Ix (Ix mean u + Iy mean v + It) / (a^2 + Ix^2 + Iy^2), and v likewise,
///
/// with grey levels in 0 to 1 and the image's edges repeated. `initial`: where to start, such as the field of the
/// frame before, in place of zeros; it may be `flow` itself. When frames are moved, they are moved by the whole
/// flow so far, and it is the whole flow that is smooth. Throws `InputError` for frames and fields that do not
/// fit or are not finite, `ConfigError` for options out of their ranges or more levels than the size has.
void horn_schunck(const cv::Mat& previous, const cv::Mat& current, const FlowOptions& options, FlowField& flow,
                  const FlowField& initial = {});

}  // namespace survtrack
