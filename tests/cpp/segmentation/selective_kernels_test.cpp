// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "segmentation/selective_kernels.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "../simd_levels.hpp"

namespace survtrack::kernels {
namespace {

const SelectiveStep usual{.rate_q15 = 328,
                          .tolerance = 20,
                          .noise_gain_q9 = 3 * 512,
                          .elapsed_ms = 40,
                          .absorb_ms = 100,
                          .learn = true,
                          .remove_shadows = true,
                          .shadow_darkest_q15 = 22937,
                          .shadow_tolerance = 8};

/// A row of pixels with all that is known of them, in memory of its own. Behind it are others that differ from their
/// background, and must stay as they are.
template <int channels>
struct Pixels {
  explicit Pixels(std::size_t count)
      : width(count), frame(count * channels), background(count * channels), deviation(count),
        candidate(count * channels), age_ms(count), mask(count) {
    frame.resize(frame.size() + selective_block, 200);
    background.resize(background.size() + selective_block, 50 << level_bits);
    deviation.resize(deviation.size() + selective_block, 3);
    candidate.resize(candidate.size() + selective_block, 100);
    age_ms.resize(age_ms.size() + selective_block, 60000);
  }

  SelectiveRow<channels> row() {
    SelectiveRow<channels> row{};
    for (std::size_t c = 0; c < channels; ++c) {
      row.frame[c] = frame.data() + c * width;
      row.background[c] = background.data() + c * width;
      row.candidate[c] = candidate.data() + c * width;
    }
    row.deviation = deviation.data();
    row.age_ms = age_ms.data();
    row.mask = mask.data();
    row.count = width;
    return row;
  }

  std::size_t width;
  std::vector<std::uint8_t> frame;
  std::vector<std::int16_t> background;
  std::vector<std::int16_t> deviation;
  std::vector<std::uint8_t> candidate;
  std::vector<std::uint16_t> age_ms;
  std::vector<std::uint8_t> mask;
};

/// The model in plain words, one pixel at a time: the judge of the fast loops.
template <int channels>
class Judge {
 public:
  Judge(Pixels<channels>& pixels, const SelectiveStep& step) : p_(pixels), step_(step) {}

  std::size_t run() {
    std::size_t differing = 0;
    for (std::size_t i = 0; i < p_.width; ++i) differing += pixel(i) ? 1 : 0;
    return differing;
  }

 private:
  int level(std::size_t i, std::size_t c) const { return p_.frame[c * p_.width + i]; }
  std::int16_t& background(std::size_t i, std::size_t c) { return p_.background[c * p_.width + i]; }
  std::uint8_t& candidate(std::size_t i, std::size_t c) { return p_.candidate[c * p_.width + i]; }

  void learn(std::int16_t& mean, int sample) const {
    const double movement = ((sample << level_bits) - mean) * (step_.rate_q15 / 32768.0);
    mean = static_cast<std::int16_t>(mean + static_cast<int>(std::floor(movement + 0.5)));
  }

  bool pixel(std::size_t i) {
    int rounded[channels];
    int difference = 0;
    for (std::size_t c = 0; c < channels; ++c) {
      rounded[c] = static_cast<int>(std::floor(background(i, c) / 128.0 + 0.5));
      difference = std::max(difference, std::abs(level(i, c) - rounded[c]));
    }
    const double noise = std::floor(p_.deviation[i] / 128.0 * (step_.noise_gain_q9 / 512.0));
    const bool differs = difference > step_.tolerance && difference > noise;
    p_.mask[i] = differs ? 255 : 0;
    if (!differs) {
      if (!step_.learn) return false;
      for (std::size_t c = 0; c < channels; ++c) learn(background(i, c), level(i, c));
      learn(p_.deviation[i], difference);
      p_.deviation[i] = std::min<std::int16_t>(p_.deviation[i], 80 * 128);
      return false;
    }
    if ((step_.learn && absorbed(i)) || (channels == 3 && step_.remove_shadows && shadow(i, rounded))) p_.mask[i] = 0;
    return true;
  }

  bool absorbed(std::size_t i) {
    bool same = true;
    for (std::size_t c = 0; c < channels; ++c) same &= std::abs(level(i, c) - candidate(i, c)) <= step_.tolerance;
    const int age_ms = same ? std::min(p_.age_ms[i] + step_.elapsed_ms, 65535) : 0;
    p_.age_ms[i] = static_cast<std::uint16_t>(age_ms);
    for (std::size_t c = 0; c < channels && !same; ++c) candidate(i, c) = static_cast<std::uint8_t>(level(i, c));
    if (age_ms <= step_.absorb_ms) return false;
    for (std::size_t c = 0; c < channels; ++c) background(i, c) = static_cast<std::int16_t>(level(i, c) * 128);
    p_.age_ms[i] = 0;
    return true;
  }

  bool shadow(std::size_t i, const int (&rounded)[channels]) const {
    int brightness = 0;
    int full = 0;
    for (std::size_t c = 0; c < channels; ++c) {
      brightness += level(i, c);
      full += rounded[c];
    }
    if (brightness > full || brightness < step_.shadow_darkest_q15 / 32768.0 * full) return false;
    for (std::size_t c = 0; c < channels; ++c) {
      if (std::abs(level(i, c) - brightness * rounded[c] / full) > step_.shadow_tolerance) return false;
    }
    return true;
  }

