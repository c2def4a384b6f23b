// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <vector>

namespace survtrack {

struct EmbeddedPreset {
  const char* name;
  const char* text;
};

/// The files of presets/, compiled in; sorted by name.
const std::vector<EmbeddedPreset>& embedded_presets();

}  // namespace survtrack
