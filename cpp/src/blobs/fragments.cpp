// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "survtrack/blobs/fragments.hpp"

#include <algorithm>
#include <numeric>
#include <optional>

namespace survtrack {
namespace {

constexpr double min_overlap = 0.3;      // of the narrower one's width, for two that stand above each other
constexpr double min_held = 0.3;         // of the joint box, for a track to say how high it may be
constexpr double height_tolerance = 1.2;  // objects bend and stretch

/// Height of the object that should stand where `box` is.
std::optional<double> expected_height(const Box& box, const Expectation& expectation) {
  double most = min_held;
  std::optional<double> height;
  for (const PredictedTrack& track : expectation.tracks) {
    if (!track.confirmed) continue;
    const double held = intersection_px(track.box, box) / box.area_px();
    if (held <= most) continue;
    most = held;
    height = track.box.height;
  }
  if (!height && expectation.scale.known) height = expectation.scale.height_px(box.bottom());
  return height;
}

bool belong_together(const BlobPart& a, const BlobPart& b, const FragmentMergeOptions& options, const Expectation& expectation) {
  const double overlap = std::min(a.right, b.right) - std::max(a.left, b.left);
  if (overlap <= min_overlap * std::min(a.right - a.left, b.right - b.left)) return false;
  BlobPart joint = a;
  joint.add(b);
  const Box box = joint.box();
  const std::optional<double> height = expected_height(box, expectation);
  const double gap = std::max(a.top, b.top) - std::min(a.bottom, b.bottom);
  const double reference = height.value_or(std::max(a.bottom - a.top, b.bottom - b.top));
  return gap < options.gap * reference && (!height || box.height < height_tolerance * *height);
}

}  // namespace

void FragmentMerger::merge(const FragmentMergeOptions& options, const Expectation& expectation, std::vector<Run>& runs,
                           std::vector<BlobPart>& parts) {
  open_.clear();
  target_.resize(parts.size());
  std::iota(target_.begin(), target_.end(), 0);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (!parts[i].dropped) open_.push_back(i);
  }
  // From left to right: what begins beyond a fragment's right edge is not above or below it.
  std::sort(open_.begin(), open_.end(), [&](std::size_t a, std::size_t b) {
    return parts[a].left != parts[b].left ? parts[a].left < parts[b].left : a < b;
  });
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t i = 0; i < open_.size(); ++i) {
      for (std::size_t j = i + 1; j < open_.size() && parts[open_[j]].left < parts[open_[i]].right;) {
        if (!belong_together(parts[open_[i]], parts[open_[j]], options, expectation)) {
          ++j;
          continue;
        }
        parts[open_[i]].add(parts[open_[j]]);
        parts[open_[j]].dropped = true;
        target_[open_[j]] = static_cast<int>(open_[i]);
        open_.erase(open_.begin() + static_cast<std::ptrdiff_t>(j));
        changed = true;
        j = i + 1;
      }
    }
  }
  for (Run& run : runs) run.label = final_label(run.label);
}

int FragmentMerger::final_label(int label) const {
  while (target_[static_cast<std::size_t>(label)] != label) label = target_[static_cast<std::size_t>(label)];
  return label;
}

}  // namespace survtrack
