// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "survtrack/blobs/blob_extractor.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "survtrack/core/errors.hpp"

namespace survtrack {
namespace {

/// Components as they are: nothing is joined or divided.
BlobOptions plain(double min_area_px) {
  return {.min_area_px = min_area_px, .min_area_fraction = 0.0, .merge = NoMergeOptions{}, .share_blobs = false};
}

Detections extracted(const cv::Mat& mask, const cv::Mat& frame, double min_area_px, bool contours = false) {
  Detections detections;
  BlobExtractor(plain(min_area_px)).extract(mask, frame, {}, contours, detections);
  return detections;
}

cv::Mat colours(const cv::Size& size, int channels) {
  cv::Mat frame(size, CV_MAKETYPE(CV_8U, channels));
  cv::RNG(9).fill(frame, cv::RNG::UNIFORM, 0, 256);
  return frame;
}

TEST(BlobExtractor, HandWorkedBlob) {
  // An L of five pixels: (2,1) (2,2) (2,3) (3,3) (4,3).
  cv::Mat mask = cv::Mat::zeros(6, 8, CV_8UC1);
  cv::Mat frame(6, 8, CV_8UC3, cv::Scalar(1, 2, 3));
  int step = 0;
  for (const cv::Point pixel : {cv::Point(2, 1), {2, 2}, {2, 3}, {3, 3}, {4, 3}}) {
    mask.at<std::uint8_t>(pixel) = 255;
    frame.at<cv::Vec3b>(pixel) = {static_cast<std::uint8_t>(10 * step), 100, static_cast<std::uint8_t>(255 - step)};
    ++step;
  }
  const Detections detections = extracted(mask, frame, 0);
  ASSERT_EQ(detections.items.size(), 1U);
  const Detection& blob = detections.items[0];
  EXPECT_EQ(blob.box, (Box{2, 1, 3, 3}));
  EXPECT_EQ(blob.area_px, 5.0);
  EXPECT_EQ(blob.position, (Point{13.0 / 5, 12.0 / 5}));
  EXPECT_EQ(blob.mean_color, (Color{20, 100, 253}));
  // Sums of squares about the centroid: x 37 - 169/5 = 3.2, y 32 - 144/5 = 3.2, xy 33 - 156/5 = 1.8.
  EXPECT_DOUBLE_EQ(blob.moments_px2.xx, 0.64);
  EXPECT_DOUBLE_EQ(blob.moments_px2.yy, 0.64);
  EXPECT_DOUBLE_EQ(blob.moments_px2.xy, 0.36);
  EXPECT_EQ(blob.confidence, 1.0);
  EXPECT_EQ(blob.class_id, -1);
  EXPECT_TRUE(detections.contours.empty());
}

TEST(BlobExtractor, OnePixel) {
  cv::Mat mask = cv::Mat::zeros(1, 1, CV_8UC1);
  const cv::Mat frame(1, 1, CV_8UC1, cv::Scalar(42));
  EXPECT_TRUE(extracted(mask, frame, 0).items.empty());
  mask.setTo(1);
  const Detection blob = extracted(mask, frame, 0).items.at(0);
  EXPECT_EQ(blob.box, (Box{0, 0, 1, 1}));
  EXPECT_EQ(blob.position, (Point{0, 0}));
  EXPECT_EQ(blob.moments_px2, (Symmetric2{}));
  EXPECT_EQ(blob.mean_color, (Color{42, 42, 42}));  // grey: three equal channels
}

TEST(BlobExtractor, DropsWhatIsSmallerAndKeepsTheOrder) {
  cv::Mat mask = cv::Mat::zeros(40, 60, CV_8UC1);
  mask(cv::Rect(30, 2, 5, 4)).setTo(255);   // 20
  mask(cv::Rect(1, 3, 3, 3)).setTo(255);    // 9
  mask(cv::Rect(10, 3, 5, 3)).setTo(255);   // 15
  mask(cv::Rect(5, 20, 10, 10)).setTo(255); // 100
  const auto areas = [&](double min_area_px) {
    std::vector<double> found;
    const Detections detections = extracted(mask, colours(mask.size(), 3), min_area_px);
    for (const Detection& blob : detections.items) found.push_back(blob.area_px);
    return found;
  };
  EXPECT_EQ(areas(0), (std::vector<double>{20, 9, 15, 100}));
  EXPECT_EQ(areas(9), (std::vector<double>{20, 9, 15, 100}));
  EXPECT_EQ(areas(9.5), (std::vector<double>{20, 15, 100}));
  EXPECT_EQ(areas(15), (std::vector<double>{20, 15, 100}));
  EXPECT_EQ(areas(16), (std::vector<double>{20, 100}));
  EXPECT_TRUE(areas(101).empty());
}

/// A pixel-by-pixel reference over OpenCV's components.
std::vector<Detection> reference(const cv::Mat& mask, const cv::Mat& frame) {
  cv::Mat labels, stats, centroids;
  const int count = cv::connectedComponentsWithStats(mask, labels, stats, centroids);
  std::vector<Detection> blobs(static_cast<std::size_t>(count));
  for (int y = 0; y < mask.rows; ++y) {
    for (int x = 0; x < mask.cols; ++x) {
      const int label = labels.at<int>(y, x);
      Detection& blob = blobs[static_cast<std::size_t>(label)];
      const double dx = x - centroids.at<double>(label, 0);
      const double dy = y - centroids.at<double>(label, 1);
      const double area = stats.at<int>(label, cv::CC_STAT_AREA);
      const auto* const pixel = frame.ptr<std::uint8_t>(y) + x * frame.channels();
      blob.moments_px2.xx += dx * dx / area;
      blob.moments_px2.xy += dx * dy / area;
      blob.moments_px2.yy += dy * dy / area;
      blob.mean_color.blue += pixel[0] / area;
      blob.mean_color.green += pixel[frame.channels() == 3 ? 1 : 0] / area;
      blob.mean_color.red += pixel[frame.channels() == 3 ? 2 : 0] / area;
    }
  }
  for (int label = 1; label < count; ++label) {
    Detection& blob = blobs[static_cast<std::size_t>(label)];
    const int* const row = stats.ptr<int>(label);
    blob.area_px = row[cv::CC_STAT_AREA];
    blob.box = {double(row[cv::CC_STAT_LEFT]), double(row[cv::CC_STAT_TOP]), double(row[cv::CC_STAT_WIDTH]),
                double(row[cv::CC_STAT_HEIGHT])};
    blob.position = {centroids.at<double>(label, 0), centroids.at<double>(label, 1)};
  }
  blobs.erase(blobs.begin());
  return blobs;
}

TEST(BlobExtractor, MatchesAReferenceOnRandomMasks) {
  cv::RNG random(31);
  Detections detections;
  BlobExtractor extractor(plain(0));
  for (const int channels : {1, 3}) {
    for (int round = 0; round < 30; ++round) {
      const cv::Size size(random.uniform(1, 200), random.uniform(1, 100));
      cv::Mat noise(size, CV_8UC1);
      random.fill(noise, cv::RNG::UNIFORM, 0, 256);
      cv::blur(noise, noise, {1 + round % 7, 1 + round % 5});
      // Views into larger images, for the mask and the frame alike.
      cv::Mat larger_mask(size.height + 3, size.width + 5, CV_8UC1, cv::Scalar(255));
      cv::Mat mask = larger_mask(cv::Rect({2, 1}, size));
      cv::Mat(noise > 140).copyTo(mask);
      const cv::Mat frame = colours({size.width + 7, size.height + 2}, channels)(cv::Rect({3, 1}, size));
      extractor.extract(mask, frame, {}, false, detections);
      auto expected = reference(mask, frame);
      ASSERT_EQ(detections.items.size(), expected.size());
      for (const Detection& found : detections.items) {
        // Box and centroid together tell which of OpenCV's blobs it is.
        const auto same = std::find_if(expected.begin(), expected.end(), [&](const Detection& blob) {
          return blob.box == found.box && std::abs(blob.position.x - found.position.x) < 1e-9 &&
                 std::abs(blob.position.y - found.position.y) < 1e-9 && blob.area_px == found.area_px;
        });
        ASSERT_NE(same, expected.end());
        EXPECT_NEAR(found.moments_px2.xx, same->moments_px2.xx, 1e-8);
        EXPECT_NEAR(found.moments_px2.xy, same->moments_px2.xy, 1e-8);
        EXPECT_NEAR(found.moments_px2.yy, same->moments_px2.yy, 1e-8);
        EXPECT_NEAR(found.mean_color.blue, same->mean_color.blue, 1e-9);
        EXPECT_NEAR(found.mean_color.green, same->mean_color.green, 1e-9);
        EXPECT_NEAR(found.mean_color.red, same->mean_color.red, 1e-9);
        expected.erase(same);
      }
    }
  }
}

TEST(BlobExtractor, StatisticsDoNotDependOnThePlace) {
  cv::Mat shape = cv::Mat::zeros(41, 67, CV_8UC1);
  cv::ellipse(shape, {33, 20}, {31, 11}, 17, 0, 360, 255, cv::FILLED);
  const cv::Mat frame(3000, 4000, CV_8UC3, cv::Scalar(10, 20, 30));
  std::vector<Detection> found;
  for (const cv::Point place : {cv::Point(0, 0), {3001, 7}, {11, 2900}, {3900, 2950}}) {
    cv::Mat mask = cv::Mat::zeros(frame.size(), CV_8UC1);
    shape.copyTo(mask(cv::Rect(place, shape.size())));
    found.push_back(extracted(mask, frame, 0).items.at(0));
    EXPECT_EQ(found.back().moments_px2, found.front().moments_px2);
    EXPECT_EQ(found.back().mean_color, (Color{10, 20, 30}));
    EXPECT_EQ(found.back().area_px, found.front().area_px);
  }
}

TEST(BlobExtractor, LargestSumsAreExact) {
  // A solid block of 24 million pixels: the centroid is its middle, the moments are (n^2 - 1) / 12.
  const cv::Mat mask(4000, 6000, CV_8UC1, cv::Scalar(255));
  const cv::Mat frame(4000, 6000, CV_8UC1, cv::Scalar(255));
  const Detection blob = extracted(mask, frame, 0).items.at(0);
  EXPECT_EQ(blob.position, (Point{2999.5, 1999.5}));
  EXPECT_EQ(blob.mean_color, (Color{255, 255, 255}));
  EXPECT_DOUBLE_EQ(blob.moments_px2.xx, (6000.0 * 6000.0 - 1) / 12);
  EXPECT_DOUBLE_EQ(blob.moments_px2.yy, (4000.0 * 4000.0 - 1) / 12);
  EXPECT_EQ(blob.moments_px2.xy, 0.0);
}

TEST(BlobExtractor, ContoursBelongToTheirBlobs) {
  // A ring with a blob in its hole, a blob too small to count, one at the corner.
  cv::Mat mask = cv::Mat::zeros(50, 60, CV_8UC1);
  mask(cv::Rect(5, 5, 30, 30)).setTo(255);
  mask(cv::Rect(10, 10, 20, 20)).setTo(0);
  mask(cv::Rect(15, 15, 8, 6)).setTo(255);
  mask(cv::Rect(40, 2, 2, 2)).setTo(255);
  mask(cv::Rect(52, 44, 8, 6)).setTo(255);
  const Detections detections = extracted(mask, colours(mask.size(), 1), 10, true);
  ASSERT_EQ(detections.items.size(), 3U);
  ASSERT_EQ(detections.contours.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    const Box& box = detections.items[i].box;
    const cv::Rect around = cv::boundingRect(detections.contours[i]);
    EXPECT_EQ((Box{double(around.x), double(around.y), double(around.width), double(around.height)}), box) << i;
  }
  // Corner points of rectangles.
  EXPECT_EQ(detections.contours[2].size(), 4U);
  EXPECT_EQ(cv::contourArea(detections.contours[0]), 29.0 * 29.0);
}

TEST(BlobExtractor, EveryBlobOfARandomMaskHasItsContour) {
  cv::RNG random(33);
  for (int round = 0; round < 20; ++round) {
    cv::Mat noise(70, 90, CV_8UC1);
    random.fill(noise, cv::RNG::UNIFORM, 0, 100);
    const cv::Mat mask = noise < 20 + 3 * round;
    const Detections detections = extracted(mask, colours(mask.size(), 1), 2, true);
    ASSERT_EQ(detections.contours.size(), detections.items.size());
    for (std::size_t i = 0; i < detections.items.size(); ++i) {
      const cv::Rect around = cv::boundingRect(detections.contours[i]);
      const Box box{double(around.x), double(around.y), double(around.width), double(around.height)};
      ASSERT_EQ(box, detections.items[i].box) << i;
    }
  }
}

TEST(BlobExtractor, ReusesTheDetections) {
  const cv::Mat frame = colours({60, 40}, 3);
  cv::Mat mask = cv::Mat::zeros(frame.size(), CV_8UC1);
  for (int x = 0; x < 60; x += 10) mask(cv::Rect(x, 5, 6, 6)).setTo(255);
  BlobExtractor extractor(plain(30));
  Detections detections;
  detections.time_s = 1.5;
  extractor.extract(mask, frame, {}, true, detections);
  ASSERT_EQ(detections.items.size(), 6U);
  const Detection* const data = detections.items.data();
  detections.items[0].confidence = 0.25;  // what was there before does not come back
  mask(cv::Rect(30, 0, 30, 40)).setTo(0);
  extractor.extract(mask, frame, {}, false, detections);
  EXPECT_EQ(detections.items.size(), 3U);
  EXPECT_EQ(detections.items.data(), data);
  EXPECT_EQ(detections.items[0].confidence, 1.0);
  EXPECT_TRUE(detections.contours.empty());
  EXPECT_EQ(detections.time_s, 1.5);  // not its business
}

TEST(BlobExtractor, RefusesWhatItCannotRead) {
  BlobExtractor extractor({});
  Detections detections;
  const cv::Mat mask = cv::Mat::zeros(5, 6, CV_8UC1);
  EXPECT_THROW(extractor.extract(mask, colours({5, 6}, 3), {}, false, detections), InputError);
  EXPECT_THROW(extractor.extract(colours({6, 5}, 3), colours({6, 5}, 3), {}, false, detections), InputError);
  EXPECT_THROW(extractor.extract(mask, cv::Mat(), {}, false, detections), InputError);
  EXPECT_THROW(BlobExtractor(plain(-1)), ConfigError);
}

}  // namespace
}  // namespace survtrack
