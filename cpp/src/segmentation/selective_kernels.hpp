// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <cstdint>

/// The pixel loops of `selective`, exact in integers: the same bytes on every CPU.
namespace survtrack::kernels {

/// Fraction bits of background and deviation.
constexpr int level_bits = 7;
/// Deviations are held below this, so that foreground can be seen in the wildest place.
constexpr std::int16_t largest_deviation = 80 << level_bits;

/// Pixels that are worked on together.
constexpr std::size_t selective_block = 32;

/// A row of pixels, or a part of one: the frame and what is known of the place, channel by channel. The arrays do not
/// overlap. All but `mask` have `selective_block` elements more than `count`, of any value: the last pixels are worked on in
/// a whole block, which leaves the others of the block as they were.
template <int channels>
struct SelectiveRow {
  const std::uint8_t* frame[channels];
  std::int16_t* background[channels];  ///< grey levels, `level_bits` fraction bits
  std::int16_t* deviation;             ///< mean of the largest channel difference, in the same unit
  std::uint8_t* candidate[channels];   ///< the colour of foreground, as it was when it last changed
  std::uint16_t* age_ms;               ///< how long foreground has had that colour
  std::uint8_t* mask;                  ///< 0 or 255; only written
  std::size_t count;

  /// `length` pixels from `first` on.
  SelectiveRow part(std::size_t first, std::size_t length) const {
    SelectiveRow result = *this;
    for (int c = 0; c < channels; ++c) {
      result.frame[c] += first;
      result.background[c] += first;
      result.candidate[c] += first;
    }
    result.deviation += first;
    result.age_ms += first;
    result.mask += first;
    result.count = length;
    return result;
  }
};

/// What is the same for all pixels of a frame.
struct SelectiveStep {
  int rate_q15;             ///< 0 to 32767: how far the means move towards the frame, in 1/32768
  int tolerance;            ///< 0 to 255: foreground differs by more in some channel
  int noise_gain_q9;        ///< 0 to 8192: and by more than so many mean deviations, in 1/512
  int elapsed_ms;           ///< 0 to 65535: since the frame before
  int absorb_ms;            ///< 0 to 65535: foreground of one colour for longer becomes background
  bool learn;               ///< false: background, deviation and candidates stay as they are
  bool remove_shadows;      ///< of colour frames: levels of grey do not tell a shadow from a dark thing
  int shadow_darkest_q15;   ///< 0 to 32768: a shadow keeps at least this part of the brightness, in 1/32768
  int shadow_tolerance;     ///< 0 to 255: and the darkened background's colour, within so many grey levels
};

/// Takes interleaved BGR pixels apart.
void split_colors(const std::uint8_t* pixels, std::uint8_t* blue, std::uint8_t* green, std::uint8_t* red,
                  std::size_t count);

/// The frame becomes the background, without deviations and candidates; the mask 0.
template <int channels>
void selective_start(const SelectiveRow<channels>& row);

/// Segments the row and learns from it. Returns how many pixels differ from the background, among them
/// those that leave the mask again as shadows or because they become background.
template <int channels>
std::size_t selective_step(const SelectiveRow<channels>& row, const SelectiveStep& step);

/// A background level without its fraction, halves upwards.
constexpr std::int16_t rounded_level(std::int16_t level) {
  const auto raised = static_cast<std::int16_t>(level + (1 << (level_bits - 1)));
  return static_cast<std::int16_t>(raised >> level_bits);
}

}  // namespace survtrack::kernels
