// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "segmentation/selective_kernels.hpp"

#include <algorithm>
#include <bit>
#include <cstring>

#include "core/simd.hpp"

namespace survtrack::kernels {
namespace {

// Pixels that take the foreground's way together when one of them is foreground.
constexpr std::size_t block = selective_block;

// All arithmetic stays in 16 bits, cast by cast: so the loops work on twice as many pixels at once.
SURVTRACK_SIMD_INLINE std::int16_t distance(std::int16_t a, std::int16_t b) {
  const auto difference = static_cast<std::int16_t>(a - b);
  return static_cast<std::int16_t>(difference < 0 ? -difference : difference);
}

/// How far a mean moves towards `level`: difference * rate / 32768, rounded, halves upwards; in the
/// form that compilers know as one instruction (pmulhrsw).
SURVTRACK_SIMD_INLINE std::int16_t movement(std::int16_t mean, std::int16_t level, std::int16_t rate) {
  const auto difference = static_cast<std::int16_t>((level << level_bits) - mean);
  return static_cast<std::int16_t>((((difference * rate) >> 14) + 1) >> 1);
}

SURVTRACK_SIMD_INLINE std::int16_t moved(std::int16_t mean, std::int16_t by, std::int16_t where) {
  return static_cast<std::int16_t>(mean + (by & where));
}

/// Marks what differs by more than the tolerance; there the means stay, elsewhere they move.
template <int channels>
SURVTRACK_SIMD_INLINE void compare_and_learn(const SelectiveRow<channels>& row, const SelectiveStep& step) {
  const std::uint8_t* frame[channels];
  std::int16_t* background[channels];
  for (int c = 0; c < channels; ++c) {
    frame[c] = row.frame[c];
    background[c] = row.background[c];
  }
  std::int16_t* const deviation = row.deviation;
  std::uint8_t* const mask = row.mask;
  const std::size_t count = row.count;
  const auto rate = static_cast<std::int16_t>(step.learn ? step.rate_q15 : 0);
  const auto tolerance = static_cast<std::int16_t>(step.tolerance);
  const auto gain = static_cast<std::int16_t>(step.noise_gain_q9);
  SURVTRACK_SIMD_LOOP
  for (std::size_t i = 0; i < count; ++i) {
    std::int16_t difference = 0;
    std::int16_t by[channels];
    for (int c = 0; c < channels; ++c) {
      difference = std::max(difference, distance(frame[c][i], rounded_level(background[c][i])));
      by[c] = movement(background[c][i], frame[c][i], rate);
    }
    const auto noise = static_cast<std::int16_t>((deviation[i] * gain) >> 16);
    const auto still = static_cast<std::int16_t>(difference > std::max(noise, tolerance) ? 0 : -1);
    for (int c = 0; c < channels; ++c) background[c][i] = moved(background[c][i], by[c], still);
    const std::int16_t moved_deviation = moved(deviation[i], movement(deviation[i], difference, rate), still);
    deviation[i] = std::min(moved_deviation, largest_deviation);
    mask[i] = static_cast<std::uint8_t>(~still);
  }
}

/// Foreground that has kept its colour for long becomes background and leaves the mask.
template <int channels>
SURVTRACK_SIMD_INLINE void absorb(const SelectiveRow<channels>& row, const SelectiveStep& step) {
  const std::uint8_t* frame[channels];
  std::int16_t* background[channels];
  std::uint8_t* candidate[channels];
  for (int c = 0; c < channels; ++c) {
    frame[c] = row.frame[c];
    background[c] = row.background[c];
    candidate[c] = row.candidate[c];
  }
  std::uint16_t* const age_ms = row.age_ms;
  std::uint8_t* const mask = row.mask;
  const std::size_t count = row.count;
  const auto tolerance = static_cast<std::int16_t>(step.tolerance);
  const auto elapsed = static_cast<std::uint16_t>(step.elapsed_ms);
  const auto most = static_cast<std::uint16_t>(65535 - step.elapsed_ms);  // the sum stays in 16 bits
  const auto oldest = static_cast<std::uint16_t>(step.absorb_ms);
  SURVTRACK_SIMD_LOOP
  for (std::size_t i = 0; i < count; ++i) {
    std::int16_t change = 0;
    for (int c = 0; c < channels; ++c) change = std::max(change, distance(frame[c][i], candidate[c][i]));
    // All bits or none, for "where": without branches, so that it is done for many pixels at once.
    const auto foreground = static_cast<std::uint16_t>(mask[i] * 257);
    const auto same = static_cast<std::uint16_t>(change <= tolerance ? 65535 : 0);
    const auto older = static_cast<std::uint16_t>(std::min<std::uint16_t>(age_ms[i], most) + elapsed);
    const auto age = static_cast<std::uint16_t>((foreground & same & older) | (~foreground & age_ms[i]));
    const auto taken = static_cast<std::uint16_t>(age > oldest ? foreground : 0);
    for (int c = 0; c < channels; ++c) {
      const auto other = static_cast<std::uint8_t>(foreground & ~same);
      candidate[c][i] = static_cast<std::uint8_t>((candidate[c][i] & ~other) | (frame[c][i] & other));
      background[c][i] = static_cast<std::int16_t>((background[c][i] & ~taken) | ((frame[c][i] << level_bits) & taken));
    }
    age_ms[i] = static_cast<std::uint16_t>(age & ~taken);
    mask[i] = static_cast<std::uint8_t>(foreground & ~taken);
  }
}

/// Takes from the mask what has the background's colour, darkened. With the sums s of the pixel's
/// channels and S of the background's, a channel's level I belongs to a shadow on a background level B
/// when |I - floor(s B / S)| <= tolerance, here without the division.
SURVTRACK_SIMD_INLINE void remove_shadows(const SelectiveRow<3>& row, const SelectiveStep& step) {
  const std::uint8_t* const frame[3] = {row.frame[0], row.frame[1], row.frame[2]};
  const std::int16_t* const background[3] = {row.background[0], row.background[1], row.background[2]};
  std::uint8_t* const mask = row.mask;
  const std::size_t count = row.count;
  const int darkest = step.shadow_darkest_q15;
  const int tolerance = step.shadow_tolerance;
  SURVTRACK_SIMD_LOOP
  for (std::size_t i = 0; i < count; ++i) {
    int brightness = 0;
    int background_brightness = 0;
    for (int c = 0; c < 3; ++c) {
      brightness += frame[c][i];
      background_brightness += rounded_level(background[c][i]);
    }
    int shadow = (brightness <= background_brightness) & ((brightness << 15) >= darkest * background_brightness);
    for (int c = 0; c < 3; ++c) {
      const int excess = brightness * rounded_level(background[c][i]) - frame[c][i] * background_brightness;
      shadow &= (excess >= -tolerance * background_brightness) & (excess < (tolerance + 1) * background_brightness);
    }
    mask[i] = static_cast<std::uint8_t>(mask[i] & (shadow - 1));
  }
}

/// Foreground pixels of a block.
SURVTRACK_SIMD_INLINE std::size_t foreground_in(const std::uint8_t* mask) {
  std::uint64_t words[block / 8];
  std::memcpy(words, mask, block);
  if ((words[0] | words[1] | words[2] | words[3]) == 0) return 0;
  std::size_t bits = 0;
  for (const std::uint64_t word : words) bits += static_cast<std::size_t>(std::popcount(word));
  return bits / 8;
}

/// Candidates and shadows of a block that holds foreground.
template <int channels>
SURVTRACK_SIMD_INLINE void treat_foreground(const SelectiveRow<channels>& row, const SelectiveStep& step) {
  if (step.learn) absorb(row, step);
  if constexpr (channels == 3) {
    if (step.remove_shadows) remove_shadows(row, step);
  }
}

/// A copy of the block in which a row ends: loops over a whole block are several times as fast as over a part of one, and
/// narrow regions are made of ends.
template <int channels>
struct End {
  std::uint8_t frame[channels][block];
  std::int16_t background[channels][block];
  std::int16_t deviation[block];
  std::uint8_t candidate[channels][block];
  std::uint16_t age_ms[block];
  std::uint8_t mask[block];

