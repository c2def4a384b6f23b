// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "offline/way_groups.hpp"

#include <algorithm>
#include <cmath>

namespace survtrack {
namespace {

constexpr int most_rounds = 30;

/// Of all pairs most are far apart, which their middles tell: these are no farther from each other than the ways are on
/// average. Side by side in memory they take a tenth of the time.
class SameWay {
 public:
  SameWay(const std::vector<Way>& ways, const PatternOptions& options) : ways_(ways), options_(options) {
    for (const Way& way : ways) middles_.push_back({way.middle, way.size_px});
  }

  bool operator()(std::size_t a, std::size_t b) const {
    const Point apart = middles_[a].place - middles_[b].place;
    const double most = rounding * limit_px(middles_[a].size_px, middles_[b].size_px, options_);
    return apart.x * apart.x + apart.y * apart.y <= most * most && same_way(ways_[a], ways_[b], options_);
  }

 private:
  struct Middle {
    Point place;
    double size_px;
  };
  static constexpr double rounding = 1.001;
  const std::vector<Way>& ways_;
  const PatternOptions& options_;
  std::vector<Middle> middles_;
};

/// Each leader with all that go its way and are not yet taken; leaders are those with most of them.
std::vector<WayGroup> led_groups(const std::vector<Way>& ways, const PatternOptions& options) {
  const std::size_t count = ways.size();
  const SameWay same(ways, options);
  WayGroup free(count);
  std::vector<int> alike(count, 1);  // itself
  for (std::size_t a = 0; a < count; ++a) {
    free[a] = a;
    for (std::size_t b = a + 1; b < count; ++b) {
      if (!same(a, b)) continue;
      ++alike[a];
      ++alike[b];
    }
  }
  std::vector<WayGroup> groups;
  while (!free.empty()) {
    const std::size_t leader =
        *std::max_element(free.begin(), free.end(), [&](std::size_t a, std::size_t b) { return alike[a] < alike[b]; });
    if (alike[leader] < options.min_tracks) break;
    const auto rest = std::stable_partition(free.begin(), free.end(), [&](std::size_t a) {
      return a != leader && !same(leader, a);
    });
    groups.emplace_back(rest, free.end());
    free.erase(rest, free.end());
    for (const std::size_t gone : groups.back()) {
      for (const std::size_t a : free) alike[a] -= same(gone, a) ? 1 : 0;
    }
  }
  return groups;
}

/// Each way in the group whose mean is nearest, if one is near enough.
std::vector<WayGroup> regrouped(const std::vector<Way>& ways, const std::vector<WayGroup>& groups,
                                const PatternOptions& options) {
  std::vector<Way> means;
  for (const WayGroup& group : groups) {
    means.push_back(way_along(Polyline(mean_points(ways, group)), options.points, mean_size_px(ways, group)));
  }
  std::vector<WayGroup> next(groups.size());
  for (std::size_t a = 0; a < ways.size(); ++a) {
    double least = HUGE_VAL;
    std::size_t nearest = means.size();
    for (std::size_t k = 0; k < means.size(); ++k) {
      if (!same_way(ways[a], means[k], options)) continue;
      const double distance = distance_between(ways[a], means[k]);
      if (distance >= least) continue;
      least = distance;
      nearest = k;
    }
    if (nearest < means.size()) next[nearest].push_back(a);
  }
  return next;
}

}  // namespace

std::vector<WayGroup> group_ways(const std::vector<Way>& ways, const PatternOptions& options) {
  std::vector<WayGroup> groups = led_groups(ways, options);
  for (int round = 0; round < most_rounds; ++round) {
    std::vector<WayGroup> next = regrouped(ways, groups, options);
    const auto too_small = [&](const WayGroup& group) { return static_cast<int>(group.size()) < options.min_tracks; };
    next.erase(std::remove_if(next.begin(), next.end(), too_small), next.end());
    const bool settled = next == groups;
    groups = std::move(next);
    if (settled) break;
  }
  std::sort(groups.begin(), groups.end(), [](const WayGroup& a, const WayGroup& b) {
    return a.size() != b.size() ? a.size() > b.size() : a.front() < b.front();
  });
  return groups;
}

std::vector<Point> mean_points(const std::vector<Way>& ways, const WayGroup& group) {
  // From the first way's points, so that large places lose no digits.
  const std::vector<Point>& origin = ways[group.front()].points;
  const double part = 1.0 / static_cast<double>(group.size());
  std::vector<Point> mean = origin;
  for (const std::size_t a : group) {
    for (std::size_t i = 0; i < mean.size(); ++i) mean[i] = mean[i] + part * (ways[a].points[i] - origin[i]);
  }
  return mean;
}

double mean_size_px(const std::vector<Way>& ways, const WayGroup& group) {
  double sum = 0.0;
  for (const std::size_t a : group) sum += ways[a].size_px;
  return sum / static_cast<double>(group.size());
}

}  // namespace survtrack
