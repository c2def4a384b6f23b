// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "segmentation/static_reference.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "segmentation/static_reference_kernels.hpp"
#include "survtrack/core/checks.hpp"

namespace survtrack {
namespace {

using kernels::StaticReferenceRow;

/// The greatest whole d with d / parts <= threshold: |sum / parts - level| > threshold exactly when
/// |sum - parts level| > d.
int difference_limit(double threshold, int parts) {
  const auto within = [&](int difference) { return static_cast<double>(difference) / parts <= threshold; };
  const int limit = static_cast<int>(threshold * parts);  // rounding may put it one off
  if (!within(limit)) return limit - 1;
  return within(limit + 1) ? limit + 1 : limit;
}

/// A quotient rounded upwards, of a divisor above 0.
int divided_up(int value, int divisor) { return value <= 0 ? 0 : (value + divisor - 1) / divisor; }

std::string format_of(const cv::Mat& image) {
  return std::to_string(image.rows) + "x" + std::to_string(image.cols) + (image.channels() == 3 ? "x3" : "");
}

class StaticReferenceSegmenter final : public Segmenter {
 public:
  explicit StaticReferenceSegmenter(const StaticReferenceOptions& options) : options_(options) {}

  void load_background(const cv::Mat& picture) override {
    if (options_.source != ReferenceSource::picture) {
      throw InputError("background: segmenter.source takes the first frames and no picture; expected segmenter.source "
                       "picture");
    }
    check_image(picture, "background");
    given_ = picture.clone();
  }

  void check_first(const cv::Mat& frame) const override {
    if (options_.source != ReferenceSource::picture) return;
    if (given_.empty()) {
      throw InputError("background: segmenter.source is \"picture\" and none was given; expected a picture before the "
                       "first frame (load_background, --background)");
    }
    if (given_.size() == frame.size() && given_.channels() == frame.channels()) return;
    throw InputError("background: the picture is " + format_of(given_) + ", the frame " + format_of(frame) +
                     "; expected the same size and channel count");
  }

  bool reads_regions() const override { return true; }
  bool needs_whole_frame() const override { return channels_ == 0 || !complete_; }

  void segment_regions(const cv::Mat& frame, const Expectation& /*learns nothing of places*/, const ReadPlan& plan,
                       cv::Mat& mask, std::vector<Event>& /*raises none*/) override {
    check_image(frame);
    check_same_format(frame, size_, channels_);
    mask.create(size_, CV_8UC1);
    mask.setTo(0);
    if (channels_ == 3) {
      compare<3>(frame, plan, mask);
    } else {
      compare<1>(frame, plan, mask);
    }
  }

  void segment(const cv::Mat& frame, const Expectation& /*learns nothing of places*/, cv::Mat& mask,
               std::vector<Event>& /*raises none*/) override {
    check_image(frame);
    if (channels_ == 0) {
      check_first(frame);
      start(frame);
    } else {
      check_same_format(frame, size_, channels_);
    }
    mask.create(size_, CV_8UC1);
    if (!complete_) {
      collect(frame);
      mask.setTo(0);
    } else if (channels_ == 3) {
      compare<3>(frame, mask);
    } else {
      compare<1>(frame, mask);
    }
  }

  void background(cv::Mat& picture) const override {
    if (channels_ == 0) {
      picture.release();
    } else if (complete_) {
      picture_.copyTo(picture);
    } else {
      reference(picture, {});
    }
  }

  void relearn() override {
    if (channels_ == 0) return;
    source_ = options_.source == ReferenceSource::mean ? ReferenceSource::mean : ReferenceSource::median;
    begin_collection();
  }

  void reset() override { channels_ = 0; }

 private:
  struct Bounds {
    std::vector<std::uint8_t>* low = nullptr;
    std::vector<std::uint8_t>* high = nullptr;
  };

  void start(const cv::Mat& frame) {
    size_ = frame.size();
    channels_ = frame.channels();
    source_ = options_.source;
    const std::size_t levels = frame.total() * static_cast<std::size_t>(channels_);
    low_.resize(levels);
    high_.resize(levels);
    begin_collection();
    if (source_ != ReferenceSource::picture) return;
    collected_.push_back(given_);
    finish_collection();
  }

  void begin_collection() {
    complete_ = false;
    collected_.clear();
    sums_.assign(source_ == ReferenceSource::mean ? low_.size() : 0, 0);
    summed_ = 0;
  }

  void collect(const cv::Mat& frame) {
    if (source_ == ReferenceSource::mean) {
      const std::size_t in_row = static_cast<std::size_t>(size_.width) * static_cast<std::size_t>(channels_);
      for (int y = 0; y < size_.height; ++y) {
        const auto* const levels = frame.ptr<std::uint8_t>(y);
        int* const sums = sums_.data() + static_cast<std::size_t>(y) * in_row;
        for (std::size_t i = 0; i < in_row; ++i) sums[i] += levels[i];
      }
      ++summed_;
    } else {
      collected_.push_back(frame.clone());
      summed_ = static_cast<int>(collected_.size());
    }
    if (summed_ == options_.frames) finish_collection();
  }

