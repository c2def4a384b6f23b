// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <memory>

#include "survtrack/segmentation/segmenter.hpp"

namespace survtrack {

/// Average background and secondary background (Narayana 2007, 3.1 and 3.1.2). The work per pixel and
/// frame does not depend on the window's length; memory is one grey frame per frame of the window.
std::unique_ptr<Segmenter> make_model(const MovingAverageOptions& options);

}  // namespace survtrack
