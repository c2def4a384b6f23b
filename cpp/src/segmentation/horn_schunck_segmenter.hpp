// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <memory>

#include "survtrack/segmentation/segmenter.hpp"

namespace survtrack {

/// Foreground is what moved since the N-th frame before, by optical flow (Horn and Schunck 1981). Learns nothing,
/// so that there are no places to keep; the grey levels of N frames are remembered.
std::unique_ptr<Segmenter> make_model(const HornSchunckOptions& options);

}  // namespace survtrack
