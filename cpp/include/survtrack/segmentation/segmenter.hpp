// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <memory>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "survtrack/core/event.hpp"
#include "survtrack/core/expectation.hpp"
#include "survtrack/segmentation/options.hpp"
#include "survtrack/segmentation/read_plan.hpp"

namespace survtrack {

/// A background model: frame in, foreground mask out. All frames of one run have one size and
/// channel count; `push` and `segment` are called by `Detector`, which has checked them.
class Segmenter {
 public:
  virtual ~Segmenter() = default;

  /// Frames that must be pushed beyond the one that is segmented.
  virtual int delay_frames() const { return 0; }

  /// Shows the model the newest frame, ahead of `segment` by `delay_frames()`, fewer at the end.
  virtual void push(const cv::Mat& frame) { static_cast<void>(frame); }

  /// Segments `frame` (the oldest one pushed and not yet segmented) into `mask` (CV_8UC1, 0 or 255,
  /// reallocated only when its size differs) and learns from it. The input is left alone.
  virtual void segment(const cv::Mat& frame, const Expectation& expectation, cv::Mat& mask,
                       std::vector<Event>& events) = 0;

  /// Whether the model can read parts of a frame. Its options say the same by `reads_regions`, for the check of a config.
  virtual bool reads_regions() const { return false; }
  /// Whether the coming frame must be read whole because the model starts to learn.
  virtual bool needs_whole_frame() const { return true; }
  /// The same as `segment` of the pixels in `plan` only; elsewhere the mask is 0 and nothing is learned. Comes
  /// only when the model reads regions and does not need the whole frame.
  virtual void segment_regions(const cv::Mat& frame, const Expectation& expectation, const ReadPlan& plan, cv::Mat& mask,
                               std::vector<Event>& events);

  /// The background picture as known after the last `segment`, of the frame's size; CV_8UC1 or CV_8UC3.
  /// Empty before the first, and always for a model that has none.
  virtual void background(cv::Mat& picture) const = 0;

  /// The flow field of the last `segment`: CV_32FC2 of the frame's size, px to the right and down. Empty while
  /// there is none, and always for a model that finds none.
  virtual void flow(cv::Mat& field) const { field.release(); }

  /// The background picture to start from, of the frames' size and channel count; before the first frame. It is
  /// copied and outlives `reset`. Throws `InputError` for a model or options that take none, and for no image.
  virtual void load_background(const cv::Mat& picture);

  /// Throws `InputError` when a run cannot start with this frame: a picture is missing, or is of another format.
  virtual void check_first(const cv::Mat& frame) const { static_cast<void>(frame); }

  /// Whether frames may be left out between two that are segmented. False: every frame that is pushed must be.
  virtual bool takes_gaps() const { return delay_frames() == 0; }

  /// The scene changed: learns the background anew from the coming frames; frames that were pushed and not yet
  /// segmented are pushed again.
  virtual void relearn() { reset(); }

  /// Forgets everything but a picture that was loaded: the next frame is a first frame.
  virtual void reset() = 0;
};

/// Throws `ConfigError` for options out of their ranges.
std::unique_ptr<Segmenter> make_segmenter(const SegmenterOptions& options);

}  // namespace survtrack
