// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include <gtest/gtest.h>

#include "box_run.hpp"
#include "../error_message.hpp"
#include "survtrack/core/errors.hpp"
#include "survtrack/pipeline/detector.hpp"

namespace survtrack {
namespace {

ColorHistogram of_bin(std::size_t bin) {
  ColorHistogram histogram;
  histogram.parts[bin] = 1.0F;
  return histogram;
}

Config config_with(double weight, double refresh_rate = 0.0, double min_intersection = 0.0) {
  Config config;
  config.filter = KalmanCvOptions{.noise_unit = NoiseUnit::px, .velocity_noise = 5.0, .position_noise = 5.0,
                                  .initial_velocity = 5.0, .lost_damping_time = 0.0};
  config.cost = DistanceOptions{};
  config.lifecycle = LostCountOptions{.lost_after_frames = 20};
  config.appearance = ColorHistogramOptions{.weight = weight, .refresh_rate = refresh_rate, .min_intersection = min_intersection};
  return config;
}

struct Seen {
  double x;
  std::size_t color;
};

class Play {
 public:
  explicit Play(const Config& config) : tracker_(config) {}

  /// Ids by the order of the detections; 0: none.
  std::vector<std::int64_t> frame(const std::vector<Seen>& seen) {
    std::vector<Box> boxes;
    for (const Seen& one : seen) boxes.push_back(Box::around({one.x, 50.0}, 20.0, 20.0));
    Detections detections = detections_of(boxes, 0.1 * static_cast<double>(index_), index_, 640, 480);
    ++index_;
    for (const Seen& one : seen) detections.histograms.push_back(of_bin(one.color));
    result_ = tracker_.process(detections);
    std::vector<std::int64_t> ids(seen.size(), 0);
    for (const Track& track : result_.tracks) {
      if (track.detection >= 0) ids[static_cast<std::size_t>(track.detection)] = track.id;
    }
    return ids;
  }
  const TrackingResult& result() const { return result_; }

 private:
  Tracker tracker_;
  std::int64_t index_ = 0;
  TrackingResult result_;
};

using Ids = std::vector<std::int64_t>;

TEST(Appearance, ColoursDecideBetweenPlacesThatAreAsNear) {
  for (const double weight : {1e-9, 100.0}) {
    Play play(config_with(weight));
    for (int i = 0; i < 5; ++i) EXPECT_EQ(play.frame({{100.0, 3}, {200.0, 77}}), (Ids{1, 2}));
    // They changed places while nobody looked.
    const Ids expected = weight > 1.0 ? Ids{2, 1} : Ids{1, 2};
    EXPECT_EQ(play.frame({{140.0, 77}, {160.0, 3}}), expected) << weight;
  }
}

TEST(Appearance, TheTermIsWeightTimesWhatIsNotCommon) {
  Play play(config_with(8.0));
  play.frame({{100.0, 3}});
  play.frame({{100.0, 3}});
  ASSERT_EQ(play.result().matches.candidates.size(), 1U);
  const double alike = play.result().matches.candidates[0].cost;
  play.frame({{100.0, 5}});
  EXPECT_NEAR(play.result().matches.candidates[0].cost, alike + 8.0, 1e-9);
}

TEST(Appearance, TheReferenceIsRefreshed) {
  Play slow(config_with(8.0, 0.0)), fast(config_with(8.0, 0.5));
  for (Play* play : {&slow, &fast}) {
    play->frame({{100.0, 3}});
    for (int i = 0; i < 3; ++i) play->frame({{100.0, 5}});
  }
  EXPECT_NEAR(slow.result().matches.candidates[0].cost, 8.0, 1e-9) << "it stays the first";
  EXPECT_NEAR(fast.result().matches.candidates[0].cost, 8.0 * 0.25, 1e-6) << "(1 - 1/2)^2 of the first is left";
}

TEST(Appearance, StrangersAreRefused) {
  Play play(config_with(0.0, 0.0, 0.5));
  EXPECT_EQ(play.frame({{100.0, 3}}), (Ids{1}));
  EXPECT_EQ(play.frame({{100.0, 5}}), (Ids{2}));
  EXPECT_EQ(play.frame({{100.0, 3}}), (Ids{1}));
}

TEST(Appearance, HistogramsGoWithTheirTracks) {
  Config config = config_with(100.0);
  std::get<LostCountOptions>(config.lifecycle).lost_after_frames = 1;
  Play play(config);
  play.frame({{100.0, 1}, {200.0, 2}, {300.0, 3}});
  for (int i = 0; i < 4; ++i) play.frame({{200.0, 2}, {300.0, 3}});  // the first one ends
  EXPECT_EQ(play.frame({{240.0, 3}, {260.0, 2}}), (Ids{3, 2}));
}

TEST(Appearance, NeedsAHistogramADetection) {
  Tracker tracker(config_with(1.0));
  EXPECT_EQ(message_of<InputError>([&] { tracker.process(detections_of({{0.0, 0.0, 10.0, 10.0}}, 0.0, 0)); }),
            "detections.histograms: are 0 of 1 detections; expected one each, with appearance.model color_histogram");
}

TEST(Appearance, TheDetectorMeasuresBlobs) {
  Config config;
  config.appearance = ColorHistogramOptions{};
  Detector detector(config);
  cv::Mat frame(120, 160, CV_8UC3, cv::Scalar(90, 90, 90));
  EXPECT_TRUE(detector.process(frame, 0.0)->histograms.empty());
  frame = frame.clone();
  frame(cv::Rect(30, 40, 20, 40)).setTo(cv::Scalar(10, 200, 250));
  const auto seen = detector.process(frame, 0.1);
  ASSERT_EQ(seen->items.size(), 1U);
  ASSERT_EQ(seen->histograms.size(), 1U);
  EXPECT_GT(seen->histograms[0].parts[ColorHistogram::bin(10, 200, 250)], 0.95F);
  EXPECT_NO_THROW(check_histogram(seen->histograms[0], "h"));
  EXPECT_TRUE(Detector().process(frame, 0.0)->histograms.empty()) << "only when asked for";
}

}  // namespace
}  // namespace survtrack