  SURVTRACK_SIMD_INLINE SelectiveRow<channels> row() {
    SelectiveRow<channels> row;
    for (int c = 0; c < channels; ++c) {
      row.frame[c] = frame[c];
      row.background[c] = background[c];
      row.candidate[c] = candidate[c];
    }
    row.deviation = deviation;
    row.age_ms = age_ms;
    row.mask = mask;
    row.count = block;
    return row;
  }
};

template <class Number>
SURVTRACK_SIMD_INLINE void read_block(Number* to, const Number* from) {
  std::memcpy(to, from, block * sizeof(Number));
}

/// The first `count` of a block; the others are written as they are, which spares a loop of any length.
template <class Number>
SURVTRACK_SIMD_INLINE void write_first(Number* to, const Number* from, std::size_t count) {
  SURVTRACK_SIMD_LOOP
  for (std::size_t i = 0; i < block; ++i) to[i] = i < count ? from[i] : to[i];
}

/// Fewer pixels than a block.
template <int channels>
SURVTRACK_SIMD_INLINE std::size_t step_end(const SelectiveRow<channels>& row, const SelectiveStep& step) {
  End<channels> end;
  const std::size_t count = row.count;
  for (int c = 0; c < channels; ++c) {
    read_block(end.frame[c], row.frame[c]);
    read_block(end.background[c], row.background[c]);
  }
  read_block(end.deviation, row.deviation);
  const SelectiveRow<channels> whole = end.row();
  compare_and_learn(whole, step);
  for (std::size_t i = 0; i < block; ++i) end.mask[i] = i < count ? end.mask[i] : std::uint8_t{0};
  const std::size_t foreground = foreground_in(end.mask);
  if (foreground > 0) {
    for (int c = 0; c < channels; ++c) read_block(end.candidate[c], row.candidate[c]);
    read_block(end.age_ms, row.age_ms);
    treat_foreground(whole, step);
    for (int c = 0; c < channels; ++c) write_first(row.candidate[c], end.candidate[c], count);
    write_first(row.age_ms, end.age_ms, count);
  }
  for (int c = 0; c < channels; ++c) write_first(row.background[c], end.background[c], count);
  write_first(row.deviation, end.deviation, count);
  std::memcpy(row.mask, end.mask, count);
  return foreground;
}

template <int channels>
struct StepKernel {
  SURVTRACK_SIMD_INLINE void operator()(const SelectiveRow<channels>& row, const SelectiveStep& step,
                                        std::size_t* foreground) const {
    const std::size_t whole = row.count - row.count % block;
    if (whole > 0) compare_and_learn(row.part(0, whole), step);
    for (std::size_t first = 0; first < whole; first += block) {
      const SelectiveRow<channels> part = row.part(first, block);
      const std::size_t found = foreground_in(part.mask);
      if (found > 0) treat_foreground(part, step);
      *foreground += found;
    }
    if (whole < row.count) *foreground += step_end(row.part(whole, row.count - whole), step);
  }
};

struct SplitKernel {
  SURVTRACK_SIMD_INLINE void operator()(const std::uint8_t* pixels, std::uint8_t* blue, std::uint8_t* green,
                                        std::uint8_t* red, std::size_t count) const {
    SURVTRACK_SIMD_LOOP
    for (std::size_t i = 0; i < count; ++i) {
      blue[i] = pixels[3 * i];
      green[i] = pixels[3 * i + 1];
      red[i] = pixels[3 * i + 2];
    }
  }
};

}  // namespace

void split_colors(const std::uint8_t* pixels, std::uint8_t* blue, std::uint8_t* green, std::uint8_t* red,
                  std::size_t count) {
  simd::run<SplitKernel>(pixels, blue, green, red, count);
}

template <int channels>
void selective_start(const SelectiveRow<channels>& row) {
  for (int c = 0; c < channels; ++c) {
    for (std::size_t i = 0; i < row.count; ++i) {
      row.background[c][i] = static_cast<std::int16_t>(row.frame[c][i] << level_bits);
    }
    std::copy_n(row.frame[c], row.count, row.candidate[c]);
  }
  std::fill_n(row.deviation, row.count, std::int16_t{0});
  std::fill_n(row.age_ms, row.count, std::uint16_t{0});
  std::fill_n(row.mask, row.count, std::uint8_t{0});
}

template <int channels>
std::size_t selective_step(const SelectiveRow<channels>& row, const SelectiveStep& step) {
  std::size_t foreground = 0;
  simd::run<StepKernel<channels>>(row, step, &foreground);
  return foreground;
}

template void selective_start(const SelectiveRow<1>&);
template void selective_start(const SelectiveRow<3>&);
template std::size_t selective_step(const SelectiveRow<1>&, const SelectiveStep&);
template std::size_t selective_step(const SelectiveRow<3>&, const SelectiveStep&);

}  // namespace survtrack::kernels
