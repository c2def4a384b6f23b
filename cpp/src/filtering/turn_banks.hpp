// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <memory>

#include "survtrack/filtering/filter_bank.hpp"

namespace survtrack {

/// The banks of turning objects (coordinated turn).
std::unique_ptr<FilterBank> make_bank(const ExtendedOptions& options);
std::unique_ptr<FilterBank> make_bank(const UnscentedOptions& options);
std::unique_ptr<FilterBank> make_bank(const ParticleOptions& options);

}  // namespace survtrack
