// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <memory>

#include "survtrack/segmentation/segmenter.hpp"

namespace survtrack {

/// OpenCV's models as they are, but for three things: the first frame's mask is empty, what they call
/// shadow is not foreground, and their random numbers start anew at every reset, so that the same
/// frames give the same masks.
std::unique_ptr<Segmenter> make_model(const Mog2Options& options);
std::unique_ptr<Segmenter> make_model(const KnnOptions& options);

}  // namespace survtrack
