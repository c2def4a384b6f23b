// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "survtrack/pipeline/detector.hpp"

#include <string>

#include "survtrack/core/checks.hpp"

namespace survtrack {

Detector::Detector(const Config& config)
    : outputs_(config.check().outputs),
      segmenter_(make_segmenter(config.segmenter)),
      cleanup_(config.cleanup),
      blobs_(config.blobs) {}

bool Detector::push(const cv::Mat& image, double time_s, std::optional<std::int64_t> index) {
  if (ended_) throw InputError("frame: came after finish(); reset() starts another run");
  if (due()) throw InputError("frame: came before detect() of the one that is due");
  check_image(image);
  if (channels_ != 0) check_same_format(image, size_, channels_);
  check_time(time_s, last_time_s_);
  const std::int64_t next_index = index.value_or(last_index_ + 1);
  constexpr std::int64_t largest_index = std::int64_t{1} << 53;  // exact in every file format
  if (next_index < 0 || next_index > largest_index) {
    throw InputError("index: " + std::to_string(next_index) + " is not allowed; expected 0 to 2^53");
  }
  if (next_index <= last_index_) {
    throw InputError("index: " + std::to_string(next_index) + " does not come after " + std::to_string(last_index_) +
                     ", the index of the frame before; indices must increase");
  }
  size_ = image.size();
  channels_ = image.channels();
  last_time_s_ = time_s;
  last_index_ = next_index;
  segmenter_->push(image);
  // A frame that must wait is copied, as its pixels are the caller's to reuse.
  queue_.push_back({delay_frames() == 0 ? image : image.clone(), next_index, time_s});
  return due();
}

bool Detector::due() const {
  return !queue_.empty() && (ended_ || queue_.size() > static_cast<std::size_t>(delay_frames()));
}

const TimedFrame& Detector::next() const {
  if (!due()) throw InputError("frame: none is due; expected push() of one before");
  return queue_.front();
}

void Detector::detect(const Expectation& expectation, Detections& detections) {
  if (!expectation.regions.empty()) {
    throw InputError("expectation.regions: this background model reads whole frames; expected none");
  }
  if (expectation.time_s != next().time_s) {
    throw InputError("expectation.time_s: " + std::to_string(expectation.time_s) + " is not the time of the frame that is due, " +
                     std::to_string(next().time_s));
  }
  const TimedFrame frame = queue_.front();
  queue_.erase(queue_.begin());
  detections.index = frame.index;
  detections.time_s = frame.time_s;
  detections.frame_width = frame.image.cols;
  detections.frame_height = frame.image.rows;
  detections.events.clear();
  detections.regions.assign(1, Box{0.0, 0.0, static_cast<double>(frame.image.cols), static_cast<double>(frame.image.rows)});
  segmenter_->segment(frame.image, expectation, detections.mask, detections.events);
  cleanup_.apply(detections.mask);
  blobs_.extract(detections.mask, frame.image, expectation, outputs_.contours, detections);
  if (outputs_.background) segmenter_->background(detections.background);
  if (outputs_.flow) segmenter_->flow(detections.flow);
  for (Event& event : detections.events) {
    event.index = frame.index;
    event.time_s = frame.time_s;
  }
}

std::optional<Detections> Detector::process(const cv::Mat& image, double time_s, std::optional<std::int64_t> index,
                                            const std::vector<Box>& keep) {
  if (!push(image, time_s, index)) return std::nullopt;
  Expectation expectation;
  expectation.time_s = next().time_s;
  expectation.keep = keep;
  Detections detections;
  detect(expectation, detections);
  return detections;
}

std::vector<Detections> Detector::finish() {
  end_of_source();
  std::vector<Detections> rest;
  while (due()) {
    Expectation expectation;
    expectation.time_s = next().time_s;
    detect(expectation, rest.emplace_back());
  }
  return rest;
}

void Detector::reset() {
  segmenter_->reset();
  cleanup_.reset();
  queue_.clear();
  channels_ = 0;
  last_index_ = -1;
  last_time_s_.reset();
  ended_ = false;
}

}  // namespace survtrack
