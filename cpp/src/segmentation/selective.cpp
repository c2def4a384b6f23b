// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "segmentation/selective.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "core/simd.hpp"
#include "segmentation/pixel_rect.hpp"
#include "segmentation/selective_kernels.hpp"
#include "survtrack/core/checks.hpp"

namespace survtrack {
namespace {

using kernels::SelectiveRow;
using kernels::SelectiveStep;

constexpr double most_ms = 65535.0;
// Smaller movements would be lost in the fraction bits: with this one a mean comes within half a grey
// level of a steady frame. Faster cameras and slower backgrounds learn from every other frame, or fewer.
constexpr int least_rate_q15 = 256;
// Young backgrounds absorb sooner: what the first frame held by chance leaves within seconds.
constexpr double least_absorb_s = 0.5;
constexpr double absorb_part_of_age = 0.5;
// In update times: younger backgrounds are shown whole frames.
constexpr double young_updates = 2.0;

int in_q(int bits, double value) { return static_cast<int>(std::lround(std::ldexp(value, bits))); }

class SelectiveSegmenter final : public Segmenter {
 public:
  explicit SelectiveSegmenter(const SelectiveOptions& options) : options_(options) {}

  bool reads_regions() const override { return true; }
  /// While the background is young each pixel's own mean is still forming, and what the first frame held by chance fades.
  bool needs_whole_frame() const override {
    return channels_ == 0 || previous_s_ - start_s_ < young_updates * options_.update_time_s;
  }

  void segment(const cv::Mat& frame, const Expectation& expectation, cv::Mat& mask,
               std::vector<Event>& events) override {
    if (!whole_.whole() || whole_.size() != frame.size()) whole_.read_whole(frame.size());
    segment_regions(frame, expectation, whole_, mask, events);
  }

  void segment_regions(const cv::Mat& frame, const Expectation& expectation, const ReadPlan& plan, cv::Mat& mask,
                       std::vector<Event>& events) override {
    check_image(frame);
    if (channels_ != 0) check_same_format(frame, size_, channels_);
    check_time(expectation.time_s, channels_ != 0 ? std::optional(previous_s_) : std::nullopt);
    if (frame.channels() == 3) {
      segment_channels<3>(frame, expectation, plan, mask, events);
    } else {
      segment_channels<1>(frame, expectation, plan, mask, events);
    }
    previous_s_ = expectation.time_s;
  }

  void background(cv::Mat& picture) const override {
    if (channels_ == 0) {
      picture.release();
      return;
    }
    picture.create(size_, CV_8UC(channels_));
    for (int y = 0; y < size_.height; ++y) {
      const std::int16_t* const levels = levels_.data() + offset(y, channels_ + 1);
      auto* const pixels = picture.ptr<std::uint8_t>(y);
      for (int x = 0; x < size_.width; ++x) {
        for (int c = 0; c < channels_; ++c) {
          pixels[x * channels_ + c] = static_cast<std::uint8_t>(kernels::rounded_level(levels[c * size_.width + x]));
        }
      }
    }
  }

  void reset() override { channels_ = 0; }

 private:
  template <int channels>
  void segment_channels(const cv::Mat& frame, const Expectation& expectation, const ReadPlan& plan, cv::Mat& mask,
                        std::vector<Event>& events) {
    mask.create(frame.size(), CV_8UC1);
    if (channels_ == 0) {
      allocate(frame.size(), channels);
      start<channels>(frame, expectation.time_s, mask);
      return;
    }
    find_kept(expectation.keep);
    const double differing = step<channels>(frame, plan, expectation.time_s, mask);
    const double part = differing / (static_cast<double>(size_.width) * size_.height);
    // Of a frame read in parts nobody knows the rest: the detector looks at the next one whole.
    if (!plan.whole() || part <= options_.scene_change_fraction) return;
    start<channels>(frame, expectation.time_s, mask);
    Event& event = events.emplace_back();
    event.kind = EventKind::scene_changed;
    event.text = "The scene changed: " + std::to_string(std::lround(100.0 * part)) +
                 " % of the frame differ from the background, which starts anew from this frame.";
  }

  void allocate(const cv::Size& size, int channels) {
    size_ = size;
    channels_ = channels;
    const auto area = static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height);
    const auto planes = static_cast<std::size_t>(channels);
    // A block more, of which nothing is used: see SelectiveRow.
    levels_.resize(area * (planes + 1) + kernels::selective_block);
    candidates_.resize(area * planes + kernels::selective_block);
    ages_ms_.resize(area + kernels::selective_block);
    colors_.resize(planes * color_stride());
  }

