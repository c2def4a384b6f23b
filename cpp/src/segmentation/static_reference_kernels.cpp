// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "segmentation/static_reference_kernels.hpp"

#include "core/simd.hpp"

namespace survtrack::kernels {
namespace {

template <int channels>
struct StepKernel {
  SURVTRACK_SIMD_INLINE void operator()(const StaticReferenceRow<channels>& row) const {
    const std::uint8_t* const frame = row.frame;
    const std::uint8_t* low[channels];
    const std::uint8_t* high[channels];
    for (int c = 0; c < channels; ++c) {
      low[c] = row.low[c];
      high[c] = row.high[c];
    }
    std::uint8_t* const mask = row.mask;
    const std::size_t count = row.count;
    SURVTRACK_SIMD_LOOP
    for (std::size_t i = 0; i < count; ++i) {
      std::uint8_t outside = 0;
      for (std::size_t c = 0; c < channels; ++c) {
        const std::uint8_t level = frame[channels * i + c];
        const std::uint8_t below = level < low[c][i] ? 255 : 0;
        const std::uint8_t above = level > high[c][i] ? 255 : 0;
        outside = static_cast<std::uint8_t>(outside | below | above);
      }
      mask[i] = outside;
    }
  }
};

}  // namespace

template <int channels>
void static_reference_step(const StaticReferenceRow<channels>& row) {
  simd::run<StepKernel<channels>>(row);
}

template void static_reference_step(const StaticReferenceRow<1>&);
template void static_reference_step(const StaticReferenceRow<3>&);

}  // namespace survtrack::kernels
