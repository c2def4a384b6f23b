// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include <gtest/gtest.h>

#include <opencv2/core.hpp>
#include <ostream>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "survtrack/segmentation/segmenter.hpp"

namespace survtrack {
namespace {

/// What every background model promises, for each of them with its default options.
struct Model {
  SegmenterOptions options;
  std::string name;
  bool has_background() const { return !std::holds_alternative<HornSchunckOptions>(options); }
  /// How far foreground may reach beyond an object: each sweep carries movement a pixel further.
  /// The pyramid's coarsest level sums over 2 of its pixels of 4 px, and is smoothed.
  int reach_px() const {
    if (std::holds_alternative<NormalizedDifferenceOptions>(options)) return 18;
    return std::holds_alternative<HornSchunckOptions>(options) ? 6 : 0;
  }
};

template <std::size_t... I>
std::vector<Model> all_models(std::index_sequence<I...>) {
  return {Model{std::variant_alternative_t<I, SegmenterOptions>{},
                std::variant_alternative_t<I, SegmenterOptions>::model}...};
}

std::vector<Model> all_models() {
  return all_models(std::make_index_sequence<std::variant_size_v<SegmenterOptions>>{});
}

std::ostream& operator<<(std::ostream& out, const Model& model) { return out << model.name; }

Expectation at(std::size_t frame) {
  Expectation expectation;
  expectation.time_s = 0.1 * static_cast<double>(frame);
  return expectation;
}

/// Masks of a whole file at 10 frames a second.
std::vector<cv::Mat> run(Segmenter& model, const std::vector<cv::Mat>& frames) {
  std::vector<cv::Mat> masks;
  std::vector<Event> events;
  const auto segment = [&] {
    cv::Mat mask;
    model.segment(frames[masks.size()], at(masks.size()), mask, events);
    masks.push_back(mask);
  };
  for (std::size_t i = 0; i < frames.size(); ++i) {
    model.push(frames[i]);
    if (i >= static_cast<std::size_t>(model.delay_frames())) segment();
  }
  while (masks.size() < frames.size()) segment();
  return masks;
}

class SegmenterContract : public testing::TestWithParam<std::tuple<Model, int>> {
 protected:
  const SegmenterOptions& options() const { return std::get<0>(GetParam()).options; }
  const Model& model() const { return std::get<0>(GetParam()); }
  int type() const { return CV_MAKETYPE(CV_8U, std::get<1>(GetParam())); }

  cv::Mat scene(const cv::Size& size = {90, 60}) const {
    cv::Mat frame(size, type());
    cv::RNG(3).fill(frame, cv::RNG::UNIFORM, 40, 120);
    return frame;
  }

  static cv::Rect object(int frame) { return {10 + frame, 20, 16, 12}; }

