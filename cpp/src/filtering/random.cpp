// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "survtrack/filtering/random.hpp"

#include <cmath>

namespace survtrack {
namespace {

std::uint64_t rotated(std::uint64_t bits, int by) { return (bits << by) | (bits >> (64 - by)); }

/// The natural logarithm by operations that are exactly rounded everywhere, unlike std::log:
/// ln(m 2^e) = e ln 2 + 2 artanh((m - 1) / (m + 1)) with m between the roots of 1/2 and 2.
double same_log(double value) {
  constexpr double ln_2 = 0.6931471805599453, root_half = 0.7071067811865476;
  int exponent = 0;
  double m = std::frexp(value, &exponent);
  if (m < root_half) {
    m *= 2.0;
    --exponent;
  }
  const double t = (m - 1.0) / (m + 1.0), square = t * t;
  double sum = 0.0;
  for (int k = 23; k >= 1; k -= 2) sum = sum * square + 1.0 / k;
  return exponent * ln_2 + 2.0 * t * sum;
}

}  // namespace

Random::Random(std::uint64_t seed) : state_{{}, 0.0, false} {
  for (std::uint64_t& word : state_.words) {  // splitmix64
    seed += 0x9e3779b97f4a7c15U;
    word = (seed ^ (seed >> 30)) * 0xbf58476d1ce4e5b9U;
    word = (word ^ (word >> 27)) * 0x94d049bb133111ebU;
    word ^= word >> 31;
  }
}

std::uint64_t Random::bits() {
  auto& s = state_.words;
  const std::uint64_t result = rotated(s[0] + s[3], 23) + s[0];
  const std::uint64_t shifted = s[1] << 17;
  s[2] ^= s[0];
  s[3] ^= s[1];
  s[1] ^= s[2];
  s[0] ^= s[3];
  s[2] ^= shifted;
  s[3] = rotated(s[3], 45);
  return result;
}

double Random::uniform() { return static_cast<double>(bits() >> 11) * 0x1p-53; }

double Random::normal() {
  if (state_.has_spare) {
    state_.has_spare = false;
    return state_.spare;
  }
  double a, b, square;
  do {
    a = 2.0 * uniform() - 1.0;
    b = 2.0 * uniform() - 1.0;
    square = a * a + b * b;
  } while (square >= 1.0 || square == 0.0);
  const double scale = std::sqrt(-2.0 * same_log(square) / square);
  state_.spare = b * scale;
  state_.has_spare = true;
  return a * scale;
}

}  // namespace survtrack
