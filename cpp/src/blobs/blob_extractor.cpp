// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "survtrack/blobs/blob_extractor.hpp"

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <sstream>

#include "core/check_mask.hpp"

namespace survtrack {
namespace {

/// 0^2 + 1^2 + ... + (n - 1)^2.
std::int64_t squares_below(std::int64_t n) { return (n - 1) * n * (2 * n - 1) / 6; }

void check_inputs(const cv::Mat& mask, const cv::Mat& frame) {
  check_mask(mask);
  check_image(frame);
  if (mask.size() == frame.size()) return;
  std::ostringstream text;
  text << "mask: is " << mask.rows << "x" << mask.cols << ", the frame " << frame.rows << "x" << frame.cols
       << "; expected the same size";
  throw InputError(text.str());
}

}  // namespace

BlobExtractor::BlobExtractor(const BlobOptions& options) : options_(options), labeller_(options.connectivity) {
  check_fields(options);
}

void BlobExtractor::extract(const cv::Mat& mask, const cv::Mat& frame, const Expectation& expectation, bool contours,
                            Detections& detections) {
  check_inputs(mask, frame);
  runs_ = labeller_.label(mask);
  measure_parts(runs_, labeller_.count(), parts_);
  const double frame_area_px = static_cast<double>(mask.rows) * mask.cols;
  const double min_area_px = std::max(options_.min_area_px, options_.min_area_fraction * frame_area_px);
  merge(frame, expectation, min_area_px);
  if (options_.share_blobs) sharer_.share(options_, expectation, min_area_px, runs_, parts_);
  drop_unexpected(expectation, min_area_px, mask.size());
  drop_beyond_count();
  const int kept = number_blobs();
  add_shapes(runs_);
  add_colors(runs_, frame);
  detections.items.resize(static_cast<std::size_t>(kept));
  for (std::size_t i = 0; i < sums_.size(); ++i) {
    if (sums_[i].detection < 0) continue;
    Detection& detection = detections.items[static_cast<std::size_t>(sums_[i].detection)];
    detection = detection_of(sums_[i]);
    detection.shared = parts_[i].shared;
  }
  detections.contours.clear();
  if (contours) find_contours(detections.items, detections.contours);
}

void BlobExtractor::merge(const cv::Mat& frame, const Expectation& expectation, double min_area_px) {
  if (const auto* fragments = std::get_if<FragmentMergeOptions>(&options_.merge)) {
    drop_below(fragments->min_fragment_fraction * static_cast<double>(frame.total()));
    fragments_.merge(*fragments, expectation, runs_, parts_);
  } else if (const auto* close = std::get_if<CloseMergeOptions>(&options_.merge)) {
    drop_below(min_area_px);  // noise would be a bridge
    close_.merge(*close, expectation, frame, runs_, parts_);
  }
}

void BlobExtractor::drop_below(double area_px) {
  for (BlobPart& part : parts_) part.dropped = part.dropped || static_cast<double>(part.area_px) < area_px;
}

/// What no track expects must be large enough, and as high as objects are there unless the border cuts it.
void BlobExtractor::drop_unexpected(const Expectation& expectation, double min_area_px, const cv::Size& size) {
  for (BlobPart& part : parts_) {
    if (part.dropped || part.expected) continue;
    const Box box = part.box();
    const bool low = expectation.scale.known && !touches_border(box, size.width, size.height) &&
                     box.height < options_.min_relative_height * expectation.scale.height_px(box.bottom());
    part.dropped = low || static_cast<double>(part.area_px) < min_area_px;
  }
}

/// Keeps the largest ones; of equal ones the first.
void BlobExtractor::drop_beyond_count() {
  remaining_.clear();
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    if (!parts_[i].dropped && parts_[i].area_px > 0) remaining_.push_back(i);
  }
  const auto most = static_cast<std::size_t>(options_.max_blobs);
  if (remaining_.size() <= most) return;
  std::sort(remaining_.begin(), remaining_.end(), [&](std::size_t a, std::size_t b) {
    return parts_[a].area_px != parts_[b].area_px ? parts_[a].area_px > parts_[b].area_px : a < b;
  });
  for (std::size_t i = most; i < remaining_.size(); ++i) parts_[remaining_[i]].dropped = true;
}

/// Numbers the blobs that remain, in the order of their labels.
int BlobExtractor::number_blobs() {
  sums_.assign(parts_.size(), Sums{});
  int kept = 0;
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    if (parts_[i].dropped || parts_[i].area_px == 0) continue;
    sums_[i].area = parts_[i].area_px;
    sums_[i].detection = kept++;
  }
  return kept;
}

void BlobExtractor::add_shapes(const std::vector<Run>& runs) {
  for (const Run& run : runs) {
    Sums& sums = sums_[static_cast<std::size_t>(run.label)];
    if (sums.detection < 0) continue;
    const std::int64_t y = run.y;
    const std::int64_t length = run.x_end - run.x_begin;
    const std::int64_t x_sum = (run.x_begin + run.x_end - std::int64_t{1}) * length / 2;
    sums.x += x_sum;
    sums.y += y * length;
    sums.xx += squares_below(run.x_end) - squares_below(run.x_begin);
    sums.xy += y * x_sum;
    sums.yy += y * y * length;
    const bool first = sums.right == 0;
    sums.left = first ? run.x_begin : std::min(sums.left, run.x_begin);
    sums.right = std::max(sums.right, run.x_end);
    sums.top = first ? run.y : sums.top;
    sums.bottom = run.y + 1;
  }
}

