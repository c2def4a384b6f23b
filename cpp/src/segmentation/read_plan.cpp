// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "survtrack/segmentation/read_plan.hpp"

#include <algorithm>

namespace survtrack {

void ReadPlan::clear(const cv::Size& size) {
  size_ = size;
  whole_ = false;
  rects_.clear();
  strip_ = {0, 0};
  elapsed_s_ = 0.0;
  bands_.clear();
  spans_.clear();
  pixels_ = 0;
  pieces_ = 0;
}

void ReadPlan::read_whole(const cv::Size& size) {
  clear(size);
  add({0, 0, size.width, size.height});
  finish();
}

std::int64_t ReadPlan::whole_cost_px(const cv::Size& size) { return (size.width + piece_cost_px) * size.height; }

void ReadPlan::add(const cv::Rect& rect) {
  const cv::Rect inside = rect & cv::Rect(0, 0, size_.width, size_.height);
  if (!inside.empty()) rects_.push_back(inside);
}

void ReadPlan::refresh(int top, int bottom, double elapsed_s) {
  strip_ = {std::max(top, 0), std::min(bottom, size_.height)};
  elapsed_s_ = elapsed_s;
}

void ReadPlan::finish() {
  edges_.clear();
  for (const cv::Rect& rect : rects_) {
    edges_.push_back(rect.y);
    edges_.push_back(rect.y + rect.height);
  }
  if (!strip_.empty()) {
    edges_.push_back(strip_.start);
    edges_.push_back(strip_.end);
  }
  std::sort(edges_.begin(), edges_.end());
  edges_.erase(std::unique(edges_.begin(), edges_.end()), edges_.end());
  for (std::size_t i = 0; i + 1 < edges_.size(); ++i) add_band(edges_[i], edges_[i + 1]);
  whole_ = pixels_ == static_cast<std::int64_t>(size_.width) * size_.height;
}

/// Between two edges the same rectangles are there in every row.
void ReadPlan::add_band(int top, int bottom) {
  row_.clear();
  for (const cv::Rect& rect : rects_) {
    if (rect.y <= top && bottom <= rect.y + rect.height) row_.emplace_back(rect.x, rect.x + rect.width);
  }
  std::sort(row_.begin(), row_.end(), [](const cv::Range& a, const cv::Range& b) { return a.start < b.start; });
  const bool refreshed = strip_.start <= top && bottom <= strip_.end;
  const std::size_t first = spans_.size();
  int read = 0;   // columns from here on are not yet in a span
  int count = 0;  // pixels of a row
  const auto append = [&](int begin, int end, bool refresh) {
    count += end - begin;
    if (spans_.size() > first && spans_.back().end == begin && spans_.back().refresh == refresh) {
      spans_.back().end = end;
    } else {
      spans_.push_back({begin, end, refresh});
    }
  };
  for (const cv::Range& part : row_) {
    if (refreshed && part.start > read) append(read, part.start, true);
    const int begin = std::max(part.start, read);
    if (part.end > begin) append(begin, part.end, false);
    read = std::max(read, part.end);
  }
  if (refreshed && read < size_.width) append(read, size_.width, true);
  if (spans_.size() == first) return;
  bands_.push_back({top, bottom, first, spans_.size()});
  pixels_ += static_cast<std::int64_t>(count) * (bottom - top);
  pieces_ += static_cast<std::int64_t>(spans_.size() - first) * (bottom - top);
}

}  // namespace survtrack
