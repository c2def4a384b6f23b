// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "survtrack/blobs/close_blobs.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace survtrack {
namespace {

/// Means are rounded: what is as far as the threshold is within it.
constexpr double slack = 1e-9;

bool close_in_color(const Color& a, const Color& b, double threshold) {
  const double most = threshold + slack;
  return std::abs(a.blue - b.blue) <= most && std::abs(a.green - b.green) <= most && std::abs(a.red - b.red) <= most;
}

}  // namespace

void CloseMerger::merge(const CloseMergeOptions& options, const Expectation& expectation, const cv::Mat& frame,
                        std::vector<Run>& runs, std::vector<BlobPart>& parts) {
  parent_.resize(parts.size());
  std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  measure(frame, runs, parts);
  join_close(options, expectation);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const std::size_t into = root(i);
    if (into == i) continue;
    parts[into].add(parts[i]);
    parts[i].dropped = true;
  }
  for (Run& run : runs) run.label = static_cast<int>(root(static_cast<std::size_t>(run.label)));
}

/// Centroids and mean colours of the parts that are left, from top to bottom.
void CloseMerger::measure(const cv::Mat& frame, const std::vector<Run>& runs, const std::vector<BlobPart>& parts) {
  blobs_.assign(parts.size(), Blob{});
  const int channels = frame.channels();
  for (const Run& run : runs) {
    const auto part = static_cast<std::size_t>(run.label);
    if (parts[part].dropped) continue;
    Blob& blob = blobs_[part];
    const double length = run.x_end - run.x_begin;
    blob.centroid.x += 0.5 * (run.x_begin + run.x_end - 1) * length;
    blob.centroid.y += run.y * length;
    const std::uint8_t* pixel = frame.ptr<std::uint8_t>(run.y) + std::ptrdiff_t{run.x_begin} * channels;
    int blue = 0;
    int green = 0;
    int red = 0;
    for (int x = run.x_begin; x < run.x_end; ++x, pixel += channels) {
      blue += pixel[0];
      green += pixel[channels / 2];
      red += pixel[channels - 1];
    }
    blob.mean_color.blue += blue;
    blob.mean_color.green += green;
    blob.mean_color.red += red;
  }
  std::size_t kept = 0;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (parts[i].dropped || parts[i].area_px == 0) continue;
    Blob blob = blobs_[i];
    const double scale = 1.0 / static_cast<double>(parts[i].area_px);
    blob.part = i;
    blob.centroid = scale * blob.centroid;
    blob.mean_color = {scale * blob.mean_color.blue, scale * blob.mean_color.green, scale * blob.mean_color.red};
    blobs_[kept++] = blob;
  }
  blobs_.resize(kept);
  std::sort(blobs_.begin(), blobs_.end(), [](const Blob& a, const Blob& b) {
    return a.centroid.y != b.centroid.y ? a.centroid.y < b.centroid.y : a.part < b.part;
  });
}

void CloseMerger::join_close(const CloseMergeOptions& options, const Expectation& expectation) {
  const VicinityGrid* const grid =
      options.vicinity_scaled && expectation.vicinity ? &*expectation.vicinity : nullptr;
  const double reach = options.threshold_y_px * (grid == nullptr ? 1.0 : grid->max_factor) + slack;
  for (std::size_t i = 0; i < blobs_.size(); ++i) {
    const Blob& a = blobs_[i];
    for (std::size_t j = i + 1; j < blobs_.size() && blobs_[j].centroid.y - a.centroid.y <= reach; ++j) {
      const Blob& b = blobs_[j];
      double threshold_y = options.threshold_y_px;
      double threshold_x = options.threshold_x_px;
      if (grid != nullptr) {
        const VicinityCell& cell = grid->at(0.5 * (a.centroid + b.centroid));
        threshold_y *= cell.factor_y;
        threshold_x *= cell.factor_x;
      }
      const bool close = b.centroid.y - a.centroid.y <= threshold_y + slack &&
                         std::abs(b.centroid.x - a.centroid.x) <= threshold_x + slack &&
                         close_in_color(a.mean_color, b.mean_color, options.color_threshold);
      if (!close) continue;
      const std::size_t one = root(a.part);
      const std::size_t other = root(b.part);
      parent_[std::max(one, other)] = std::min(one, other);
    }
  }
}

std::size_t CloseMerger::root(std::size_t part) {
  while (parent_[part] != part) {
    parent_[part] = parent_[parent_[part]];
    part = parent_[part];
  }
  return part;
}

}  // namespace survtrack
