// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <opencv2/core.hpp>
#include <random>
#include <vector>

#include "../simd_levels.hpp"
#include "survtrack/core/errors.hpp"
#include "survtrack/segmentation/segmenter.hpp"

namespace survtrack {
namespace {

const cv::Size frame_size(90, 40);
const cv::Rect place(10, 5, 37, 21);

cv::Mat noisy(int level, std::uint32_t seed, int channels) {
  cv::Mat frame(frame_size, CV_8UC(channels));
  std::minstd_rand grain(seed);
  for (int y = 0; y < frame.rows; ++y) {
    auto* const row = frame.ptr<std::uint8_t>(y);
    for (int i = 0; i < frame.cols * channels; ++i) row[i] = static_cast<std::uint8_t>(level + static_cast<int>(grain() % 9U));
  }
  return frame;
}

struct Model {
  std::unique_ptr<Segmenter> segmenter = make_segmenter(SelectiveOptions{});
  cv::Mat mask;
  std::vector<Event> events;

  void whole(double time_s, const cv::Mat& frame) { segmenter->segment(frame, at(time_s), mask, events); }
  void parts(double time_s, const cv::Mat& frame, const ReadPlan& plan) {
    segmenter->segment_regions(frame, at(time_s), plan, mask, events);
  }
  static Expectation at(double time_s) {
    Expectation expectation;
    expectation.time_s = time_s;
    return expectation;
  }
  cv::Mat background() const {
    cv::Mat picture;
    segmenter->background(picture);
    return picture;
  }
};

ReadPlan plan_of(const cv::Rect& rect) {
  ReadPlan plan;
  plan.clear(frame_size);
  plan.add(rect);
  plan.finish();
  return plan;
}

double difference(const cv::Mat& a, const cv::Mat& b) { return cv::norm(a, b, cv::NORM_INF); }

TEST(SelectiveRegions, WithinAPlanIsAsWithoutAndOutsideNothingHappens) {
  for (const int channels : {1, 3}) {
    Model whole, parts;
    const ReadPlan plan = plan_of(place);
    cv::Mat before;
    int most = 0;
    for (int i = 0; i < 30; ++i) {
      cv::Mat frame = noisy(90 + i, 7U + static_cast<std::uint32_t>(i), channels);
      if (i > 10) frame(cv::Rect(20, 8, 40, 9)).setTo(cv::Scalar::all(230));
      whole.whole(0.1 * i, frame);
      if (i == 0) {
        parts.whole(0.0, frame);
        before = parts.background();
        continue;
      }
      parts.parts(0.1 * i, frame, plan);
      EXPECT_EQ(difference(parts.mask(place), whole.mask(place)), 0.0) << i;
      EXPECT_EQ(difference(parts.background()(place), whole.background()(place)), 0.0) << i;
      cv::Mat outside = parts.mask.clone();
      outside(place).setTo(0);
      EXPECT_EQ(cv::countNonZero(outside), 0) << i;
      cv::Mat unread = parts.background();
      before(place).copyTo(unread(place));
      EXPECT_EQ(difference(unread, before), 0.0) << i;
      most = std::max(most, cv::countNonZero(parts.mask));
    }
    EXPECT_GT(most, 100) << "something was there to see";
  }
}

TEST(SelectiveRegions, WhatIsRefreshedCatchesUp) {
  Model often, seldom;
  const cv::Mat start = noisy(90, 5U, 3);
  often.whole(0.0, start);
  seldom.whole(0.0, start);
  // So that the rates are those of an old background.
  for (int i = 1; i <= 100; ++i) {
    often.whole(0.1 * i, start);
    seldom.whole(0.1 * i, start);
  }
  const cv::Mat brighter = start + cv::Scalar::all(12);
  const ReadPlan nothing = plan_of({});
  for (int i = 1; i <= 20; ++i) {
    often.whole(10.0 + 0.1 * i, brighter);
    if (i < 20) seldom.parts(10.0 + 0.1 * i, brighter, nothing);
  }
  ReadPlan strip;
  strip.clear(frame_size);
  strip.refresh(0, 40, 2.0);
  strip.finish();
  seldom.parts(12.0, brighter, strip);
  // Twenty steps of 1/40 are 1 - (1 - 1/40)^20 = 0.40 of the way, one of 20/40 is half.
  EXPECT_NEAR(cv::mean(often.background() - start)[0], 0.40 * 12, 0.5);
  EXPECT_NEAR(cv::mean(seldom.background() - start)[0], 0.50 * 12, 0.5);
}

TEST(SelectiveRegions, AFloodInAPartIsNoChangeOfTheScene) {
  Model model;
  model.whole(0.0, noisy(60, 1U, 3));
  model.parts(0.1, noisy(160, 2U, 3), plan_of(place));
  EXPECT_TRUE(model.events.empty());
  EXPECT_EQ(cv::countNonZero(model.mask), place.area());
  model.whole(0.2, noisy(160, 3U, 3));
  ASSERT_EQ(model.events.size(), 1U);
  EXPECT_EQ(model.events[0].kind, EventKind::scene_changed);
}

TEST(SelectiveRegions, OtherModelsReadWholeFrames) {
  for (const SegmenterOptions& options :
       std::vector<SegmenterOptions>{MovingAverageOptions{}, HornSchunckOptions{}, Mog2Options{}, KnnOptions{}}) {
    const auto segmenter = make_segmenter(options);
    EXPECT_FALSE(segmenter->reads_regions());
    cv::Mat mask;
    std::vector<Event> events;
    EXPECT_THROW(segmenter->segment_regions(noisy(60, 1U, 3), {}, plan_of(place), mask, events), InputError);
  }
  EXPECT_TRUE(make_segmenter(SelectiveOptions{})->reads_regions());
}

// Regions at all edges, narrower than a block of pixels and wider, with places that are kept: what is read is what the
// whole frame gives, the rest stays.
class SelectiveRegions : public AtEverySimdLevel {};
INSTANTIATE_TEST_SUITE_P(Levels, SelectiveRegions, testing::ValuesIn(simd_levels()), simd_level_name);

TEST_P(SelectiveRegions, OfAnyPlaceAndSizeAreThoseOfTheWholeFrame) {
  std::minstd_rand random(11);
  const auto below = [&](int end) { return static_cast<int>(random() % static_cast<unsigned>(end)); };
  const auto some_rect = [&](const cv::Size& size) {
    const int x = below(size.width), y = below(size.height);
    return cv::Rect(x, y, 1 + below(size.width - x), 1 + below(size.height - y));
  };
  for (int trial = 0; trial < 200; ++trial) {
    SCOPED_TRACE(trial);
    const cv::Size size(1 + below(trial % 2 == 0 ? 40 : 150), 1 + below(6));
    const int channels = trial % 3 == 0 ? 1 : 3;
    ReadPlan plan;
    plan.clear(size);
    cv::Mat read = cv::Mat::zeros(size, CV_8UC1);
    for (int i = below(5); i >= 0; --i) {
      const cv::Rect rect = some_rect(size);
      plan.add(rect);
      read(rect).setTo(255);
    }
    plan.finish();
    std::vector<Box> keep;
    for (int i = below(3); i > 0; --i) {
      const cv::Rect rect = some_rect(size);
      keep.push_back({double(rect.x), double(rect.y), double(rect.width), double(rect.height)});
    }
    Model whole, parts;
    for (int k = 0; k < 12; ++k) {
      // Of exactly this size on the heap, so that sanitizers see what is read beyond it.
      std::vector<std::uint8_t> levels(static_cast<std::size_t>(size.area() * channels));
      for (std::uint8_t& level : levels) level = static_cast<std::uint8_t>(below(6) > 0 ? 100 + below(5) : below(256));
      const cv::Mat frame(size, CV_8UC(channels), levels.data());
      Expectation expectation = Model::at(0.1 * k);
      expectation.keep = keep;
      whole.segmenter->segment(frame, expectation, whole.mask, whole.events);
      if (!whole.events.empty()) break;  // it began anew, as regions cannot
      const cv::Mat before = k < 5 ? cv::Mat() : parts.background();
      if (k < 5) {
        parts.segmenter->segment(frame, expectation, parts.mask, parts.events);
        continue;
      }
      parts.segmenter->segment_regions(frame, expectation, plan, parts.mask, parts.events);
      EXPECT_EQ(difference(parts.mask, whole.mask & read), 0.0) << k;
      cv::Mat expected = before.clone();
      whole.background().copyTo(expected, read);
      EXPECT_EQ(difference(parts.background(), expected), 0.0) << k;
    }
  }
}

}  // namespace
}  // namespace survtrack