  void finish_collection() {
    reference(picture_, {&low_, &high_});
    complete_ = true;
    collected_.clear();
    sums_.clear();
  }

  /// The reference of what is collected as a picture, rounded, halves upwards; and its levels, which are exact.
  void reference(cv::Mat& picture, const Bounds& bounds) const {
    picture.create(size_, CV_8UC(channels_));
    const auto width = static_cast<std::size_t>(size_.width);
    const auto channels = static_cast<std::size_t>(channels_);
    const int parts = source_ == ReferenceSource::mean ? summed_ : 2;
    std::vector<std::uint8_t> levels(collected_.size());
    int limits[3];
    for (std::size_t c = 0; c < channels; ++c) limits[c] = difference_limit(threshold(c), parts);
    for (int y = 0; y < size_.height; ++y) {
      auto* const pixels = picture.ptr<std::uint8_t>(y);
      const std::size_t row = static_cast<std::size_t>(y) * width * channels;
      for (std::size_t x = 0; x < width; ++x) {
        for (std::size_t c = 0; c < channels; ++c) {
          const std::size_t i = x * channels + c;
          const int sum = source_ == ReferenceSource::mean ? sums_[row + i] : twice_median(y, i, levels);
          pixels[i] = static_cast<std::uint8_t>((2 * sum + parts) / (2 * parts));
          if (bounds.low == nullptr) continue;
          const std::size_t planar = row + c * width + x;
          (*bounds.low)[planar] = static_cast<std::uint8_t>(divided_up(sum - limits[c], parts));
          (*bounds.high)[planar] = static_cast<std::uint8_t>(std::min((sum + limits[c]) / parts, 255));
        }
      }
    }
  }

  /// The sum of the two middle ones, which of an odd number are one.
  int twice_median(int y, std::size_t i, std::vector<std::uint8_t>& levels) const {
    for (std::size_t k = 0; k < levels.size(); ++k) levels[k] = collected_[k].ptr<std::uint8_t>(y)[i];
    const auto middle = levels.begin() + static_cast<std::ptrdiff_t>(levels.size() / 2);
    std::nth_element(levels.begin(), middle, levels.end());
    const int upper = *middle;
    return upper + (levels.size() % 2 == 1 ? upper : *std::max_element(levels.begin(), middle));
  }

  double threshold(std::size_t channel) const {
    if (channels_ == 1) return options_.threshold_grey;
    return channel == 0 ? options_.threshold_blue : channel == 1 ? options_.threshold_green : options_.threshold_red;
  }

  template <int channels>
  void compare(const cv::Mat& frame, cv::Mat& mask) const {
    for (int y = 0; y < size_.height; ++y) kernels::static_reference_step(row<channels>(frame, mask, y));
  }

  template <int channels>
  void compare(const cv::Mat& frame, const ReadPlan& plan, cv::Mat& mask) const {
    for (const ReadPlan::Band& band : plan.bands()) {
      for (int y = band.top; y < band.bottom; ++y) {
        const StaticReferenceRow<channels> whole = row<channels>(frame, mask, y);
        for (std::size_t i = band.first_span; i < band.last_span; ++i) {
          const ReadPlan::Span& span = plan.spans()[i];
          kernels::static_reference_step(
              whole.part(static_cast<std::size_t>(span.begin), static_cast<std::size_t>(span.end - span.begin)));
        }
      }
    }
  }

  /// Row y of the frame and its levels; `part` of it is a row too.
  template <int channels>
  StaticReferenceRow<channels> row(const cv::Mat& frame, cv::Mat& mask, int y) const {
    const auto width = static_cast<std::size_t>(size_.width);
    const std::size_t first = static_cast<std::size_t>(y) * width * channels;
    StaticReferenceRow<channels> row;
    row.frame = frame.ptr<std::uint8_t>(y);
    for (std::size_t c = 0; c < channels; ++c) {
      row.low[c] = low_.data() + first + c * width;
      row.high[c] = high_.data() + first + c * width;
    }
    row.mask = mask.ptr<std::uint8_t>(y);
    row.count = width;
    return row;
  }

  StaticReferenceOptions options_;
  cv::Mat given_;  ///< the picture that was loaded
  cv::Size size_;
  int channels_ = 0;                                ///< 0: no frame yet
  ReferenceSource source_ = ReferenceSource::mean;  ///< of the present reference
  bool complete_ = false;
  std::vector<cv::Mat> collected_;  ///< frames whose median is wanted
  std::vector<int> sums_;           ///< of frames whose mean is wanted, interleaved as they are
  int summed_ = 0;
  cv::Mat picture_;
  std::vector<std::uint8_t> low_;  ///< for each row: by channel
  std::vector<std::uint8_t> high_;
};

}  // namespace

std::unique_ptr<Segmenter> make_model(const StaticReferenceOptions& options) {
  check_fields(options);
  return std::make_unique<StaticReferenceSegmenter>(options);
}

}  // namespace survtrack
