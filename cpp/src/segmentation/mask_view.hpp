// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <cstdint>

namespace survtrack::kernels {

/// A mask in memory: rows of `width` bytes, `stride` bytes apart; not 0 is foreground.
struct MaskView {
  std::uint8_t* data;
  std::size_t width;
  std::size_t height;
  std::size_t stride;

  std::uint8_t* row(std::size_t y) const { return data + y * stride; }
};

}  // namespace survtrack::kernels
