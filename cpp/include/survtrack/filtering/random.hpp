// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <array>
#include <cstdint>

namespace survtrack {

/// Random numbers that are the same bytes on every platform and with every compiler, which those of
/// std::normal_distribution are not: xoshiro256++ (Blackman and Vigna 2021), its state filled from the seed by
/// splitmix64; normal numbers by Marsaglia's polar method, with a logarithm of our own.
class Random {
 public:
  explicit Random(std::uint64_t seed = 0);

  std::uint64_t bits();  ///< 64 of them
  double uniform();      ///< in [0, 1), a multiple of 2^-53
  double normal();       ///< of mean 0 and variance 1

  /// All that decides about the numbers to come: for copies that go on where this one is.
  struct State {
    std::array<std::uint64_t, 4> words;
    double spare;  ///< the second normal number of a pair
    bool has_spare;
  };
  const State& state() const { return state_; }
  void set_state(const State& state) { state_ = state; }

 private:
  State state_;
};

}  // namespace survtrack