  template <int channels>
  void start(const cv::Mat& frame, double time_s, cv::Mat& mask) {
    start_s_ = time_s;
    unlearned_s_ = 0.0;
    for (int y = 0; y < size_.height; ++y) kernels::selective_start(row<channels>(frame, mask, y, 0, size_.width));
  }

  /// Returns how many pixels differ from the background.
  template <int channels>
  double step(const cv::Mat& frame, const ReadPlan& plan, double time_s, cv::Mat& mask) {
    const SelectiveStep now = step_to(time_s);
    const SelectiveStep refresh = refreshing(now, plan.refresh_elapsed_s(), time_s);
    if (!plan.whole()) mask.setTo(0);
    std::size_t differing = 0;
    for (const ReadPlan::Band& band : plan.bands()) {
      for (int y = band.top; y < band.bottom; ++y) {
        find_kept_columns(y);
        for (std::size_t i = band.first_span; i < band.last_span; ++i) {
          const ReadPlan::Span& span = plan.spans()[i];
          if (!plan.whole() && y + ahead < band.bottom) fetch(frame, mask, y + ahead, span, channels);
          differing += step_span(row<channels>(frame, mask, y, span.begin, span.end), span, span.refresh ? refresh : now);
        }
      }
    }
    return static_cast<double>(differing);
  }

  /// One row's pixels of a span, which know whether they may be learned.
  template <int channels>
  std::size_t step_span(const SelectiveRow<channels>& whole, const ReadPlan::Span& span, SelectiveStep step) const {
    std::size_t differing = 0;
    for (int x = span.begin; x < span.end;) {
      const Stretch stretch = stretch_at(x);
      const int end = std::min(stretch.end, span.end);
      step.learn = !stretch.kept;
      differing += kernels::selective_step(whole.part(static_cast<std::size_t>(x), static_cast<std::size_t>(end - x)), step);
      x = end;
    }
    return differing;
  }

  static constexpr int ahead = 2;  ///< rows

  /// Asks for the memory of a span's beginning before its turn comes: each row's arrays lie far from the last row's, and the
  /// processor foresees only what follows within a row.
  void fetch(const cv::Mat& frame, const cv::Mat& mask, int y, const ReadPlan::Span& span, int channels) const {
    constexpr std::ptrdiff_t line = 64, most = 2 * line;
    const std::ptrdiff_t begin = span.begin, count = std::min<std::ptrdiff_t>(span.end - span.begin, most);
    const auto ask = [](const void* from, std::ptrdiff_t bytes) {
      const auto* const first = static_cast<const char*>(from);
      for (std::ptrdiff_t at = 0; at < bytes + line; at += line) simd::prefetch(first + std::min(at, bytes - 1));
    };
    ask(frame.ptr<std::uint8_t>(y) + channels * begin, channels * count);
    ask(mask.ptr<std::uint8_t>(y) + begin, count);
    const std::int16_t* const levels = levels_.data() + offset(y, channels + 1) + begin;
    for (int c = 0; c <= channels; ++c) ask(levels + std::ptrdiff_t{c} * size_.width, 2 * count);
  }

  /// The constants of the frame at `time_s`, which is later than the one before.
  SelectiveStep step_to(double time_s) {
    const double age_s = time_s - start_s_;
    unlearned_s_ += time_s - previous_s_;
    // At first the plain mean of what was seen, in that every moment weighs the same.
    const double rate = unlearned_s_ / std::min(options_.update_time_s, std::max(age_s, unlearned_s_));
    int rate_q15 = in_q(15, std::min(rate, 32767.0 / 32768.0));
    if (rate_q15 < least_rate_q15) {
      rate_q15 = 0;
    } else {
      unlearned_s_ = 0.0;
    }
    // From times since the start, so that rounding does not add up.
    const double elapsed_ms = std::round(1000.0 * age_s) - std::round(1000.0 * (previous_s_ - start_s_));
    const double absorb_s = std::min(options_.absorb_time_s, std::max(absorb_part_of_age * age_s, least_absorb_s));
    return {
        .rate_q15 = rate_q15,
        .tolerance = static_cast<int>(options_.threshold),
        .noise_gain_q9 = in_q(9, options_.noise_gain),
        .elapsed_ms = static_cast<int>(std::min(elapsed_ms, most_ms)),
        .absorb_ms = static_cast<int>(std::min(1000.0 * absorb_s, most_ms)),
        .learn = true,
        .remove_shadows = options_.remove_shadows,
        .shadow_darkest_q15 = static_cast<int>(std::ldexp(options_.shadow_darkest, 15)),
        .shadow_tolerance = static_cast<int>(options_.shadow_color_tolerance),
    };
  }

