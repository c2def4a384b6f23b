// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <cstdint>

/// The pixel loops of `moving_average`, exact in integers. `Sum` is std::uint16_t, which holds the sum
/// of up to 257 grey levels, or std::uint32_t. All arrays have `count` pixels and do not overlap,
/// but those read only may be the same.
namespace survtrack::kernels {

constexpr int most_frames_in_16_bits = 65535 / 255;

/// sum += added.
template <class Sum>
void add_frame(Sum* sum, const std::uint8_t* added, std::size_t count);

/// mean = sum / frames, rounded to the nearest, halves upwards.
template <class Sum>
void mean_of_sum(const Sum* sum, int frames, std::uint8_t* mean, std::size_t count);

template <class Sum>
struct MovingAverageStep {
  Sum* sum;                     ///< grey levels summed over the window
  const std::uint8_t* added;    ///< frame that enters the window
  const std::uint8_t* dropped;  ///< frame that leaves it
  const std::uint8_t* frame;    ///< frame to segment
  std::uint8_t* secondary;      ///< secondary background; nullptr: none
  std::uint8_t* mask;           ///< 0 or 255
  std::size_t count;
  int frames;           ///< in the window, after this step
  int limit;            ///< foreground: |sum - frames frame| > limit
  int secondary_limit;  ///< and |secondary - frame| > secondary_limit
};

/// Moves the window, segments, and learns the secondary background where the mask is 0, in one pass
/// (Narayana 2007, eq. 3.1, 3.2, 3.4, 3.5).
template <class Sum>
void moving_average_step(const MovingAverageStep<Sum>& step);

}  // namespace survtrack::kernels
