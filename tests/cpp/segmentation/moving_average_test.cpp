// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <opencv2/core.hpp>
#include <stdexcept>
#include <vector>

#include "../simd_levels.hpp"
#include "survtrack/core/errors.hpp"
#include "survtrack/segmentation/segmenter.hpp"

namespace survtrack {
namespace {

struct Answer {
  cv::Mat mask;
  cv::Mat background;
};

/// Runs a whole file through the model: pushes ahead by its delay, fewer at the end.
std::vector<Answer> run(const MovingAverageOptions& options, const std::vector<cv::Mat>& frames,
                        const Expectation& expectation = {}) {
  const auto model = make_segmenter(options);
  std::vector<Answer> answers;
  std::vector<Event> events;
  const auto segment = [&] {
    Answer answer;
    model->segment(frames[answers.size()], expectation, answer.mask, events);
    model->background(answer.background);
    answers.push_back(answer);
  };
  for (std::size_t i = 0; i < frames.size(); ++i) {
    model->push(frames[i]);
    if (i >= static_cast<std::size_t>(model->delay_frames())) segment();
  }
  while (answers.size() < frames.size()) segment();
  return answers;
}

/// One-pixel frames of these grey levels.
std::vector<cv::Mat> pixels(const std::vector<int>& levels) {
  std::vector<cv::Mat> frames;
  for (const int level : levels) frames.emplace_back(1, 1, CV_8UC1, cv::Scalar(level));
  return frames;
}

std::vector<int> masks_of(const std::vector<Answer>& answers) {
  std::vector<int> values;
  for (const Answer& answer : answers) values.push_back(answer.mask.at<std::uint8_t>(0, 0));
  return values;
}

MovingAverageOptions without_secondary(Window window, int frames, double threshold) {
  return {.window = window, .window_frames = frames, .threshold = threshold, .secondary_background = false};
}

TEST(MovingAverage, CentredWindowIsCutAtBothEnds) {
  // Sums over k-2 .. k+2: 60/3, 100/4, 200/5, 250/5, 230/4, 200/3; differences times n: 30 20 50 50 170 20.
  const auto frames = pixels({10, 20, 30, 40, 100, 60});
  EXPECT_EQ(make_segmenter(without_secondary(Window::centred, 4, 10))->delay_frames(), 2);
  EXPECT_EQ(masks_of(run(without_secondary(Window::centred, 4, 10), frames)), (std::vector{0, 0, 0, 0, 255, 0}));
  EXPECT_EQ(masks_of(run(without_secondary(Window::centred, 4, 9.9), frames)),
            (std::vector{255, 0, 255, 255, 255, 0}));
}

TEST(MovingAverage, BackgroundIsTheMeanRoundedToTheNearest) {
  std::vector<int> levels;
  for (const Answer& answer : run(without_secondary(Window::centred, 4, 10), pixels({10, 20, 30, 40, 100, 60}))) {
    levels.push_back(answer.background.at<std::uint8_t>(0, 0));
  }
  EXPECT_EQ(levels, (std::vector{20, 25, 40, 50, 58, 67}));  // 230/4 = 57.5, 200/3 = 66.7
}

TEST(MovingAverage, CausalWindowHoldsTheLastFrames) {
  // N = 3, T = 10: 100-100, 200-200, 330-390, 330-300 (just not above 30), 329-297.
  const auto options = without_secondary(Window::causal, 3, 10);
  EXPECT_EQ(make_segmenter(options)->delay_frames(), 0);
  EXPECT_EQ(masks_of(run(options, pixels({100, 100, 130, 100, 99}))), (std::vector{0, 0, 255, 0, 255}));
}

TEST(MovingAverage, CausalFirstFrameIsEmpty) {
  cv::Mat frame(20, 30, CV_8UC1);
  cv::randu(frame, 0, 256);
  for (const bool secondary : {false, true}) {
    const auto answers = run({.window = Window::causal, .threshold = 0, .secondary_background = secondary}, {frame});
    EXPECT_EQ(cv::countNonZero(answers[0].mask), 0);
    EXPECT_EQ(cv::norm(answers[0].background, frame, cv::NORM_INF), 0);
  }
}

TEST(MovingAverage, ThresholdMayBeFractional) {
  // One frame of level d, then zeros: the mean differs by d / n.
  const auto last = [](int first, int frames, double threshold) {
    std::vector<int> levels(static_cast<std::size_t>(frames), 0);
    levels[0] = first;
    return masks_of(run(without_secondary(Window::causal, frames, threshold), pixels(levels))).back();
  };
  EXPECT_EQ(last(29, 100, 0.29), 0);  // 0.29 * 100 is 28.999... in binary
  EXPECT_EQ(last(30, 100, 0.29), 255);
  EXPECT_EQ(last(7, 10, 0.7), 0);
  EXPECT_EQ(last(8, 10, 0.75), 255);
  EXPECT_EQ(last(1, 10, 0.0), 255);
  EXPECT_EQ(last(0, 10, 0.0), 0);
  EXPECT_EQ(last(255, 1, 255.0), 0);
}

TEST(MovingAverage, WindowOfOneFrameFindsNothing) {
  for (const Window window : {Window::centred, Window::causal}) {
    EXPECT_EQ(masks_of(run(without_secondary(window, 1, 0), pixels({0, 255, 3}))), (std::vector{0, 0, 0}));
  }
}

TEST(MovingAverage, ColourIsTurnedToGrey) {
  // 0.114 * 200 + 0.587 * 100 + 0.299 * 50 = 96.45
  const cv::Mat frame(1, 1, CV_8UC3, cv::Scalar(200, 100, 50));
  EXPECT_EQ(run({.window = Window::causal}, {frame})[0].background.at<std::uint8_t>(0, 0), 96);
}

TEST(MovingAverage, SecondaryBackgroundStartsAsTheMeanAndLearnsWhereNothingMoves) {
  // Causal, N = 100, T1 = 0, T2 = 15. sbg: 100; 110 (10 away: learned); 110 (20 away: foreground, kept);
  // 124 (14 away: learned); 139 (15 away is not above 15).
  const MovingAverageOptions options{.window = Window::causal, .window_frames = 100, .threshold = 0};
  EXPECT_EQ(masks_of(run(options, pixels({100, 110, 130, 124, 139, 155}))), (std::vector{0, 0, 255, 0, 0, 255}));
  // Centred, N = 2: bg of frame 0 is (100 + 131) / 2 = 115.5, so sbg is 116 (eq. 3.3): 16 away from 100.
  const MovingAverageOptions centred{.window_frames = 2};
  EXPECT_EQ(masks_of(run(centred, pixels({100, 131})))[0], 255);
  EXPECT_EQ(masks_of(run(centred, pixels({100, 129})))[0], 0);  // 114.5 -> 115, 15 away
}

TEST(MovingAverage, KeptPlacesAreNotLearned) {
  const MovingAverageOptions options{.window = Window::causal, .window_frames = 100, .threshold = 0};
  std::vector<cv::Mat> frames;
  for (const int level : {100, 110, 120}) frames.emplace_back(1, 3, CV_8UC1, cv::Scalar(level));
  // Two boxes that overlap in pixel 1, and boxes that cover nothing.
  Expectation kept;
  kept.keep = {{0.9, 0.2, 0.3, 0.1}, {1, 0, 0.5, 9}, {-5, 0, 5, 1}, {3, 0, 4, 4}, {0, 0, 0, 1}};
  const auto last = run(options, frames, kept)[2].mask;
  // The first box covers part of pixels 0 and 1: they still know 100, pixel 2 has learned 110.
  EXPECT_EQ(last.at<std::uint8_t>(0, 0), 255);
  EXPECT_EQ(last.at<std::uint8_t>(0, 1), 255);
  EXPECT_EQ(last.at<std::uint8_t>(0, 2), 0);
  EXPECT_EQ(cv::countNonZero(run(options, frames)[2].mask), 0);
}

TEST(MovingAverage, SecondaryBackgroundRemovesTails) {
  // A bright square of 8 px moves 2 px a frame over a dark ground (fig. 3.5): the average holds it in 4
  // of 11 frames wherever it passes soon or has just passed.
  const auto square = [](int frame) { return cv::Rect(2 * (frame - 20), 10, 8, 8); };
  std::vector<cv::Mat> frames;
  for (int i = 0; i < 60; ++i) {
    frames.emplace_back(30, 100, CV_8UC1, cv::Scalar(50));
    if (i >= 20) frames.back()(square(i)).setTo(250);
  }
  const auto with = run({.window_frames = 10}, frames);
  const auto without = run({.window_frames = 10, .secondary_background = false}, frames);
  for (int i = 26; i < 54; ++i) {
    cv::Mat truth(frames[0].size(), CV_8UC1, cv::Scalar(0));
    truth(square(i)).setTo(255);
    const auto frame = static_cast<std::size_t>(i);
    EXPECT_EQ(cv::norm(with[frame].mask, truth, cv::NORM_INF), 0) << "frame " << i;
    const cv::Rect front(square(i).br().x, 10, 4, 8);
    const cv::Rect behind(square(i).x - 4, 10, 4, 8);
    EXPECT_EQ(cv::countNonZero(without[frame].mask(front)), 32) << "frame " << i;
    EXPECT_EQ(cv::countNonZero(without[frame].mask(behind)), 32) << "frame " << i;
  }
}

/// The definition, in floating point and with all frames kept.
std::vector<cv::Mat> defined(const MovingAverageOptions& options, const std::vector<cv::Mat>& frames) {
  const int half = options.window_frames / 2;
  const int count = static_cast<int>(frames.size());
  std::vector<cv::Mat> masks;
  cv::Mat known;
  for (int k = 0; k < count; ++k) {
    const int first = std::max(0, options.window == Window::centred ? k - half : k - options.window_frames + 1);
    const int last = std::min(count - 1, options.window == Window::centred ? k + half : k);
    cv::Mat mean(frames[0].size(), CV_64FC1, cv::Scalar(0));
    for (int i = first; i <= last; ++i) cv::add(mean, frames[static_cast<std::size_t>(i)], mean, {}, CV_64F);
    mean /= last - first + 1;
    const cv::Mat& frame = frames[static_cast<std::size_t>(k)];
    if (k == 0) {
      known.create(frame.size(), CV_8UC1);
      for (int y = 0; y < frame.rows; ++y) {
        for (int x = 0; x < frame.cols; ++x) {
          known.at<std::uint8_t>(y, x) = static_cast<std::uint8_t>(std::floor(mean.at<double>(y, x) + 0.5));
        }
      }
    }
    cv::Mat mask(frame.size(), CV_8UC1, cv::Scalar(0));
    for (int y = 0; y < frame.rows; ++y) {
      for (int x = 0; x < frame.cols; ++x) {
        const int level = frame.at<std::uint8_t>(y, x);
        bool moving = std::abs(mean.at<double>(y, x) - level) > options.threshold;
        if (options.secondary_background) {
          std::uint8_t& seen = known.at<std::uint8_t>(y, x);
          moving = moving && std::abs(seen - level) > options.secondary_threshold;
          if (!moving) seen = static_cast<std::uint8_t>(level);
        }
        mask.at<std::uint8_t>(y, x) = moving ? 255 : 0;
      }
    }
    masks.push_back(mask);
  }
  return masks;
}

class MovingAverageLevels : public AtEverySimdLevel {};

TEST_P(MovingAverageLevels, MatchTheDefinition) {
  cv::RNG random(7);
  for (const cv::Size size : {cv::Size(67, 5), cv::Size(1, 9), cv::Size(128, 3)}) {
    std::vector<cv::Mat> frames(40);
    for (cv::Mat& frame : frames) {
      frame.create(size, CV_8UC1);
      random.fill(frame, cv::RNG::UNIFORM, 0, &frame == &frames[20] ? 256 : 60);
    }
    for (const Window window : {Window::centred, Window::causal}) {
      // 150 and 300: 16-bit and 32-bit sums.
      for (const int window_frames : {1, 2, 7, 30, 150, 300}) {
        for (const bool secondary : {false, true}) {
          const MovingAverageOptions options{window, window_frames, 12.25, secondary, 15.5};
          const auto expected = defined(options, frames);
          const auto found = run(options, frames);
          for (std::size_t i = 0; i < frames.size(); ++i) {
            ASSERT_EQ(cv::norm(found[i].mask, expected[i], cv::NORM_INF), 0)
                << "frame " << i << ", window " << window_frames;
          }
        }
      }
    }
  }
}

TEST_P(MovingAverageLevels, LongBrightWindowsDoNotOverflow) {
  // The longest window with 16-bit sums and the next, filled with white: a black frame differs by 255 (1 - 1/n).
  for (const int window_frames : {255, 256, 257, 258, 1000}) {
    std::vector<int> levels(static_cast<std::size_t>(window_frames) + 300, 255);
    levels[levels.size() - 150] = 0;
    for (const Window window : {Window::centred, Window::causal}) {
      const auto answers = run(without_secondary(window, window_frames, 250), pixels(levels));
      for (std::size_t i = 0; i < levels.size(); ++i) {
        ASSERT_EQ(answers[i].mask.at<std::uint8_t>(0, 0), levels[i] == 0 ? 255 : 0) << i << " of " << window_frames;
        ASSERT_GE(answers[i].background.at<std::uint8_t>(0, 0), 252) << i << " of " << window_frames;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Levels, MovingAverageLevels, testing::ValuesIn(simd_levels()), simd_level_name);

TEST(MovingAverage, RefusesCallsOutOfOrder) {
  const auto model = make_segmenter(MovingAverageOptions{.window_frames = 4});
  const cv::Mat frame(2, 2, CV_8UC1, cv::Scalar(0));
  std::vector<Event> events;
  cv::Mat mask;
  EXPECT_THROW(model->segment(frame, {}, mask, events), std::logic_error);
  for (int i = 0; i < 3; ++i) model->push(frame);
  EXPECT_THROW(model->push(frame), std::logic_error);
  EXPECT_THROW(model->push(cv::Mat(2, 3, CV_8UC1, cv::Scalar(0))), InputError);
}

TEST(MovingAverage, RefusesOptionsOutOfRange) {
  EXPECT_THROW(make_segmenter(MovingAverageOptions{.window_frames = 0}), ConfigError);
  EXPECT_THROW(make_segmenter(MovingAverageOptions{.threshold = -1}), ConfigError);
  EXPECT_THROW(make_segmenter(MovingAverageOptions{.secondary_threshold = 256}), ConfigError);
}

}  // namespace
}  // namespace survtrack
