// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <memory>
#include <opencv2/core/mat.hpp>
#include <optional>
#include <vector>

#include "survtrack/blobs/blob_extractor.hpp"
#include "survtrack/core/detection.hpp"
#include "survtrack/core/expectation.hpp"
#include "survtrack/pipeline/config.hpp"
#include "survtrack/segmentation/cleanup.hpp"
#include "survtrack/segmentation/scene_change.hpp"
#include "survtrack/segmentation/segmenter.hpp"

namespace survtrack {

/// A frame with its place in the source.
struct TimedFrame {
  cv::Mat image;
  std::int64_t index = 0;
  double time_s = 0.0;
};

/// The first half: frame in, detections out (segmentation, cleanup, blobs). Usable alone, with detections
/// going to another tracker. Options used: `scene_change`, `segmenter`, `cleanup`, `blobs`, `regions`,
/// `appearance`, `outputs`.
class Detector {
 public:
  /// Throws `ConfigError`.
  explicit Detector(const Config& config = {});

  /// Frames by which detections come late: the background model's look-ahead.
  int delay_frames() const { return segmenter_->delay_frames(); }

  /// Frame in, detections out; nothing while a delayed model fills. `image`: HxW or HxWx3 (BGR) uint8,
  /// all of one size; `time_s` increases; `index` increases and counts on from the last by default.
  /// Throws `InputError` and then keeps its state.
  /// `keep`: places that the background must not learn in the frame that is due. `regions`: where to look in it; none:
  /// everywhere.
  std::optional<Detections> process(const cv::Mat& image, double time_s, std::optional<std::int64_t> index = {},
                                    const std::vector<Box>& keep = {}, const std::vector<Box>& regions = {});

  /// The rest of a delayed model, in order. After it only `reset` is allowed.
  std::vector<Detections> finish();

  /// The background picture to start from, for segmenter.model static_reference with source picture: HxW or HxWx3
  /// (BGR) uint8 of the frames' size, copied. Before the first frame; it outlives `reset`. Throws `InputError`.
  void load_background(const cv::Mat& picture);

  /// The background is learned anew from the coming frames, on demand: a person says that the scene changed.
  void relearn_background();

  /// Forgets everything but a picture that was loaded; options stay.
  void reset();

  /// The steps of `process`, for loops that feed an expectation back: queue a frame (true when one is due),
  /// look at the one due, and detect in it, reusing the memory of `detections`.
  bool push(const cv::Mat& image, double time_s, std::optional<std::int64_t> index = {});
  void end_of_source() { ended_ = true; }
  bool due() const;
  /// Throws `InputError` when none is due.
  const TimedFrame& next() const;
  /// The expectation is for the time of `next()`. Throws `InputError` when it is not, or when it names regions
  /// and the background model reads whole frames, or a region wholly outside of the frame. Where it names some, only
  /// they are read, and with `regions.model = predicted` a strip in turn; the frame is read whole when the background
  /// model starts, when about all would be read, and after a strip that was mostly foreground.
  void detect(const Expectation& expectation, Detections& detections);

 private:
  bool watch(const TimedFrame& frame, std::vector<Event>& events);
  void push_waiting();
  void segment(const TimedFrame& frame, const Expectation& expectation, Detections& detections);
  void plan(const cv::Size& size, double time_s, const Expectation& expectation, std::vector<Region>& regions);
  void add_strip(const cv::Size& size, double time_s, std::vector<Region>& regions);

  OutputOptions outputs_;
  SceneAction scene_action_ = SceneAction::report;
  double relearn_s_ = 0.0;
  std::optional<SceneGuard> guard_;
  bool black_ = false;                     ///< the frame is black: the background model does not see it
  std::optional<double> learning_until_s_;  ///< masks are empty before this time
  std::optional<PredictedRegionsOptions> regions_;
  ReadPlan plan_;
  std::vector<double> strip_read_s_;  ///< when each strip was last read
  std::size_t strip_ = 0;             ///< the next one
  cv::Range strip_rows_{0, 0};        ///< of the present one; none in whole frames
  bool flooded_ = false;              ///< most of the last strip was foreground
  bool look_at_all_ = false;          ///< and so the next is read whole
  std::unique_ptr<Segmenter> segmenter_;
  Cleanup cleanup_;
  BlobExtractor blobs_;
  bool histograms_ = false;
  std::vector<TimedFrame> queue_;  ///< those that wait, oldest first
  cv::Size size_;
  int channels_ = 0;
  std::int64_t last_index_ = -1;
  std::optional<double> last_time_s_;
  bool ended_ = false;
};

}  // namespace survtrack
