// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "segmentation/horn_schunck_segmenter.hpp"

#include <cstdint>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "segmentation/flow_solver.hpp"
#include "survtrack/core/checks.hpp"

namespace survtrack {
namespace {

class HornSchunckSegmenter final : public Segmenter {
 public:
  explicit HornSchunckSegmenter(const HornSchunckOptions& options)
      : options_(options), history_(static_cast<std::size_t>(options.frames_back) + 1) {}

  void segment(const cv::Mat& frame, const Expectation& /*learns nothing*/, cv::Mat& mask,
               std::vector<Event>& /*raises none*/) override {
    check_image(frame);
    if (frames_ != 0) check_same_format(frame, size_, channels_);
    size_ = frame.size();
    channels_ = frame.channels();
    cv::Mat& now = history_[static_cast<std::size_t>(frames_) % history_.size()];
    if (channels_ == 3) {
      cv::cvtColor(frame, now, cv::COLOR_BGR2GRAY);
    } else {
      frame.copyTo(now);
    }
    ++frames_;
    mask.create(size_, CV_8UC1);
    if (has_flow()) {
      // The ring holds a frame more than N: the oldest one is next to be overwritten.
      find_flow(history_[static_cast<std::size_t>(frames_) % history_.size()], now);
      threshold(mask);
    } else {
      mask.setTo(0);
    }
  }

  /// It has none.
  void background(cv::Mat& picture) const override { picture.release(); }

  void flow(cv::Mat& field) const override {
    if (!has_flow()) {
      field.release();
      return;
    }
    field.create(size_, CV_32FC2);
    for (int y = 0; y < size_.height; ++y) {
      auto* const vectors = field.ptr<float>(y);
      for (int x = 0; x < size_.width; ++x) {
        vectors[2 * x] = flow_.u.row(y)[x];
        vectors[2 * x + 1] = flow_.v.row(y)[x];
      }
    }
  }

  void reset() override { frames_ = 0; }

 private:
  bool has_flow() const { return frames_ > options_.frames_back; }

  static kernels::GreyRows rows_of(const cv::Mat& grey) {
    return {grey.ptr<std::uint8_t>(), nullptr, static_cast<std::ptrdiff_t>(grey.step1())};
  }

  void find_flow(const cv::Mat& before, const cv::Mat& now) {
    kernels::FlowProblem problem;
    problem.width = size_.width;
    problem.height = size_.height;
    problem.previous = rows_of(before);
    problem.current = rows_of(now);
    problem.derivatives = options_.derivatives;
    problem.smoothness = options_.smoothness;
    problem.sweeps = options_.sweeps;
    problem.tolerance_px = options_.tolerance;
    flow_.create(size_.width, size_.height);
    solver_.solve(problem, kernels::rows_of(flow_));
  }

  void threshold(cv::Mat& mask) const {
    for (int y = 0; y < size_.height; ++y) {
      kernels::mask_of_flow(flow_.u.row(y), flow_.v.row(y), static_cast<float>(options_.magnitude_threshold),
                            mask.ptr<std::uint8_t>(y), static_cast<std::size_t>(size_.width));
    }
  }

  HornSchunckOptions options_;
  std::vector<cv::Mat> history_;  ///< grey, a ring of this frame and N before
  std::int64_t frames_ = 0;       ///< since the last reset
  cv::Size size_;
  int channels_ = 0;
  kernels::FlowSolver solver_;
  kernels::FlowPlanes flow_;
};

}  // namespace

std::unique_ptr<Segmenter> make_model(const HornSchunckOptions& options) {
  check_fields(options);
  return std::make_unique<HornSchunckSegmenter>(options);
}

}  // namespace survtrack
