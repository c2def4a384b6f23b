// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "segmentation/selective.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "segmentation/kept_places.hpp"
#include "segmentation/selective_kernels.hpp"
#include "segmentation/selective_memory.hpp"
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
// Rows from where is read to where memory is asked for.
constexpr int ahead = 2;

int in_q(int bits, double value) { return static_cast<int>(std::lround(std::ldexp(value, bits))); }

class SelectiveSegmenter final : public Segmenter {
 public:
  explicit SelectiveSegmenter(const SelectiveOptions& options) : options_(options) {}

  bool reads_regions() const override { return true; }
  /// While the background is young each pixel's own mean is still forming, and what the first frame held by chance fades.
  bool needs_whole_frame() const override {
    return memory_.channels() == 0 || previous_s_ - start_s_ < young_updates * options_.update_time_s;
  }

  void segment(const cv::Mat& frame, const Expectation& expectation, cv::Mat& mask,
               std::vector<Event>& events) override {
    if (!whole_.whole() || whole_.size() != frame.size()) whole_.read_whole(frame.size());
    segment_regions(frame, expectation, whole_, mask, events);
  }

  void segment_regions(const cv::Mat& frame, const Expectation& expectation, const ReadPlan& plan, cv::Mat& mask,
                       std::vector<Event>& events) override {
    check_image(frame);
    if (memory_.channels() != 0) check_same_format(frame, memory_.size(), memory_.channels());
    check_time(expectation.time_s, memory_.channels() != 0 ? std::optional(previous_s_) : std::nullopt);
    if (frame.channels() == 3) {
      segment_channels<3>(frame, expectation, plan, mask, events);
    } else {
      segment_channels<1>(frame, expectation, plan, mask, events);
    }
    previous_s_ = expectation.time_s;
  }

  void background(cv::Mat& picture) const override {
    if (memory_.channels() == 0) {
      picture.release();
    } else {
      memory_.background(picture);
    }
  }

  void reset() override { memory_.forget(); }

 private:
  template <int channels>
  void segment_channels(const cv::Mat& frame, const Expectation& expectation, const ReadPlan& plan, cv::Mat& mask,
                        std::vector<Event>& events) {
    mask.create(frame.size(), CV_8UC1);
    if (memory_.channels() == 0) {
      memory_.allocate(frame.size(), channels);
      start<channels>(frame, expectation.time_s, mask);
      return;
    }
    kept_.set(expectation.keep, frame.size());
    const double differing = step<channels>(frame, plan, expectation.time_s, mask);
    const double part = differing / (static_cast<double>(frame.cols) * frame.rows);
    // Of a frame read in parts nobody knows the rest: the detector looks at the next one whole.
    if (!plan.whole() || part <= options_.scene_change_fraction) return;
    start<channels>(frame, expectation.time_s, mask);
    Event& event = events.emplace_back();
    event.kind = EventKind::scene_changed;
    event.text = "The scene changed: " + std::to_string(std::lround(100.0 * part)) +
                 " % of the frame differ from the background, which starts anew from this frame.";
  }

  template <int channels>
  void start(const cv::Mat& frame, double time_s, cv::Mat& mask) {
    start_s_ = time_s;
    unlearned_s_ = 0.0;
    for (int y = 0; y < frame.rows; ++y) kernels::selective_start(memory_.row<channels>(frame, mask, y, 0, frame.cols));
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
        kept_.enter_row(y);
        for (std::size_t i = band.first_span; i < band.last_span; ++i) {
          const ReadPlan::Span& span = plan.spans()[i];
          if (!plan.whole() && y + ahead < band.bottom) memory_.fetch(frame, mask, y + ahead, span.begin, span.end);
          differing += step_span(memory_.row<channels>(frame, mask, y, span.begin, span.end), span, span.refresh ? refresh : now);
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
      const KeptPlaces::Stretch stretch = kept_.stretch_at(x);
      const int end = std::min(stretch.end, span.end);
      step.learn = !stretch.kept;
      differing += kernels::selective_step(whole.part(static_cast<std::size_t>(x), static_cast<std::size_t>(end - x)), step);
      x = end;
    }
    return differing;
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

  SelectiveOptions options_;
  SelectiveMemory memory_;
  KeptPlaces kept_;
  double start_s_ = 0.0;
  double previous_s_ = 0.0;
  double unlearned_s_ = 0.0;              ///< time whose movement was too small to make
  ReadPlan whole_;
};

}  // namespace

std::unique_ptr<Segmenter> make_model(const SelectiveOptions& options) {
  check_fields(options);
  return std::make_unique<SelectiveSegmenter>(options);
}

}  // namespace survtrack