  /// The constants of pixels that were last read so long ago: they move as far as in all the frames between.
  SelectiveStep refreshing(SelectiveStep step, double elapsed_s, double time_s) const {
    const double rate = elapsed_s / std::min(options_.update_time_s, std::max(time_s - start_s_, elapsed_s));
    step.rate_q15 = std::max(in_q(15, std::min(rate, 32767.0 / 32768.0)), least_rate_q15);
    step.elapsed_ms = static_cast<int>(std::min(std::round(1000.0 * elapsed_s), most_ms));
    return step;
  }

  /// Where row y begins in a vector that holds `arrays` numbers a pixel.
  std::size_t offset(int y, int arrays) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(arrays) * static_cast<std::size_t>(size_.width);
  }

  std::size_t color_stride() const { return static_cast<std::size_t>(size_.width) + kernels::selective_block; }

  /// Row y of the frame, the colours from `begin` up to `end` taken apart into `colors_`, and what is known of it.
  template <int channels>
  SelectiveRow<channels> row(const cv::Mat& frame, cv::Mat& mask, int y, int begin, int end) {
    constexpr int block = kernels::selective_block;
    const int width = size_.width;
    const auto* const pixels = frame.ptr<std::uint8_t>(y);
    SelectiveRow<channels> row;
    // Whole blocks, moved to the left where the frame ends.
    const int length = std::min((end - begin + block - 1) / block * block, width);
    const auto first = static_cast<std::size_t>(std::min(begin, width - length));
    const auto count = static_cast<std::size_t>(length);
    if constexpr (channels == 3) {
      for (int c = 0; c < channels; ++c) row.frame[c] = colors_.data() + static_cast<std::size_t>(c) * color_stride();
      std::uint8_t* const blue = colors_.data() + first;
      kernels::split_colors(pixels + 3 * first, blue, blue + color_stride(), blue + 2 * color_stride(), count);
    } else if (end + block <= width) {
      row.frame[0] = pixels;
    } else {
      std::copy_n(pixels + first, count, colors_.data() + first);
      row.frame[0] = colors_.data();
    }
    std::int16_t* const levels = levels_.data() + offset(y, channels + 1);
    std::uint8_t* const candidate = candidates_.data() + offset(y, channels);
    for (int c = 0; c < channels; ++c) {
      row.background[c] = levels + c * width;
      row.candidate[c] = candidate + c * width;
    }
    row.deviation = levels + channels * width;
    row.age_ms = ages_ms_.data() + offset(y, 1);
    row.mask = mask.ptr<std::uint8_t>(y);
    row.count = static_cast<std::size_t>(width);
    return row;
  }

  void find_kept(const std::vector<Box>& places) {
    kept_.clear();
    for (const Box& place : places) {
      const cv::Rect rect = pixel_rect(place, size_);
      if (!rect.empty()) kept_.push_back(rect);
    }
  }

  void find_kept_columns(int y) {
    kept_columns_.clear();
    for (const cv::Rect& rect : kept_) {
      if (y >= rect.y && y < rect.y + rect.height) kept_columns_.emplace_back(rect.x, rect.x + rect.width);
    }
  }

  /// Pixels of one row up to `end` that are all learned or all kept.
  struct Stretch {
    int end;
    bool kept;
  };

  /// The one that begins at x in the row of `kept_columns_`.
  Stretch stretch_at(int x) const {
    Stretch stretch{size_.width, false};
    for (const cv::Range& kept : kept_columns_) {
      if (x >= kept.end) continue;
      if (x < kept.start) {
        if (!stretch.kept) stretch.end = std::min(stretch.end, kept.start);
      } else {
        stretch = {stretch.kept ? std::max(stretch.end, kept.end) : kept.end, true};
      }
    }
    return stretch;
  }

  SelectiveOptions options_;
  cv::Size size_;
  int channels_ = 0;  ///< 0: no frame yet
  double start_s_ = 0.0;
  double previous_s_ = 0.0;
  double unlearned_s_ = 0.0;              ///< time whose movement was too small to make
  std::vector<std::int16_t> levels_;      ///< for each row: background by channel, deviation
  std::vector<std::uint8_t> candidates_;  ///< for each row: by channel
  std::vector<std::uint16_t> ages_ms_;
  std::vector<std::uint8_t> colors_;      ///< one row of the frame: blue, green, red
  std::vector<cv::Rect> kept_;
  std::vector<cv::Range> kept_columns_;   ///< of one row
  ReadPlan whole_;
};

}  // namespace

std::unique_ptr<Segmenter> make_model(const SelectiveOptions& options) {
  check_fields(options);
  return std::make_unique<SelectiveSegmenter>(options);
}

}  // namespace survtrack
