// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace survtrack {

/// The library's version, "major.minor.patch".
const char* version();

}  // namespace survtrack
