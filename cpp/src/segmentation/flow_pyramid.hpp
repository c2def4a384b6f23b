// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "segmentation/flow_plane.hpp"

/// Coarser and finer images and fields, and images moved by a field. Plain arithmetic in a fixed order.
namespace survtrack::kernels {

/// Half the size, rounded up: smoothed by (1 4 6 4 1) / 16 both ways (Burt and Adelson 1983), every second pixel
/// kept, the values times `gain`. The image's edges are repeated.
void halve(const FlowPlane& fine, FlowPlane& coarse, float gain = 1.0f);

/// A field for an image of the given size from that of half the size: interpolated between neighbours, twice as
/// long.
void finer_field(const FlowPlanes& coarse, std::ptrdiff_t width, std::ptrdiff_t height, FlowPlanes& fine);

/// `current` at the places to which the field moves the pixels: cubic interpolation (Keys 1981, a = -1/2). A
/// place outside the image takes the pixel of `previous`: there nothing is known, and nothing changes.
void warp(const FlowPlane& previous, const FlowPlane& current, const FlowPlanes& field, FlowPlane& warped);

}  // namespace survtrack::kernels
