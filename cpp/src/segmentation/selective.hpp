// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <memory>

#include "survtrack/segmentation/segmenter.hpp"

namespace survtrack {

/// Selective running average with a tolerance, a candidate and a shadow test for each pixel; 13 bytes
/// a pixel of a colour frame, 7 of a grey one. `Expectation::time_s` is the time of the frame; in the
/// places of `Expectation::keep` nothing is learned, unless the whole scene changes.
std::unique_ptr<Segmenter> make_model(const SelectiveOptions& options);

}  // namespace survtrack
