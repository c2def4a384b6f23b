// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "survtrack/pipeline/pipeline.hpp"

#include <utility>

namespace survtrack {

Pipeline::Pipeline(const Config& config) : config_(config), detector_(config), tracker_(config) {}

Pipeline Pipeline::from_preset(const std::string& name) { return Pipeline(preset(name)); }

bool Pipeline::process(const cv::Mat& image, double time_s, FrameResult& result, std::optional<std::int64_t> index) {
  if (image.cols > 0 && image.rows > 0) tracker_.check_frame_size(image.cols, image.rows);
  if (!detector_.push(image, time_s, index)) return false;
  step(result);
  return true;
}

void Pipeline::step(FrameResult& result) {
  result.frame = detector_.next().image;
  const Expectation& expectation = tracker_.predict(detector_.next().time_s, result.frame.cols, result.frame.rows);
  detector_.detect(expectation, result.detections);
  tracker_.update(result.detections, result);
}

std::optional<FrameResult> Pipeline::process(const cv::Mat& image, double time_s, std::optional<std::int64_t> index) {
  FrameResult result;
  if (!process(image, time_s, result, index)) return std::nullopt;
  return result;
}

bool Pipeline::finish(FrameResult& result) {
  detector_.end_of_source();
  if (!detector_.due()) return false;
  step(result);
  return true;
}

std::vector<FrameResult> Pipeline::finish() {
  std::vector<FrameResult> rest;
  for (FrameResult result; finish(result); result = {}) rest.push_back(std::move(result));
  return rest;
}

void Pipeline::reset() {
  detector_.reset();
  tracker_.reset();
}

}  // namespace survtrack
