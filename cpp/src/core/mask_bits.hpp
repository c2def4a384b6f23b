// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

/// Between masks of one byte a pixel and words of one bit a pixel, the first pixel in the lowest bit.
namespace survtrack::mask_bits {

constexpr std::size_t word_bits = 64;

/// The bits below `count`, 0 to 64.
constexpr std::uint64_t low_bits(std::size_t count) {
  return count < word_bits ? (std::uint64_t{1} << count) - 1 : ~std::uint64_t{0};
}

/// Eight pixels, the first in the lowest byte.
inline std::uint64_t load_8(const std::uint8_t* pixels) {
  std::uint64_t bytes = 0;
  if constexpr (std::endian::native == std::endian::little) {
    std::memcpy(&bytes, pixels, 8);
  } else {
    for (std::size_t i = 0; i < 8; ++i) bytes |= std::uint64_t{pixels[i]} << (8 * i);
  }
  return bytes;
}

inline void store_8(std::uint64_t bytes, std::uint8_t* pixels) {
  if constexpr (std::endian::native == std::endian::little) {
    std::memcpy(pixels, &bytes, 8);
  } else {
    for (std::size_t i = 0; i < 8; ++i) pixels[i] = static_cast<std::uint8_t>(bytes >> (8 * i));
  }
}

constexpr std::uint64_t each_byte = 0x0101010101010101;
constexpr std::uint64_t high_bits = 0x80 * each_byte;

/// The highest bit of each byte that is not 0: adding 127 carries into it unless the lower seven are 0.
constexpr std::uint64_t not_zero(std::uint64_t bytes) {
  return (((bytes & ~high_bits) + (high_bits - each_byte)) | bytes) & high_bits;
}

/// Sets bit i where pixel i of 64 is not 0, in plain C++.
inline std::uint64_t pack_word_portable(const std::uint8_t* pixels) {
  std::uint64_t word = 0;
  for (std::size_t i = 0; i < word_bits; i += 8) {
    // The product gathers the lowest bits of eight bytes in its highest byte.
    const std::uint64_t gathered = (not_zero(load_8(pixels + i)) >> 7) * 0x0102040810204080;
    word |= (gathered >> 56) << i;
  }
  return word;
}

/// Sets bit i where pixel i of 64 is not 0.
inline std::uint64_t pack_word(const std::uint8_t* pixels) {
#if defined(__SSE2__)
  const __m128i zero = _mm_setzero_si128();
  std::uint64_t background = 0;
  for (std::size_t i = 0; i < word_bits; i += 16) {
    const __m128i bytes = _mm_loadu_si128(reinterpret_cast<const __m128i*>(pixels + i));
    background |= std::uint64_t{static_cast<std::uint32_t>(_mm_movemask_epi8(_mm_cmpeq_epi8(bytes, zero)))} << i;
  }
  return ~background;
#else
  return pack_word_portable(pixels);
#endif
}

/// The same for the last `count` pixels of a row, fewer than 64.
inline std::uint64_t pack_tail(const std::uint8_t* pixels, std::size_t count) {
  std::uint8_t padded[word_bits] = {};
  std::memcpy(padded, pixels, count);
  return pack_word(padded);
}

/// Writes 255 for each bit set and 0 for each other.
inline void unpack_word(std::uint64_t word, std::uint8_t* pixels) {
  if (word == 0) {
    std::memset(pixels, 0, word_bits);
    return;
  }
  for (std::size_t i = 0; i < word_bits; i += 8) {
    // Eight bits in each of eight bytes, of which byte i keeps bit i.
    const std::uint64_t spread = (((word >> i) & 0xff) * each_byte) & 0x8040201008040201;
    store_8((not_zero(spread) >> 7) * 255, pixels + i);
  }
}

/// The same for the last `count` pixels of a row, fewer than 64.
inline void unpack_tail(std::uint64_t word, std::uint8_t* pixels, std::size_t count) {
  std::uint8_t padded[word_bits];
  unpack_word(word, padded);
  std::memcpy(pixels, padded, count);
}

}  // namespace survtrack::mask_bits
