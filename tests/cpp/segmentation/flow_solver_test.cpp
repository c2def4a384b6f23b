// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "segmentation/flow_solver.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <random>
#include <vector>

#include "../simd_levels.hpp"
#include "plain_flow.hpp"

namespace survtrack::kernels {
namespace {

struct Case {
  std::ptrdiff_t width;
  std::ptrdiff_t height;
  int sweeps;
  FlowBlocking blocking{};
  double tolerance_px = 0.0;
  Derivatives derivatives = Derivatives::hs1981;
  bool bytes = true;
  bool warm = false;
  bool about = false;
};

class FlowSolverAtEverySimdLevel : public AtEverySimdLevel {
 protected:
  float uniform(float most) { return std::uniform_real_distribution<float>(-most, most)(random_); }

  void fill(FlowPlane& plane, PlainPlane& same, std::ptrdiff_t width, std::ptrdiff_t height) {
    plane.create(width, height);
    for (std::ptrdiff_t y = 0; y < height; ++y) {
      for (std::ptrdiff_t x = 0; x < width; ++x) plane.row(y)[x] = same.at(x, y) = uniform(3);
      plane.repeat_edges(y);
    }
  }

  /// Solves by both and compares all bits. Returns the sweeps.
  int compare(const Case& k) {
    const std::ptrdiff_t stride = k.width + 5;
    const auto pixels = static_cast<std::size_t>(stride * k.height);
    std::vector<std::uint8_t> bytes[2];
    std::vector<float> floats[2];
    for (int i = 0; i < 2; ++i) {
      for (std::size_t j = 0; j < pixels; ++j) {
        bytes[i].push_back(static_cast<std::uint8_t>(random_() % 256));
        floats[i].push_back(128 + uniform(127));
      }
    }
    FlowProblem problem;
    problem.width = k.width;
    problem.height = k.height;
    problem.previous = {k.bytes ? bytes[0].data() : nullptr, k.bytes ? nullptr : floats[0].data(), stride};
    problem.current = {k.bytes ? bytes[1].data() : nullptr, k.bytes ? nullptr : floats[1].data(), stride};
    problem.derivatives = k.derivatives;
    problem.smoothness = 0.2;
    problem.sweeps = k.sweeps;
    problem.tolerance_px = k.tolerance_px;
    FlowPlanes from, about;
    PlainPlane zeros(k.width, k.height), from_u = zeros, from_v = zeros, about_u = zeros, about_v = zeros;
    if (k.warm) {
      fill(from.u, from_u, k.width, k.height);
      fill(from.v, from_v, k.width, k.height);
      problem.from = &from;
    }
    if (k.about) {
      fill(about.u, about_u, k.width, k.height);
      fill(about.v, about_v, k.width, k.height);
      problem.about = &about;
    }
    PlainFlow judge(problem, about_u, about_v, from_u, from_v);
    const int expected = judge.solve();
    constexpr float untouched = -77.0f;
    std::vector<float> u(pixels, untouched), v(pixels, untouched);
    EXPECT_EQ(FlowSolver(k.blocking).solve(problem, {u.data(), v.data(), stride, stride, false}), expected);
    for (std::ptrdiff_t y = 0; y < k.height; ++y) {
      for (std::ptrdiff_t x = 0; x < stride; ++x) {
        const auto i = static_cast<std::size_t>(y * stride + x);
        EXPECT_EQ(u[i], x < k.width ? judge.u.at(x, y) : untouched) << x << ", " << y;
        EXPECT_EQ(v[i], x < k.width ? judge.v.at(x, y) : untouched) << x << ", " << y;
        if (testing::Test::HasFailure()) return expected;
      }
    }
    return expected;
  }