  Pixels<channels>& p_;
  SelectiveStep step_;
};

template <int channels>
void expect_same(const Pixels<channels>& a, const Pixels<channels>& b) {
  EXPECT_EQ(a.background, b.background);
  EXPECT_EQ(a.deviation, b.deviation);
  EXPECT_EQ(a.candidate, b.candidate);
  EXPECT_EQ(a.age_ms, b.age_ms);
  EXPECT_EQ(a.mask, b.mask);
}

/// Frames in which pixels rest, flicker, darken and jump.
class Scene {
 public:
  template <int channels>
  void next(Pixels<channels>& pixels) {
    for (std::size_t i = 0; i < pixels.width; ++i) {
      const int kind = uniform(0, 7);
      const int light = kind == 0 ? uniform(600, 1000) : 1000;
      for (std::size_t c = 0; c < channels; ++c) {
        const int own = 40 + 70 * static_cast<int>(c) + 11 * static_cast<int>(i % 5);
        int level = own * light / 1000 + uniform(-6, 6);
        if (kind == 1) level = uniform(0, 255);
        if (kind == 2) level = 230 - own / 2;
        pixels.frame[c * pixels.width + i] = static_cast<std::uint8_t>(std::clamp(level, 0, 255));
      }
    }
  }

 private:
  int uniform(int low, int high) { return low + static_cast<int>(random_() % static_cast<unsigned>(high - low + 1)); }
  std::mt19937 random_{7};
};

/// Returns how many pixels in all differed from the background and yet were no foreground.
template <int channels>
std::size_t compare_with_judge(std::size_t width, SelectiveStep step) {
  Pixels<channels> judged(width);
  Pixels<channels> fast(width);
  Scene scene;
  std::size_t removed = 0;
  for (int frame = 0; frame < 60; ++frame) {
    scene.next(judged);
    fast.frame = judged.frame;
    if (frame == 0) {
      selective_start(judged.row());
      selective_start(fast.row());
      continue;
    }
    step.rate_q15 = frame == 1 ? 32767 : 32768 / frame;
    const std::size_t expected = Judge<channels>(judged, step).run();
    EXPECT_EQ(selective_step(fast.row(), step), expected);
    expect_same(fast, judged);
    removed += expected - static_cast<std::size_t>(std::count(judged.mask.begin(), judged.mask.end(), 255));
  }
  return removed;
}

class SelectiveKernels : public AtEverySimdLevel {};
INSTANTIATE_TEST_SUITE_P(Levels, SelectiveKernels, testing::ValuesIn(simd_levels()), simd_level_name);

TEST_P(SelectiveKernels, EqualThePlainModelAtEveryWidth) {
  for (const std::size_t width : {1, 2, 7, 15, 16, 17, 31, 32, 33, 63, 65, 130, 1000}) {
    SCOPED_TRACE(width);
    const std::size_t shadows_and_absorbed = compare_with_judge<3>(width, usual);
    const std::size_t absorbed = compare_with_judge<1>(width, usual);
    if (width < 100) continue;
    EXPECT_GT(absorbed, width / 2) << "the scene tests too little";
    EXPECT_GT(shadows_and_absorbed, width) << "the scene tests too little";
  }
}

TEST_P(SelectiveKernels, EqualThePlainModelAtTheEdgesOfTheirRanges) {
  SelectiveStep step = usual;
  step.noise_gain_q9 = 8192;
  step.elapsed_ms = 65535;
  step.absorb_ms = 65535;
  step.shadow_darkest_q15 = 0;
  step.shadow_tolerance = 255;
  compare_with_judge<3>(200, step);
  step = usual;
  step.tolerance = 0;
  step.noise_gain_q9 = 0;
  step.shadow_darkest_q15 = 32768;
  step.shadow_tolerance = 0;
  compare_with_judge<3>(200, step);
  compare_with_judge<1>(200, step);
  step = usual;
  step.learn = false;
  compare_with_judge<3>(200, step);
  compare_with_judge<1>(200, step);
}

// 128 parts a grey level; the background 100 is 12800, the frame 110 is 10 grey levels = 1280 away.
TEST_P(SelectiveKernels, MoveByHandWorkedSteps) {
  for (const auto& [rate_q15, movement] : {std::pair{328, 13}, {8192, 320}, {32767, 1280}, {12, 0}, {13, 1}, {0, 0}}) {
    Pixels<1> pixel(1);
    pixel.frame[0] = 110;
    pixel.background[0] = 12800;
    SelectiveStep step = usual;
    step.rate_q15 = rate_q15;
    EXPECT_EQ(selective_step(pixel.row(), step), 0U);
    EXPECT_EQ(pixel.background[0], 12800 + movement);
    EXPECT_EQ(pixel.deviation[0], movement);
  }
}

TEST_P(SelectiveKernels, SplitColors) {
  for (const std::size_t count : {1, 2, 7, 15, 16, 17, 31, 33, 100}) {
    std::vector<std::uint8_t> pixels(3 * count);
    for (std::size_t i = 0; i < pixels.size(); ++i) pixels[i] = static_cast<std::uint8_t>(7 * i);
    std::vector<std::uint8_t> planes(3 * count);
    split_colors(pixels.data(), planes.data(), planes.data() + count, planes.data() + 2 * count, count);
    for (std::size_t i = 0; i < pixels.size(); ++i) EXPECT_EQ(planes[i % 3 * count + i / 3], pixels[i]);
  }
}

}  // namespace
}  // namespace survtrack::kernels
