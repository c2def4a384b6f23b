// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "core/mask_bits.hpp"

#include <gtest/gtest.h>

#include <array>
#include <random>

namespace survtrack::mask_bits {
namespace {

TEST(MaskBits, AnyValueButZeroSetsItsBit) {
  std::mt19937 random(1);
  std::array<std::uint8_t, word_bits> pixels{};
  for (int value = 1; value < 256; ++value) {
    std::uint64_t expected = 0;
    for (std::size_t i = 0; i < word_bits; ++i) {
      const bool set = random() % 2 == 1;
      pixels[i] = set ? static_cast<std::uint8_t>(value) : 0;
      expected |= std::uint64_t{set} << i;
    }
    EXPECT_EQ(pack_word(pixels.data()), expected) << value;
    EXPECT_EQ(pack_word_portable(pixels.data()), expected) << value;
    EXPECT_EQ(pack_tail(pixels.data(), 13), expected & low_bits(13)) << value;
  }
}

TEST(MaskBits, UnpackingWritesZeroAnd255) {
  std::mt19937_64 random(2);
  for (int round = 0; round < 100; ++round) {
    const std::uint64_t word = round == 0 ? 0 : random();
    std::array<std::uint8_t, word_bits> pixels{};
    pixels.fill(7);
    unpack_word(word, pixels.data());
    for (std::size_t i = 0; i < word_bits; ++i) EXPECT_EQ(pixels[i], (word >> i) % 2 == 1 ? 255 : 0);
    pixels.fill(7);
    unpack_tail(word, pixels.data(), 13);
    for (std::size_t i = 0; i < word_bits; ++i) EXPECT_EQ(pixels[i], i >= 13 ? 7 : (word >> i) % 2 == 1 ? 255 : 0);
  }
}

TEST(MaskBits, LowBits) {
  EXPECT_EQ(low_bits(0), 0U);
  EXPECT_EQ(low_bits(1), 1U);
  EXPECT_EQ(low_bits(63), ~std::uint64_t{0} >> 1);
  EXPECT_EQ(low_bits(64), ~std::uint64_t{0});
}

}  // namespace
}  // namespace survtrack::mask_bits
