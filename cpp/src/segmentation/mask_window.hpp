// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <cstdint>

#include "core/mask_bits.hpp"
#include "core/simd.hpp"

namespace survtrack::kernels {

/// to = from (and | or) from shifted by `near` (and | or) from shifted by `far` bits, in `count` words.
/// Forwards a bit meets those after it, backwards those before it; reads far / 64 + 1 words beyond.
struct Window {
  std::uint64_t* to;
  const std::uint64_t* from;
  std::size_t count;
  std::size_t near;
  std::size_t far;
};

template <bool forwards>
struct Shifted {
  const std::uint64_t* words;
  unsigned bits;

  SURVTRACK_SIMD_INLINE Shifted(const std::uint64_t* from, std::size_t shift)
      : words(forwards ? from + shift / mask_bits::word_bits : from - shift / mask_bits::word_bits),
        bits(static_cast<unsigned>(shift % mask_bits::word_bits)) {}

  /// Shifts in two steps, as a shift by all 64 bits is undefined.
  SURVTRACK_SIMD_INLINE std::uint64_t operator[](std::size_t i) const {
    if constexpr (forwards) return (words[i] >> bits) | ((words[i + 1] << 1) << (63 - bits));
    return (words[i] << bits) | ((words[i - 1] >> 1) >> (63 - bits));
  }
};

template <bool erode, bool forwards>
struct WindowKernel {
  SURVTRACK_SIMD_INLINE void operator()(const Window& window) const {
    std::uint64_t* const to = window.to;
    const std::uint64_t* const from = window.from;
    const Shifted<forwards> near(from, window.near);
    const Shifted<forwards> far(from, window.far);
    const std::size_t count = window.count;
    SURVTRACK_SIMD_LOOP
    for (std::size_t i = 0; i < count; ++i) {
      to[i] = erode ? from[i] & near[i] & far[i] : from[i] | near[i] | far[i];
    }
  }
};

inline void run_window(bool erode, bool forwards, const Window& window) {
  if (erode) {
    forwards ? simd::run<WindowKernel<true, true>>(window) : simd::run<WindowKernel<true, false>>(window);
  } else {
    forwards ? simd::run<WindowKernel<false, true>>(window) : simd::run<WindowKernel<false, false>>(window);
  }
}

}  // namespace survtrack::kernels