void BlobExtractor::add_colors(const std::vector<Run>& runs, const cv::Mat& frame) {
  const int channels = frame.channels();
  for (const Run& run : runs) {
    Sums& sums = sums_[static_cast<std::size_t>(run.label)];
    if (sums.detection < 0) continue;
    const std::uint8_t* const pixels = frame.ptr<std::uint8_t>(run.y) + std::ptrdiff_t{run.x_begin} * channels;
    const int count = run.x_end - run.x_begin;
    int blue = 0;
    int green = 0;
    int red = 0;
    if (channels == 1) {
      for (int i = 0; i < count; ++i) blue += pixels[i];
      green = red = blue;
    } else {
      for (int i = 0; i < count; ++i) {
        blue += pixels[3 * i];
        green += pixels[3 * i + 1];
        red += pixels[3 * i + 2];
      }
    }
    sums.blue += blue;
    sums.green += green;
    sums.red += red;
  }
}

void BlobExtractor::histograms(const cv::Mat& frame, std::vector<ColorHistogram>& histograms) {
  int count = 0;
  for (const Sums& sums : sums_) count = std::max(count, sums.detection + 1);
  counters_.assign(static_cast<std::size_t>(count), ColorCounter{});
  const int channels = frame.channels();
  for (const Run& run : runs_) {
    const int detection = sums_[static_cast<std::size_t>(run.label)].detection;
    if (detection < 0) continue;
    counters_[static_cast<std::size_t>(detection)].add(frame.ptr<std::uint8_t>(run.y) + std::ptrdiff_t{run.x_begin} * channels,
                                                       run.x_end - run.x_begin, channels);
  }
  histograms.clear();
  for (const ColorCounter& counter : counters_) histograms.push_back(counter.histogram());
}

Detection BlobExtractor::detection_of(const Sums& sums) {
  const auto area = static_cast<double>(sums.area);
  // Moments about whole pixels near the centroid are exact integers; only the rest is rounded.
  const std::int64_t x0 = sums.x / sums.area;
  const std::int64_t y0 = sums.y / sums.area;
  const std::int64_t dx = sums.x - x0 * sums.area;
  const std::int64_t dy = sums.y - y0 * sums.area;
  const auto central = [&](std::int64_t about, std::int64_t da, std::int64_t db) {
    return (static_cast<double>(about) - static_cast<double>(da) * static_cast<double>(db) / area) / area;
  };
  Detection detection;
  detection.box = {static_cast<double>(sums.left), static_cast<double>(sums.top),
                   static_cast<double>(sums.right - sums.left), static_cast<double>(sums.bottom - sums.top)};
  detection.position = {static_cast<double>(sums.x) / area, static_cast<double>(sums.y) / area};
  detection.area_px = area;
  detection.mean_color = {static_cast<double>(sums.blue) / area, static_cast<double>(sums.green) / area,
                          static_cast<double>(sums.red) / area};
  detection.moments_px2 = {central(sums.xx - x0 * (sums.x + dx), dx, dx),
                           central(sums.xy - x0 * sums.y - y0 * dx, dx, dy),
                           central(sums.yy - y0 * (sums.y + dy), dy, dy)};
  return detection;
}

/// Draws each blob's runs on a picture of its own; of a blob of several fragments the longest contour counts.
void BlobExtractor::find_contours(const std::vector<Detection>& items,
                                  std::vector<std::vector<cv::Point>>& contours) const {
  contours.resize(items.size());
  std::vector<cv::Mat> pictures(items.size());
  for (std::size_t i = 0; i < items.size(); ++i) {
    pictures[i] = cv::Mat::zeros(static_cast<int>(items[i].box.height), static_cast<int>(items[i].box.width), CV_8UC1);
  }
  for (const Run& run : runs_) {
    const int detection = sums_[static_cast<std::size_t>(run.label)].detection;
    if (detection < 0) continue;
    const Box& box = items[static_cast<std::size_t>(detection)].box;
    std::uint8_t* const row = pictures[static_cast<std::size_t>(detection)].ptr(run.y - static_cast<int>(box.y));
    std::fill(row + run.x_begin - static_cast<int>(box.x), row + run.x_end - static_cast<int>(box.x), std::uint8_t{255});
  }
  for (std::size_t i = 0; i < items.size(); ++i) {
    const cv::Point origin(static_cast<int>(items[i].box.x), static_cast<int>(items[i].box.y));
    std::vector<std::vector<cv::Point>> found;
    cv::findContours(pictures[i], found, cv::RETR_EXTERNAL, cv::CHAIN_APPROX_SIMPLE, origin);
    contours[i] = *std::max_element(found.begin(), found.end(), [](const auto& a, const auto& b) {
      return cv::contourArea(a) < cv::contourArea(b);
    });
  }
}

}  // namespace survtrack
