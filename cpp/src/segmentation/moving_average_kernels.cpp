// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "segmentation/moving_average_kernels.hpp"

#include "core/simd.hpp"

namespace survtrack::kernels {
namespace {

template <class Sum>
struct AddKernel {
  SURVTRACK_SIMD_INLINE void operator()(Sum* sum, const std::uint8_t* added, std::size_t count) const {
    SURVTRACK_SIMD_LOOP
    for (std::size_t i = 0; i < count; ++i) sum[i] = static_cast<Sum>(sum[i] + added[i]);
  }
};

template <class Sum>
struct MeanKernel {
  // Exact: sums stay below 2^24 and a quotient of at most 255 by at most 10001 lies at least 1/10001
  // below the next integer, so the float division never rounds up to it.
  SURVTRACK_SIMD_INLINE void operator()(const Sum* sum, int frames, std::uint8_t* mean, std::size_t count) const {
    const int half = frames / 2;
    const auto divisor = static_cast<float>(frames);
    SURVTRACK_SIMD_LOOP
    for (std::size_t i = 0; i < count; ++i) {
      const int level = static_cast<int>(static_cast<float>(static_cast<int>(sum[i]) + half) / divisor);
      mean[i] = static_cast<std::uint8_t>(level);
    }
  }
};

template <class Sum, bool with_secondary>
struct StepKernel {
  SURVTRACK_SIMD_INLINE void operator()(const MovingAverageStep<Sum>& step) const {
    Sum* const sum = step.sum;
    const std::uint8_t* const added = step.added;
    const std::uint8_t* const dropped = step.dropped;
    const std::uint8_t* const frame = step.frame;
    std::uint8_t* const secondary = step.secondary;
    std::uint8_t* const mask = step.mask;
    const std::size_t count = step.count;
    const auto frames = static_cast<Sum>(step.frames);
    const auto limit = static_cast<Sum>(step.limit);
    const auto secondary_limit = static_cast<std::uint8_t>(step.secondary_limit);
    SURVTRACK_SIMD_LOOP
    for (std::size_t i = 0; i < count; ++i) {
      const std::uint8_t level = frame[i];
      const auto total = static_cast<Sum>(sum[i] + added[i] - dropped[i]);
      const auto scaled = static_cast<Sum>(frames * level);
      const auto difference = static_cast<Sum>(total > scaled ? total - scaled : scaled - total);
      std::uint8_t moving = difference > limit ? 255 : 0;
      if constexpr (with_secondary) {
        const std::uint8_t known = secondary[i];
        const auto change = static_cast<std::uint8_t>(known > level ? known - level : level - known);
        moving = static_cast<std::uint8_t>(moving & (change > secondary_limit ? 255 : 0));
        secondary[i] = static_cast<std::uint8_t>((known & moving) | (level & ~moving));
      }
      sum[i] = total;
      mask[i] = moving;
    }
  }
};

}  // namespace

template <class Sum>
void add_frame(Sum* sum, const std::uint8_t* added, std::size_t count) {
  simd::run<AddKernel<Sum>>(sum, added, count);
}

template <class Sum>
void mean_of_sum(const Sum* sum, int frames, std::uint8_t* mean, std::size_t count) {
  simd::run<MeanKernel<Sum>>(sum, frames, mean, count);
}

template <class Sum>
void moving_average_step(const MovingAverageStep<Sum>& step) {
  if (step.secondary != nullptr) {
    simd::run<StepKernel<Sum, true>>(step);
  } else {
    simd::run<StepKernel<Sum, false>>(step);
  }
}

template void add_frame(std::uint16_t*, const std::uint8_t*, std::size_t);
template void add_frame(std::uint32_t*, const std::uint8_t*, std::size_t);
template void mean_of_sum(const std::uint16_t*, int, std::uint8_t*, std::size_t);
template void mean_of_sum(const std::uint32_t*, int, std::uint8_t*, std::size_t);
template void moving_average_step(const MovingAverageStep<std::uint16_t>&);
template void moving_average_step(const MovingAverageStep<std::uint32_t>&);

}  // namespace survtrack::kernels
