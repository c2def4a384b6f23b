// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <cstdint>

/// The pixel loop of `static_reference`, exact in integers.
namespace survtrack::kernels {

/// A row of pixels, or a part of one. The arrays do not overlap.
template <int channels>
struct StaticReferenceRow {
  const std::uint8_t* frame;           ///< grey, or BGR interleaved
  const std::uint8_t* low[channels];   ///< lowest level of the background, channel by channel
  const std::uint8_t* high[channels];  ///< the highest
  std::uint8_t* mask;                  ///< 0 or 255; only written
  std::size_t count;                   ///< pixels

  /// `length` pixels from `first` on.
  StaticReferenceRow part(std::size_t first, std::size_t length) const {
    StaticReferenceRow result = *this;
    result.frame += channels * first;
    for (int c = 0; c < channels; ++c) {
      result.low[c] += first;
      result.high[c] += first;
    }
    result.mask += first;
    result.count = length;
    return result;
  }
};

/// Foreground is what lies outside of its levels in any channel.
template <int channels>
void static_reference_step(const StaticReferenceRow<channels>& row);

}  // namespace survtrack::kernels
