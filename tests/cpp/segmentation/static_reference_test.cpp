// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <opencv2/core.hpp>
#include <vector>

#include "../error_message.hpp"
#include "../simd_levels.hpp"
#include "segmentation/static_reference_kernels.hpp"
#include "survtrack/core/errors.hpp"
#include "survtrack/segmentation/segmenter.hpp"

namespace survtrack {
namespace {

std::vector<cv::Mat> noise(int count, const cv::Size& size, int channels) {
  std::vector<cv::Mat> frames;
  cv::RNG random(3);
  for (int i = 0; i < count; ++i) {
    cv::Mat frame(size, CV_MAKETYPE(CV_8U, channels));
    random.fill(frame, cv::RNG::UNIFORM, 0, 256);
    frames.push_back(frame);
  }
  return frames;
}

cv::Mat next_mask(Segmenter& model, const cv::Mat& frame) {
  cv::Mat mask;
  std::vector<Event> events;
  model.segment(frame, {}, mask, events);
  return mask;
}

cv::Mat pixel(int blue, int green, int red) { return cv::Mat(1, 1, CV_8UC3, cv::Scalar(blue, green, red)); }

/// The mean of the middle two, or twice the middle one: as numpy.median has it.
double median_of(std::vector<int> levels) {
  std::sort(levels.begin(), levels.end());
  const std::size_t n = levels.size();
  return n % 2 == 1 ? levels[n / 2] : 0.5 * (levels[n / 2 - 1] + levels[n / 2]);
}

class StaticReference : public AtEverySimdLevel {};

TEST_P(StaticReference, IsItsFormulaInEveryChannel) {
  for (const int channels : {1, 3}) {
    for (const ReferenceSource source : {ReferenceSource::mean, ReferenceSource::median}) {
      for (const int learned : {1, 4, 5, 8}) {
        StaticReferenceOptions options;
        options.source = source;
        options.frames = learned;
        options.threshold_blue = 60.3;
        options.threshold_green = 70.0;
        options.threshold_red = 80.75;
        options.threshold_grey = 90.5;
        const double thresholds[3] = {channels == 1 ? 90.5 : 60.3, 70.0, 80.75};
        const auto frames = noise(12, {43, 9}, channels);
        const auto model = make_segmenter(options);
        for (std::size_t k = 0; k < frames.size(); ++k) {
          const cv::Mat mask = next_mask(*model, frames[k]);
          for (int y = 0; y < 9; ++y) {
            for (int x = 0; x < 43; ++x) {
              bool differs = false;
              for (int c = 0; c < channels; ++c) {
                std::vector<int> levels;
                double sum = 0.0;
                for (int i = 0; i < learned; ++i) {
                  levels.push_back(frames[static_cast<std::size_t>(i)].ptr<std::uint8_t>(y)[x * channels + c]);
                  sum += levels.back();
                }
                const double reference = source == ReferenceSource::mean ? sum / learned : median_of(levels);
                differs |= std::abs(frames[k].ptr<std::uint8_t>(y)[x * channels + c] - reference) > thresholds[c];
              }
              const bool expected = k >= static_cast<std::size_t>(learned) && differs;
              ASSERT_EQ(mask.at<std::uint8_t>(y, x), expected ? 255 : 0) << k << ": " << x << ", " << y;
            }
          }
        }
      }
    }
  }
}

TEST_P(StaticReference, ARowOfPartsIsTheRow) {
  const auto all = noise(7, {211, 1}, 1);
  std::vector<std::uint8_t> frame;
  for (int c = 0; c < 3; ++c) frame.insert(frame.end(), all[static_cast<std::size_t>(c)].begin<std::uint8_t>(), all[static_cast<std::size_t>(c)].end<std::uint8_t>());
  std::vector<std::uint8_t> whole(211), parts(211, 7);
  kernels::StaticReferenceRow<3> row{};
  row.frame = frame.data();
  for (std::size_t c = 0; c < 3; ++c) {
    row.low[c] = all[1 + 2 * c].ptr<std::uint8_t>();
    row.high[c] = all[2 + 2 * c > 6 ? 0 : 2 + 2 * c].ptr<std::uint8_t>();
  }
  row.mask = whole.data();
  row.count = 211;
  kernels::static_reference_step(row);
  row.mask = parts.data();
  for (const auto& [first, length] : {std::pair<std::size_t, std::size_t>{17, 60}, {100, 1}, {180, 31}}) {
    kernels::static_reference_step(row.part(first, length));
    for (std::size_t i = first; i < first + length; ++i) {
      ASSERT_EQ(parts[i], whole[i]) << i;
      parts[i] = 7;
    }
  }
  EXPECT_EQ(std::count(parts.begin(), parts.end(), 7), 211) << "wrote beyond a part";
}

INSTANTIATE_TEST_SUITE_P(All, StaticReference, testing::ValuesIn(simd_levels()), simd_level_name);

TEST(StaticReferenceModel, DiffersStrictlyInAnyChannelFromTheExactMean) {
  StaticReferenceOptions options;
  options.frames = 2;
  const auto model = make_segmenter(options);
  next_mask(*model, pixel(100, 100, 100));
  EXPECT_EQ(cv::countNonZero(next_mask(*model, pixel(101, 200, 100))), 0);  // the mean is 100.5, 150, 100
  const auto foreground = [&](int blue, int green, int red) { return cv::countNonZero(next_mask(*model, pixel(blue, green, red))) == 1; };
  EXPECT_FALSE(foreground(137, 150, 137)) << "36.5 and exactly 37";
  EXPECT_TRUE(foreground(138, 150, 100)) << "37.5";
  EXPECT_TRUE(foreground(63, 150, 100));
  EXPECT_FALSE(foreground(64, 150, 63));
  EXPECT_TRUE(foreground(100, 188, 100));
  EXPECT_TRUE(foreground(100, 150, 138));
  cv::Mat background;
  model->background(background);
  EXPECT_EQ(background.at<cv::Vec3b>(0, 0), cv::Vec3b(101, 150, 100)) << "halves upwards";
}

TEST(StaticReferenceModel, ThresholdsAreOfTheirChannel) {
  StaticReferenceOptions options;
  options.frames = 1;
  options.threshold_blue = 10.0;
  options.threshold_green = 20.0;
  options.threshold_red = 255.0;
  const auto model = make_segmenter(options);
  next_mask(*model, pixel(100, 100, 0));
  const auto foreground = [&](int blue, int green, int red) { return cv::countNonZero(next_mask(*model, pixel(blue, green, red))) == 1; };
  EXPECT_TRUE(foreground(111, 100, 0));
  EXPECT_FALSE(foreground(110, 120, 255));
  EXPECT_TRUE(foreground(110, 121, 255));
}

TEST(StaticReferenceModel, APictureIsTheBackgroundOfTheFirstFrame) {
  StaticReferenceOptions options;
  options.source = ReferenceSource::picture;
  options.frames = 2;
  const auto model = make_segmenter(options);
  EXPECT_TRUE(contains(message_of<InputError>([&] { next_mask(*model, pixel(1, 2, 3)); }), "background: ", "none was given"));
  model->load_background(pixel(100, 100, 100));
  for (int run = 0; run < 2; ++run) {
    EXPECT_EQ(cv::countNonZero(next_mask(*model, pixel(100, 138, 100))), 1);
    EXPECT_EQ(cv::countNonZero(next_mask(*model, pixel(100, 137, 100))), 0);
    // After a change of the scene the coming two frames take its place, until reset.
    model->relearn();
    EXPECT_EQ(cv::countNonZero(next_mask(*model, pixel(200, 200, 200))), 0);
    EXPECT_EQ(cv::countNonZero(next_mask(*model, pixel(202, 202, 202))), 0);
    EXPECT_EQ(cv::countNonZero(next_mask(*model, pixel(201, 201, 201))), 0);
    EXPECT_EQ(cv::countNonZero(next_mask(*model, pixel(100, 100, 100))), 1);
    model->reset();
  }
  EXPECT_TRUE(contains(message_of<InputError>([&] { next_mask(*model, cv::Mat(4, 5, CV_8UC3, cv::Scalar::all(0))); }),
                       "background: the picture is 1x1x3, the frame 4x5x3"));
  EXPECT_TRUE(contains(message_of<InputError>([&] { next_mask(*model, cv::Mat(1, 1, CV_8UC1, cv::Scalar::all(0))); }),
                       "the frame 1x1; expected the same size and channel count"));
  EXPECT_TRUE(contains(message_of<InputError>([&] { model->load_background(cv::Mat(3, 3, CV_32FC1)); }), "background: is 3x3 float32"));
  EXPECT_TRUE(contains(message_of<InputError>([&] { model->load_background({}); }), "background: is empty"));
}

TEST(StaticReferenceModel, OtherModelsAndSourcesTakeNoPicture) {
  EXPECT_TRUE(contains(message_of<InputError>([] { make_segmenter(SelectiveOptions{})->load_background(pixel(1, 2, 3)); }),
                       "background: this background model takes no picture"));
  EXPECT_TRUE(contains(message_of<InputError>([] { make_segmenter(StaticReferenceOptions{})->load_background(pixel(1, 2, 3)); }),
                       "background: segmenter.source", "expected segmenter.source picture"));
}

TEST(StaticReferenceModel, OptionsOutOfTheirRangesAreRefused) {
  StaticReferenceOptions options;
  options.frames = 0;
  EXPECT_THROW(make_segmenter(options), ConfigError);
  options.frames = 5;
  options.threshold_red = std::nan("");
  EXPECT_THROW(make_segmenter(options), ConfigError);
}

}  // namespace
}  // namespace survtrack
