// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "segmentation/normalized_difference.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <opencv2/imgproc.hpp>
#include <optional>
#include <vector>

#include "segmentation/local_difference.hpp"
#include "segmentation/pixel_rect.hpp"
#include "survtrack/core/checks.hpp"

namespace survtrack {
namespace {

constexpr int least_side_px = 8;

class NormalizedDifferenceSegmenter final : public Segmenter {
 public:
  explicit NormalizedDifferenceSegmenter(const NormalizedDifferenceOptions& options) : options_(options) {}

  void segment(const cv::Mat& frame, const Expectation& expectation, cv::Mat& mask,
               std::vector<Event>& /*raises none*/) override {
    check_image(frame);
    if (frames_ != 0) check_same_format(frame, size_, channels_);
    check_time(expectation.time_s, frames_ != 0 ? std::optional(previous_s_) : std::nullopt);
    if (frames_ == 0) start(frame, expectation.time_s);
    if (channels_ == 3) {
      cv::cvtColor(frame, now_, cv::COLOR_BGR2GRAY);
    } else {
      frame.copyTo(now_);
    }
    mask.create(size_, CV_8UC1);
    find_reference();
    if (reference_.empty()) {
      mask.setTo(0);
    } else {
      find_difference();
      threshold(mask);
    }
    learn(expectation);
    previous_s_ = expectation.time_s;
    ++frames_;
  }

  void background(cv::Mat& picture) const override {
    if (reference_.empty()) {
      picture.release();
    } else {
      reference_.copyTo(picture);
    }
  }

  void reset() override {
    frames_ = 0;
    reference_.release();
    history_.clear();
  }

 private:
  void start(const cv::Mat& frame, double time_s) {
    size_ = frame.size();
    channels_ = frame.channels();
    start_s_ = time_s;
    levels_ = 1;
    int side = std::min(size_.width, size_.height);
    while (levels_ < options_.levels && (side = (side + 1) / 2) >= least_side_px) ++levels_;
  }

  /// s(x, r); nothing while there is none.
  void find_reference() {
    if (options_.reference == DifferenceReference::running) {
      if (frames_ == 0) return;
      reference_.create(size_, CV_8UC1);
      for (int y = 0; y < size_.height; ++y) {
        const auto* const means = mean_.ptr<float>(y);
        auto* const levels = reference_.ptr<std::uint8_t>(y);
        for (int x = 0; x < size_.width; ++x) levels[x] = static_cast<std::uint8_t>(means[x] + 0.5F);
      }
    } else if (frames_ >= options_.frames_back) {
      reference_ = history_[static_cast<std::size_t>(frames_ % options_.frames_back)];
    }
  }

  /// From the coarsest level down; a high value replaces what is known from the level before (steps i to iii).
  void find_difference() {
    frames_by_level_.resize(static_cast<std::size_t>(levels_));
    references_by_level_.resize(frames_by_level_.size());
    frames_by_level_[0] = now_;
    references_by_level_[0] = reference_;
    for (std::size_t level = 1; level < frames_by_level_.size(); ++level) {
      cv::pyrDown(frames_by_level_[level - 1], frames_by_level_[level]);
      cv::pyrDown(references_by_level_[level - 1], references_by_level_[level]);
    }
    values_by_level_.resize(frames_by_level_.size());
    for (std::size_t level = frames_by_level_.size(); level-- > 0;) {
      cv::Mat& values = values_by_level_[level];
      local_.find(frames_by_level_[level], references_by_level_[level], options_.neighbourhood_px, options_.constant,
                  values);
      if (level + 1 < values_by_level_.size()) keep_what_is_not_high(values_by_level_[level + 1], values);
    }
  }

  void keep_what_is_not_high(const cv::Mat& coarser, cv::Mat& values) const {
    const auto high = static_cast<float>(options_.high);
    for (int y = 0; y < values.rows; ++y) {
      auto* const own = values.ptr<float>(y);
      const auto* const before = coarser.ptr<float>(y / 2);
      for (int x = 0; x < values.cols; ++x) own[x] = own[x] > high ? own[x] : before[x / 2];
    }
  }

  void threshold(cv::Mat& mask) const {
    const auto limit = static_cast<float>(options_.threshold);
    for (int y = 0; y < size_.height; ++y) {
      const auto* const values = values_by_level_[0].ptr<float>(y);
      auto* const pixels = mask.ptr<std::uint8_t>(y);
      for (int x = 0; x < size_.width; ++x) pixels[x] = values[x] > limit ? 255 : 0;
    }
  }

  void learn(const Expectation& expectation) {
    if (options_.reference == DifferenceReference::previous) {
      const auto slot = static_cast<std::size_t>(frames_ % options_.frames_back);
      if (slot == history_.size()) history_.emplace_back();
      // The oldest frame is the reference, whose pixels stay until the next one has another.
      now_.copyTo(spare_);
      std::swap(history_[slot], spare_);
      return;
    }
    if (frames_ == 0) {
      now_.convertTo(mean_, CV_32F);
      return;
    }
    // At first the plain mean of what was seen.
    const double elapsed_s = expectation.time_s - previous_s_;
    const double rate = elapsed_s / std::min(options_.update_time_s, std::max(expectation.time_s - start_s_, elapsed_s));
    const auto part = static_cast<float>(std::min(rate, 1.0));
    std::vector<cv::Rect> kept;
    std::vector<cv::Mat> before;
    for (const Box& place : expectation.keep) {
      const cv::Rect rect = pixel_rect(place, size_);
      if (rect.empty()) continue;
      kept.push_back(rect);
      before.push_back(mean_(rect).clone());
    }
    for (int y = 0; y < size_.height; ++y) {
      auto* const means = mean_.ptr<float>(y);
      const auto* const levels = now_.ptr<std::uint8_t>(y);
      for (int x = 0; x < size_.width; ++x) means[x] += part * (static_cast<float>(levels[x]) - means[x]);
    }
    for (std::size_t i = 0; i < kept.size(); ++i) before[i].copyTo(mean_(kept[i]));
  }

  NormalizedDifferenceOptions options_;
  cv::Size size_;
  int channels_ = 0;
  int levels_ = 1;
  std::int64_t frames_ = 0;  ///< since the last reset
  double start_s_ = 0.0;
  double previous_s_ = 0.0;
  cv::Mat now_;                   ///< the frame, grey
  cv::Mat reference_;             ///< empty while there is none
  cv::Mat mean_;                  ///< CV_32FC1, with the running reference
  std::vector<cv::Mat> history_;  ///< grey frames, a ring, with the previous one
  cv::Mat spare_;
  std::vector<cv::Mat> frames_by_level_;
  std::vector<cv::Mat> references_by_level_;
  LocalDifference local_;
  std::vector<cv::Mat> values_by_level_;
};

}  // namespace

std::unique_ptr<Segmenter> make_model(const NormalizedDifferenceOptions& options) {
  check_fields(options);
  return std::make_unique<NormalizedDifferenceSegmenter>(options);
}

}  // namespace survtrack