  /// 60 noisy frames of a still scene, then 10 in which a bright object crosses it.
  std::vector<cv::Mat> film() const {
    std::vector<cv::Mat> frames;
    cv::RNG random(5);
    for (int i = 0; i < 70; ++i) {
      cv::Mat noise(60, 90, CV_MAKETYPE(CV_8U, std::get<1>(GetParam())));
      random.fill(noise, cv::RNG::UNIFORM, 0, 4);
      frames.push_back(scene() + noise);
      if (i >= 60) frames.back()(object(i - 60)).setTo(cv::Scalar::all(240));
    }
    return frames;
  }
};

void expect_same(const std::vector<cv::Mat>& a, const std::vector<cv::Mat>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    ASSERT_EQ(a[i].size(), b[i].size());
    EXPECT_EQ(cv::norm(a[i], b[i], cv::NORM_INF), 0) << "frame " << i;
  }
}

TEST_P(SegmenterContract, StillSceneIsEmpty) {
  const std::vector<cv::Mat> frames(60, scene());
  const auto masks = run(*make_segmenter(options()), frames);
  for (std::size_t i = 0; i < masks.size(); ++i) EXPECT_EQ(cv::countNonZero(masks[i]), 0) << "frame " << i;
}

TEST_P(SegmenterContract, FindsAnObjectAndNothingElse) {
  const auto masks = run(*make_segmenter(options()), film());
  for (int i = 0; i < 10; ++i) {
    cv::Mat mask = masks[static_cast<std::size_t>(60 + i)].clone();
    ASSERT_EQ(mask.type(), CV_8UC1);
    EXPECT_EQ(cv::countNonZero(mask == 255), cv::countNonZero(mask)) << "values other than 0 and 255";
    EXPECT_GE(cv::countNonZero(mask(object(i))), object(i).area() * 95 / 100) << "frame " << i;
    // An object's way is not judged here: the averages have tails.
    const int reach = model().reach_px();
    mask(cv::Rect(0, 20 - reach, 90, 12 + 2 * reach)).setTo(0);
    EXPECT_LE(cv::countNonZero(mask), 10) << "frame " << i;
  }
}

TEST_P(SegmenterContract, LeavesTheInputAlone) {
  const auto frames = film();
  std::vector<cv::Mat> copies;
  for (const cv::Mat& frame : frames) copies.push_back(frame.clone());
  run(*make_segmenter(options()), frames);
  expect_same(frames, copies);
}

TEST_P(SegmenterContract, GivesTheSameMasksAgain) {
  const auto frames = film();
  const auto model = make_segmenter(options());
  const auto first = run(*model, frames);
  model->reset();
  run(*model, {scene({31, 17}), scene({31, 17})});  // another size in between
  model->reset();
  cv::theRNG().next();  // what others draw changes nothing
  expect_same(run(*model, frames), first);
  expect_same(run(*make_segmenter(options()), frames), first);
}

TEST_P(SegmenterContract, ReadsStridedViews) {
  const auto frames = film();
  std::vector<cv::Mat> views;
  for (const cv::Mat& frame : frames) {
    cv::Mat larger(70, 111, frame.type(), cv::Scalar::all(9));
    views.push_back(larger(cv::Rect(8, 3, frame.cols, frame.rows)));
    frame.copyTo(views.back());
  }
  expect_same(run(*make_segmenter(options()), views), run(*make_segmenter(options()), frames));
}

TEST_P(SegmenterContract, WritesIntoTheGivenMask) {
  const auto frames = film();
  const auto expected = run(*make_segmenter(options()), frames);
  const auto model = make_segmenter(options());
  const auto delay = static_cast<std::size_t>(model->delay_frames());
  cv::Mat larger(70, 111, CV_8UC1, cv::Scalar(77));
  cv::Mat mask = larger(cv::Rect(8, 3, 90, 60));
  const std::uint8_t* const data = mask.data;
  std::vector<Event> events;
  for (std::size_t i = 0; i + delay < frames.size(); ++i) {
    for (std::size_t j = i == 0 ? 0 : i + delay; j <= i + delay; ++j) model->push(frames[j]);
    model->segment(frames[i], at(i), mask, events);
    ASSERT_EQ(mask.data, data);
    ASSERT_EQ(cv::norm(mask, expected[i], cv::NORM_INF), 0) << "frame " << i;
  }
  mask.setTo(77);
  EXPECT_EQ(cv::countNonZero(larger != 77), 0) << "wrote beyond the mask";
}

TEST_P(SegmenterContract, TakesTheSmallestFrames) {
  for (const cv::Size size : {cv::Size(1, 1), cv::Size(1, 7), cv::Size(7, 1)}) {
    const std::vector<cv::Mat> frames(12, scene(size));
    for (const cv::Mat& mask : run(*make_segmenter(options()), frames)) {
      EXPECT_EQ(mask.size(), size);
      EXPECT_EQ(cv::countNonZero(mask), 0);
    }
  }
}

TEST_P(SegmenterContract, ShowsItsBackground) {
  const cv::Mat flat(60, 90, type(), cv::Scalar::all(100));
  const auto segmenter = make_segmenter(options());
  cv::Mat picture(3, 3, CV_8UC1);
  segmenter->background(picture);
  EXPECT_TRUE(picture.empty());
  run(*segmenter, std::vector<cv::Mat>(30, flat));
  segmenter->background(picture);
  if (!model().has_background()) {
    EXPECT_TRUE(picture.empty());
    return;
  }
  ASSERT_EQ(picture.size(), flat.size());
  ASSERT_EQ(picture.depth(), CV_8U);
  const cv::Mat expected(60, 90, picture.type(), cv::Scalar::all(100));
  EXPECT_LE(cv::norm(picture, expected, cv::NORM_INF), 1);
  segmenter->reset();
  segmenter->background(picture);
  EXPECT_TRUE(picture.empty());
}

TEST_P(SegmenterContract, OnlyModelsOfMovementHaveAFlowField) {
  const auto segmenter = make_segmenter(options());
  cv::Mat field(3, 3, CV_32FC2);
  segmenter->flow(field);
  EXPECT_TRUE(field.empty());
  run(*segmenter, film());
  segmenter->flow(field);
  if (std::holds_alternative<HornSchunckOptions>(options())) {
    EXPECT_EQ(field.size(), cv::Size(90, 60));
    EXPECT_EQ(field.type(), CV_32FC2);
    EXPECT_TRUE(cv::checkRange(field));
    segmenter->reset();
    segmenter->flow(field);
  }
  EXPECT_TRUE(field.empty());
}

TEST_P(SegmenterContract, LeavesGlobalStateAlone) {
  const int threads = cv::getNumThreads();
  const std::uint64_t random_state = cv::theRNG().state;
  run(*make_segmenter(options()), std::vector<cv::Mat>(10, scene()));
  EXPECT_EQ(cv::getNumThreads(), threads);
  EXPECT_EQ(cv::theRNG().state, random_state);
}

INSTANTIATE_TEST_SUITE_P(All, SegmenterContract,
                         testing::Combine(testing::ValuesIn(all_models()), testing::Values(1, 3)),
                         [](const auto& test) {
                           return std::get<0>(test.param).name + (std::get<1>(test.param) == 1 ? "_grey" : "_bgr");
                         });

}  // namespace
}  // namespace survtrack
