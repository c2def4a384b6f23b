// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <array>
#include <utility>

namespace survtrack {

/// What is asked of the covariances Q, R and P that a filter is given.
enum class Covariances {
  checked,       ///< symmetric, no eigenvalue below 0; what is not is refused
  as_published,  ///< only shapes and finite numbers: to reproduce published listings, not to track with
};
constexpr auto enum_names(Covariances) {
  return std::array{std::pair{"checked", Covariances::checked}, std::pair{"as_published", Covariances::as_published}};
}

}  // namespace survtrack
