// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <memory>

#include "survtrack/segmentation/segmenter.hpp"

namespace survtrack {

/// Locally normalised difference. Its background picture is the reference that the last frame was compared with, grey.
/// The running average does not learn in the places of `Expectation::keep`; everywhere else it learns foreground too.
std::unique_ptr<Segmenter> make_model(const NormalizedDifferenceOptions& options);

}  // namespace survtrack
