// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <cstdint>

#include "core/mask_bits.hpp"

/// Rows of a mask between one byte and one bit a pixel.
namespace survtrack::mask_bits {

/// Words that hold `bits` bits.
constexpr std::size_t words_for(std::size_t bits) { return (bits + word_bits - 1) / word_bits; }

/// The bits beyond the row's end are 0.
inline void pack_row(const std::uint8_t* pixels, std::size_t width, std::uint64_t* words) {
  const std::size_t whole = width / word_bits;
  const std::size_t tail = width % word_bits;
  for (std::size_t i = 0; i < whole; ++i) words[i] = pack_word(pixels + i * word_bits);
  if (tail > 0) words[whole] = pack_tail(pixels + whole * word_bits, tail);
}

/// Writes `width` pixels, 0 or 255, of the bits from `first` on; reads one word beyond theirs.
inline void unpack_row(const std::uint64_t* words, std::size_t first, std::uint8_t* pixels, std::size_t width) {
  const std::uint64_t* const from = words + first / word_bits;
  const std::size_t bits = first % word_bits;
  const auto word = [&](std::size_t i) { return (from[i] >> bits) | ((from[i + 1] << 1) << (word_bits - 1 - bits)); };
  const std::size_t whole = width / word_bits;
  const std::size_t tail = width % word_bits;
  for (std::size_t i = 0; i < whole; ++i) unpack_word(word(i), pixels + i * word_bits);
  if (tail > 0) unpack_tail(word(whole), pixels + whole * word_bits, tail);
}

}  // namespace survtrack::mask_bits
