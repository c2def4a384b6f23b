// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "survtrack/pipeline/detector.hpp"

#include <algorithm>
#include <opencv2/core.hpp>
#include <string>

#include "core/text_of.hpp"
#include "segmentation/pixel_rect.hpp"
#include "survtrack/core/checks.hpp"

namespace survtrack {
namespace {

void check_regions(const char* name, const std::vector<Region>& regions, const cv::Size& size, bool readable) {
  if (regions.empty()) return;
  if (!readable) throw InputError(std::string(name) + ": this background model reads whole frames; expected none");
  for (std::size_t i = 0; i < regions.size(); ++i) {
    const Box& box = regions[i].box;
    if (!pixel_rect(box, size).empty()) continue;
    throw InputError(std::string(name) + "[" + std::to_string(i) + "]: " +
                     text_of({box.x, box.y, box.width, box.height}) + " lies outside of the frame of " +
                     std::to_string(size.width) + "x" + std::to_string(size.height) + " px; expected one that meets it");
  }
}

}  // namespace

Detector::Detector(const Config& config)
    : outputs_(config.check().outputs),
      segmenter_(make_segmenter(config.segmenter)),
      cleanup_(config.cleanup),
      blobs_(config.blobs),
      histograms_(std::holds_alternative<ColorHistogramOptions>(config.appearance)) {
  if (const auto* predicted = std::get_if<PredictedRegionsOptions>(&config.regions)) regions_ = *predicted;
  if (const auto* guard = std::get_if<GuardOptions>(&config.scene_change)) {
    scene_action_ = guard->action;
    relearn_s_ = guard->relearn_s;
    guard_.emplace(*guard);
  }
}

void Detector::load_background(const cv::Mat& picture) {
  if (last_time_s_) throw InputError("background: came after the first frame; expected it before, or after reset()");
  segmenter_->load_background(picture);
}

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
  if (channels_ == 0) segmenter_->check_first(image);
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
  check_regions("expectation.regions", expectation.regions, next().image.size(), segmenter_->reads_regions());
  if (expectation.time_s != next().time_s) {
    throw InputError("expectation.time_s: " + text_of(expectation.time_s) + " is not the time of the frame that is due, " +
                     text_of(next().time_s));
  }
  const TimedFrame frame = queue_.front();
  queue_.erase(queue_.begin());
  detections.index = frame.index;
  detections.time_s = frame.time_s;
  detections.frame_width = frame.image.cols;
  detections.frame_height = frame.image.rows;
  detections.events.clear();
  const bool blank = watch(frame, detections.events);
  if (!black_ || !segmenter_->takes_gaps()) {
    segment(frame, expectation, detections);
  } else {
    detections.regions.clear();
    detections.pixels_read = 0;
  }
  if (blank) {
    detections.mask.create(frame.image.size(), CV_8UC1);
    detections.mask.setTo(0);
  }
  cleanup_.apply(detections.mask);
  blobs_.extract(detections.mask, frame.image, expectation, outputs_.contours, detections);
  detections.histograms.clear();
  if (histograms_) blobs_.histograms(frame.image, detections.histograms);
  if (outputs_.background) segmenter_->background(detections.background);
  if (outputs_.flow) segmenter_->flow(detections.flow);
  for (Event& event : detections.events) {
    event.index = frame.index;
    event.time_s = frame.time_s;
  }
}

/// Looks at the scene as a whole. Returns whether the mask must be empty, whatever the background model says.
bool Detector::watch(const TimedFrame& frame, std::vector<Event>& events) {
  black_ = false;
  if (!guard_) return false;
  const SceneLook look = guard_->look(frame.image, frame.time_s);
  black_ = look.black && scene_action_ != SceneAction::report;
  if (look.change) {
    Event& event = events.emplace_back();
    event.kind = EventKind::scene_changed;
    event.text = describe(*look.change, scene_action_);
    if (!look.black && scene_action_ != SceneAction::report) {
      segmenter_->relearn();
      segmenter_->push(frame.image);
      push_waiting();
      if (scene_action_ == SceneAction::relearn) learning_until_s_ = frame.time_s + relearn_s_;
      return true;
    }
  }
  if (learning_until_s_ && frame.time_s >= *learning_until_s_) learning_until_s_.reset();
  return black_ || learning_until_s_;
}

void Detector::relearn_background() {
  segmenter_->relearn();
  push_waiting();
}

/// Models with a look-ahead were shown the frames that wait: they see them again.
void Detector::push_waiting() {
  for (const TimedFrame& waiting : queue_) segmenter_->push(waiting.image);
}

std::optional<Detections> Detector::process(const cv::Mat& image, double time_s, std::optional<std::int64_t> index,
                                            const std::vector<Box>& keep, const std::vector<Box>& regions) {
  Expectation expectation;
  expectation.keep = keep;
  expectation.only_regions = !regions.empty();
  for (const Box& box : regions) expectation.regions.push_back({box, RegionKind::predicted, 0});
  // Before the frame is taken, so that it can be given again.
  check_image(image);
  check_regions("regions", expectation.regions, image.size(), segmenter_->reads_regions());
  if (!push(image, time_s, index)) return std::nullopt;
  expectation.time_s = next().time_s;
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
  if (guard_) guard_->reset();
  black_ = false;
  learning_until_s_.reset();
  cleanup_.reset();
  queue_.clear();
  channels_ = 0;
  last_index_ = -1;
  last_time_s_.reset();
  ended_ = false;
  strip_read_s_.clear();
  strip_ = 0;
  flooded_ = look_at_all_ = false;
}

}  // namespace survtrack
