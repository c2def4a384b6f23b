// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <array>
#include <utility>

namespace survtrack {

/// What noises are measured in.
enum class NoiseUnit {
  object_size,  ///< the root of the object's box area: near and far objects are treated alike
  px,
};
constexpr auto enum_names(NoiseUnit) {
  return std::array{std::pair{"object_size", NoiseUnit::object_size}, std::pair{"px", NoiseUnit::px}};
}

}  // namespace survtrack
