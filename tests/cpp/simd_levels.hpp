// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "core/simd.hpp"

namespace survtrack {

/// The instruction sets that this CPU has.
inline std::vector<simd::Level> simd_levels() {
  std::vector<simd::Level> levels;
  for (const auto level : {simd::Level::baseline, simd::Level::avx2, simd::Level::avx512}) {
    if (level <= simd::best_level()) levels.push_back(level);
  }
  return levels;
}

/// Runs its tests at one level; instantiate over `simd_levels()`, named by `simd_level_name`.
class AtEverySimdLevel : public testing::TestWithParam<simd::Level> {
 protected:
  void SetUp() override { simd::set_level(GetParam()); }
  void TearDown() override { simd::set_level(simd::best_level()); }
};

inline std::string simd_level_name(const testing::TestParamInfo<simd::Level>& info) {
  return "level" + std::to_string(static_cast<int>(info.param));
}

}  // namespace survtrack
