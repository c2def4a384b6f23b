// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "segmentation/moving_average.hpp"

#include <cmath>
#include <cstdint>
#include <opencv2/imgproc.hpp>
#include <stdexcept>

#include "segmentation/moving_average_kernels.hpp"
#include "segmentation/pixel_rect.hpp"
#include "survtrack/core/checks.hpp"

namespace survtrack {
namespace {

/// The greatest integer d with d / frames <= threshold: |mean - level| > threshold exactly when
/// |sum - frames level| > d.
int difference_limit(double threshold, int frames) {
  const auto within = [&](int difference) { return static_cast<double>(difference) / frames <= threshold; };
  const int limit = static_cast<int>(threshold * frames);  // rounding may put it one off
  if (!within(limit)) return limit - 1;
  return within(limit + 1) ? limit + 1 : limit;
}

/// `Sum`: see moving_average_kernels.hpp. Frames are counted from 0 since the last reset; the window's
/// sum holds the frames from `dropped_` to `added_` - 1.
template <class Sum>
class MovingAverageSegmenter final : public Segmenter {
 public:
  explicit MovingAverageSegmenter(const MovingAverageOptions& options)
      : options_(options),
        ahead_(options.window == Window::centred ? options.window_frames / 2 : 0),
        behind_(options.window == Window::centred ? ahead_ : options.window_frames - 1),
        // One frame more than the window: it leaves in the same pass in which the newest enters.
        history_(static_cast<std::size_t>(ahead_ + behind_ + 2)) {}

  int delay_frames() const override { return ahead_; }
  bool takes_gaps() const override { return false; }

  void push(const cv::Mat& frame) override {
    check_image(frame);
    if (pushed_ == 0) {
      start(frame.size());
    } else {
      check_same_format(frame, size_, frame.channels());
    }
    if (pushed_ > segmented_ + ahead_) throw std::logic_error("push: delay_frames() frames wait to be segmented");
    add_pending();
    cv::Mat& grey = history_[slot(pushed_++)];
    if (frame.channels() == 3) {
      cv::cvtColor(frame, grey, cv::COLOR_BGR2GRAY);
    } else {
      frame.copyTo(grey);
    }
  }

  void segment(const cv::Mat& /*pushed before*/, const Expectation& expectation, cv::Mat& mask,
               std::vector<Event>& /*raises none*/) override {
    if (segmented_ == pushed_) throw std::logic_error("segment: no frame was pushed");
    if (segmented_ == 0) {
      add_pending();
      if (options_.secondary_background) mean(secondary_);  // eq. 3.3
    }
    mask.create(size_, CV_8UC1);
    copy_places(secondary_, kept_, expectation.keep);
    step(mask);
    copy_places(kept_, secondary_, expectation.keep);
    ++segmented_;
  }

  void background(cv::Mat& picture) const override {
    if (segmented_ == 0) {
      picture.release();
    } else {
      mean(picture);
    }
  }

  void reset() override { pushed_ = added_ = dropped_ = segmented_ = 0; }

 private:
  std::size_t slot(std::int64_t frame) const { return static_cast<std::size_t>(frame) % history_.size(); }
  const std::uint8_t* grey(std::int64_t frame) const { return history_[slot(frame)].template ptr<std::uint8_t>(); }
  int frames() const { return static_cast<int>(added_ - dropped_); }

  void start(const cv::Size& size) {
    size_ = size;
    sum_.assign(size.area(), 0);
    nothing_.assign(size.area(), 0);
    if (!options_.secondary_background) return;
    secondary_.create(size, CV_8UC1);
    kept_.create(size, CV_8UC1);
  }

  /// Frames pushed ahead of the first `segment` enter the sum one by one, without the fused step.
  void add_pending() {
    if (added_ < pushed_) kernels::add_frame(sum_.data(), grey(added_++), sum_.size());
  }

  void step(cv::Mat& mask) {
    const std::uint8_t* const added = added_ < pushed_ ? grey(added_++) : nothing_.data();
    const std::uint8_t* const dropped = dropped_ < segmented_ - behind_ ? grey(dropped_++) : nothing_.data();
    const bool whole = mask.isContinuous();
    const std::size_t count = whole ? sum_.size() : static_cast<std::size_t>(size_.width);
    for (int row = 0; row < (whole ? 1 : size_.height); ++row) {
      const std::size_t offset = static_cast<std::size_t>(row) * count;
      kernels::moving_average_step<Sum>({
          .sum = sum_.data() + offset,
          .added = added + offset,
          .dropped = dropped + offset,
          .frame = grey(segmented_) + offset,
          .secondary = options_.secondary_background ? secondary_.ptr<std::uint8_t>() + offset : nullptr,
          .mask = mask.ptr<std::uint8_t>(row),
          .count = count,
          .frames = frames(),
          .limit = difference_limit(options_.threshold, frames()),
          .secondary_limit = static_cast<int>(std::floor(options_.secondary_threshold)),
      });
    }
  }

  void mean(cv::Mat& picture) const {
    picture.create(size_, CV_8UC1);
    for (int row = 0; row < size_.height; ++row) {
      const std::size_t width = static_cast<std::size_t>(size_.width);
      kernels::mean_of_sum(sum_.data() + static_cast<std::size_t>(row) * width, frames(),
                           picture.ptr<std::uint8_t>(row), width);
    }
  }

  void copy_places(const cv::Mat& from, cv::Mat& to, const std::vector<Box>& places) const {
    if (!options_.secondary_background) return;
    for (const Box& place : places) {
      const cv::Rect rect = pixel_rect(place, size_);
      if (!rect.empty()) from(rect).copyTo(to(rect));
    }
  }

  MovingAverageOptions options_;
  int ahead_;
  int behind_;
  std::vector<cv::Mat> history_;  ///< grey, a ring
  std::int64_t pushed_ = 0;
  std::int64_t added_ = 0;
  std::int64_t dropped_ = 0;
  std::int64_t segmented_ = 0;
  cv::Size size_;
  std::vector<Sum> sum_;
  std::vector<std::uint8_t> nothing_;  ///< zeros: the frame that enters or leaves when none does
  cv::Mat secondary_;
  cv::Mat kept_;  ///< `secondary_` as it was, in the places not to learn
};

}  // namespace

std::unique_ptr<Segmenter> make_model(const MovingAverageOptions& options) {
  check_fields(options);
  // A centred window of N holds up to 2 (N/2) + 1 frames.
  if (options.window_frames + 1 <= kernels::most_frames_in_16_bits) {
    return std::make_unique<MovingAverageSegmenter<std::uint16_t>>(options);
  }
  return std::make_unique<MovingAverageSegmenter<std::uint32_t>>(options);
}

}  // namespace survtrack