  std::mt19937 random_{11};
};
INSTANTIATE_TEST_SUITE_P(Levels, FlowSolverAtEverySimdLevel, testing::ValuesIn(simd_levels()), simd_level_name);

TEST_P(FlowSolverAtEverySimdLevel, EqualsPlainSweepsAtEverySize) {
  for (const std::ptrdiff_t width : {1, 2, 3, 15, 16, 17, 31, 33, 64, 97}) {
    for (const std::ptrdiff_t height : {1, 2, 3, 4, 7, 16}) {
      for (const int sweeps : {1, 2, 3, 10}) {
        SCOPED_TRACE(testing::Message() << width << "x" << height << ", " << sweeps << " sweeps");
        compare({width, height, sweeps});
        if (HasFailure()) return;
      }
    }
  }
}

TEST_P(FlowSolverAtEverySimdLevel, EqualsPlainSweepsInEveryVariation) {
  for (int variation = 0; variation < 16; ++variation) {
    SCOPED_TRACE(variation);
    Case k{50, 23, 11};
    k.derivatives = (variation & 1) != 0 ? Derivatives::sobel : Derivatives::hs1981;
    k.bytes = (variation & 2) == 0;
    k.warm = (variation & 4) != 0;
    k.about = (variation & 8) != 0;
    for (const int sweeps_in_pass : {25, 4}) {
      k.blocking.sweeps_in_pass = sweeps_in_pass;
      compare(k);
      if (HasFailure()) return;
    }
  }
}

TEST_P(FlowSolverAtEverySimdLevel, EqualsPlainSweepsHoweverTheWorkIsCutUp) {
  for (const int sweeps_in_pass : {1, 2, 7, 16, 17, 18, 25}) {
    for (const std::ptrdiff_t tile_columns : {0, 16, 32, 48}) {
      for (const std::ptrdiff_t width : {65, 80, 81}) {
        for (const std::ptrdiff_t most_kept_pixels : {0, 1 << 18}) {
          const int sweeps = width == 81 ? 51 : 25;
          SCOPED_TRACE(testing::Message() << sweeps_in_pass << " a pass, tiles of " << tile_columns << ", width "
                                          << width << ", kept " << most_kept_pixels);
          compare({width, 7, sweeps, {sweeps_in_pass, tile_columns, most_kept_pixels}});
          if (HasFailure()) return;
        }
      }
    }
  }
  compare({2100, 4, 30});  // wider than a tile
}

TEST_P(FlowSolverAtEverySimdLevel, StopsAtTheFirstSweepThatChangesLittle) {
  for (const bool warm : {false, true}) {
    int fewest = 1000;
    int most = 0;
    for (const double tolerance_px : {10.0, 0.3, 0.05, 0.01, 0.002, 1e-6}) {
      for (const FlowBlocking blocking : {FlowBlocking{}, FlowBlocking{7, 32}, FlowBlocking{1, 0}}) {
        SCOPED_TRACE(testing::Message() << tolerance_px << " px, " << blocking.sweeps_in_pass << " a pass");
        const int sweeps = compare({70, 21, 90, blocking, tolerance_px, Derivatives::hs1981, true, warm});
        if (HasFailure()) return;
        fewest = std::min(fewest, sweeps);
        most = std::max(most, sweeps);
      }
    }
    EXPECT_EQ(fewest, 1);
    EXPECT_GT(most, 50) << "tests too little";
  }
}

TEST(FlowSolver, WorksInTheSameMemoryAgain) {
  const std::vector<std::uint8_t> before(40 * 30, 10), now(40 * 30, 90);
  const auto solve = [&](FlowSolver& solver, std::ptrdiff_t width, int sweeps) {
    FlowProblem problem;
    problem.width = width;
    problem.height = 30;
    problem.previous = {before.data(), nullptr, 40};
    problem.current = {now.data(), nullptr, 40};
    problem.smoothness = 0.5;
    problem.sweeps = sweeps;
    std::vector<float> u(40 * 30), v(40 * 30);
    solver.solve(problem, {u.data(), v.data(), 40, 40, false});
    u.insert(u.end(), v.begin(), v.end());
    return u;
  };
  FlowSolver again;
  for (const std::ptrdiff_t width : {40, 17, 33}) {
    for (const int sweeps : {60, 3}) {
      FlowSolver fresh;
      EXPECT_EQ(solve(again, width, sweeps), solve(fresh, width, sweeps));
    }
  }
}

TEST_P(FlowSolverAtEverySimdLevel, MaskIsWhereTheFlowIsFaster) {
  const std::vector<float> u{0.0f, 3.0f, -3.0f, 0.0f, 3.0f, 0.1f}, v{0.0f, 4.0f, 4.0f, -5.1f, -4.1f, 5.0f};
  std::vector<std::uint8_t> mask(6, 9);
  mask_of_flow(u.data(), v.data(), 5.0f, mask.data(), mask.size());
  EXPECT_EQ(mask, (std::vector<std::uint8_t>{0, 0, 0, 255, 255, 255}));
}

}  // namespace
}  // namespace survtrack::kernels
