// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <memory>

#include "survtrack/segmentation/segmenter.hpp"

namespace survtrack {

/// A background that is taken once: for each pixel and channel the lowest and the highest level that count as
/// background, 9 bytes a pixel of a colour frame, 3 of a grey one; with the median also the first frames, until they
/// are complete. Places of `Expectation::keep` make no difference. After a change of the scene the background is taken
/// from the coming frames, in place of a picture by their median, until `reset`.
std::unique_ptr<Segmenter> make_model(const StaticReferenceOptions& options);

}  // namespace survtrack
