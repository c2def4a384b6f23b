// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "survtrack/blobs/run_labeller.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>

#include "core/check_mask.hpp"
#include "core/mask_bits.hpp"

namespace survtrack {
namespace {

using mask_bits::word_bits;

/// Appends the runs of one row. Each bit of `edges` is a pixel unlike the one before it: runs begin and
/// end there in turn.
void append_runs(const std::uint8_t* pixels, int y, std::size_t width, std::vector<Run>& runs) {
  std::uint64_t before = 0;  // the last pixel of the word before
  const auto take_word = [&](std::uint64_t word, std::size_t x) {
    for (std::uint64_t edges = word ^ ((word << 1) | before); edges != 0; edges &= edges - 1) {
      const int edge = static_cast<int>(x) + std::countr_zero(edges);
      if (before == 0) {
        runs.push_back({y, edge, edge, 0});
      } else {
        runs.back().x_end = edge;
      }
      before ^= 1;
    }
  };
  std::size_t x = 0;
  for (; x + word_bits <= width; x += word_bits) take_word(mask_bits::pack_word(pixels + x), x);
  if (x < width) take_word(mask_bits::pack_tail(pixels + x, width - x), x);
  if (before != 0) runs.back().x_end = static_cast<int>(width);
}

}  // namespace

const std::vector<Run>& RunLabeller::label(const cv::Mat& mask) {
  check_mask(mask);
  runs_.clear();
  parent_.clear();
  std::size_t above = 0;
  std::size_t above_end = 0;
  for (int y = 0; y < mask.rows; ++y) {
    const std::size_t begin = runs_.size();
    append_runs(mask.ptr<std::uint8_t>(y), y, static_cast<std::size_t>(mask.cols), runs_);
    join(above, above_end, begin);
    above = begin;
    above_end = runs_.size();
  }
  number_components();
  return runs_;
}

/// Labels the runs from `begin` on by those of the row above, which touch when they overlap or, 8-connected, meet at
/// a corner. Both rows are walked once.
void RunLabeller::join(std::size_t above, std::size_t above_end, std::size_t begin) {
  const int overlap = connectivity_ == Connectivity::four ? 1 : 0;
  for (std::size_t i = begin; i < runs_.size(); ++i) {
    Run& run = runs_[i];
    while (above < above_end && runs_[above].x_end < run.x_begin + overlap) ++above;
    run.label = -1;
    for (std::size_t j = above; j < above_end && runs_[j].x_begin + overlap <= run.x_end; ++j) {
      run.label = run.label < 0 ? root(runs_[j].label) : unite(run.label, runs_[j].label);
    }
    if (run.label >= 0) continue;
    run.label = static_cast<int>(parent_.size());
    parent_.push_back(run.label);
  }
}

int RunLabeller::root(int label) {
  int* const parent = parent_.data();
  while (parent[label] != label) {
    parent[label] = parent[parent[label]];  // halves the path
    label = parent[label];
  }
  return label;
}

/// The smaller root stays, which is that of the earlier pixel.
int RunLabeller::unite(int a, int b) {
  const int root_a = root(a);
  const int root_b = root(b);
  const int first = std::min(root_a, root_b);
  parent_[static_cast<std::size_t>(std::max(root_a, root_b))] = first;
  return first;
}

/// Turns parents, which never come after their children, into numbers without gaps.
void RunLabeller::number_components() {
  count_ = 0;
  for (std::size_t label = 0; label < parent_.size(); ++label) {
    const auto parent = static_cast<std::size_t>(parent_[label]);
    parent_[label] = parent == label ? count_++ : parent_[parent];
  }
  for (Run& run : runs_) run.label = parent_[static_cast<std::size_t>(run.label)];
}

}  // namespace survtrack
