// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "segmentation/opencv_segmenters.hpp"

#include <functional>
#include <opencv2/core.hpp>
#include <opencv2/video/background_segm.hpp>
#include <utility>

namespace survtrack {
namespace {

/// Lets OpenCV draw from a sequence of ours instead of this thread's own, while in scope.
class RandomNumbers {
 public:
  explicit RandomNumbers(std::uint64_t& state) : state_(state) { std::swap(cv::theRNG().state, state_); }
  ~RandomNumbers() { std::swap(cv::theRNG().state, state_); }
  RandomNumbers(const RandomNumbers&) = delete;
  RandomNumbers& operator=(const RandomNumbers&) = delete;

 private:
  std::uint64_t& state_;
};

class OpenCvSegmenter final : public Segmenter {
 public:
  using MakeModel = std::function<cv::Ptr<cv::BackgroundSubtractor>()>;

  /// The first frame is shown until the model finds nothing new in it, but at most so many times.
  OpenCvSegmenter(MakeModel make_model, int most_first_showings)
      : make_model_(std::move(make_model)), most_first_showings_(most_first_showings), model_(make_model_()) {}

  void segment(const cv::Mat& frame, const Expectation& /*the models know no places*/, cv::Mat& mask,
               std::vector<Event>& /*raises none*/) override {
    const RandomNumbers own(random_state_);
    model_->apply(frame, mask);
    if (!first_) return;
    for (int shown = 1; shown < most_first_showings_ && cv::countNonZero(mask) > 0; ++shown) {
      model_->apply(frame, mask);
    }
    mask.setTo(0);
    first_ = false;
  }

  void background(cv::Mat& picture) const override {
    if (first_) {
      picture.release();
    } else {
      model_->getBackgroundImage(picture);
    }
  }

  void reset() override {
    model_ = make_model_();
    random_state_ = random_seed;
    first_ = true;
  }

 private:
  static constexpr std::uint64_t random_seed = 0x5eed;

  MakeModel make_model_;
  int most_first_showings_;
  cv::Ptr<cv::BackgroundSubtractor> model_;
  std::uint64_t random_state_ = random_seed;
  bool first_ = true;
};

}  // namespace

std::unique_ptr<Segmenter> make_model(const Mog2Options& options) {
  check_fields(options);
  const auto make = [options] {
    auto model = cv::createBackgroundSubtractorMOG2(options.history_frames, options.variance_threshold,
                                                    options.detect_shadows);
    model->setShadowValue(0);
    return model;
  };
  return std::make_unique<OpenCvSegmenter>(make, 1);
}

std::unique_ptr<Segmenter> make_model(const KnnOptions& options) {
  check_fields(options);
  const auto make = [options] {
    auto model = cv::createBackgroundSubtractorKNN(options.history_frames, options.squared_distance_threshold,
                                                   options.detect_shadows);
    model->setShadowValue(0);
    return model;
  };
  // It takes samples in some frames only and calls all foreground until it has two alike.
  return std::make_unique<OpenCvSegmenter>(make, 100);
}

}  // namespace survtrack
