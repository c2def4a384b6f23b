// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

// Sanitizers have an operator new of their own, with checks that the whole suite needs.
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <new>
#include <vector>

#include "survtrack/pipeline/pipeline.hpp"
#include "survtrack/tracking/path.hpp"
#include "synthetic_scene.hpp"

namespace {

// Counts this thread's calls of operator new, OpenCV's for its images' headers among them, while asked to.
thread_local bool counting = false;
thread_local std::int64_t allocations = 0;
thread_local std::size_t largest = 0;

}  // namespace

// Not inlined: the compiler would take new and free for a mismatch.
[[gnu::noinline]] void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  if (counting) {
    ++allocations;
    largest = std::max(largest, size);
  }
  return std::malloc(size == 0 ? 1 : size);
}
[[gnu::noinline]] void* operator new(std::size_t size) {
  if (void* const memory = operator new(size, std::nothrow)) return memory;
  throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

namespace survtrack {
namespace {

struct Allocations {
  std::int64_t count = 0;
  std::size_t largest = 0;  ///< bytes
};

template <class Work>
Allocations allocations_of(const Work& work) {
  allocations = 0;
  largest = 0;
  counting = true;
  work();
  counting = false;
  return {allocations, largest};
}

TEST(AllocationCount, Counts) {
  EXPECT_EQ(allocations_of([] {}).count, 0);
  std::vector<int> numbers;
  const Allocations one = allocations_of([&] { numbers.reserve(100); });
  EXPECT_EQ(one.count, 1);
  EXPECT_EQ(one.largest, 100 * sizeof(int));
  cv::Mat image;
  EXPECT_GE(allocations_of([&] { image.create(10, 10, CV_8UC1); }).count, 1);
}

TEST(Allocations, APathConvertsWithoutAny) {
  const Path path({{0, 0}, {100, 0}, {130, 60}, {0, 90}}, true, PathKind::curve);
  std::vector<Point> points(1000);
  for (std::size_t i = 0; i < points.size(); ++i) points[i] = {0.13 * static_cast<double>(i), 0.07 * static_cast<double>(i)};
  std::vector<PathPosition> places(points.size());
  EXPECT_EQ(allocations_of([&] { path.to_path(points.data(), points.size(), places.data()); }).count, 0);
  EXPECT_EQ(allocations_of([&] { path.to_image(places.data(), places.size(), points.data()); }).count, 0);
}

/// A frame's allocations in `process` with the caller's buffers, once everything has its size: a square goes
/// along, confirmed.
std::vector<Allocations> steady_state(const Config& config) {
  const SyntheticScene scene{.enters_s = 3.0, .speed_px_per_s = 15.0};
  std::vector<cv::Mat> frames;
  for (int i = 0; i < 90; ++i) frames.push_back(scene.frame(0.1 * i));
  Pipeline pipeline(config);
  FrameResult result;
  std::vector<Allocations> all;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const double time_s = 0.1 * static_cast<double>(i);
    const Allocations now = allocations_of([&] { pipeline.process(frames[i], time_s, result); });
    if (i >= 60) all.push_back(now);
  }
  EXPECT_EQ(result.tracks.size(), 1U);
  return all;
}

TEST(Process, AllocatesNothingInTheSteadyState) {
  for (const Allocations& now : steady_state(scene_config())) {
    EXPECT_EQ(now.count, 0);
    EXPECT_EQ(now.largest, 0U);
  }
}

TEST(Process, AllocatesNothingWithCleanupOverTimeAndByTiles) {
  Config config = scene_config();
  config.cleanup.temporal_median_frames = 3;
  // Left and right alike: an object that grows at a cut may need more memory.
  config.cleanup.tiling = QuadrantsOptions{.dilate_top_left_px = 14, .dilate_bottom_left_px = 15};
  for (const Allocations& now : steady_state(config)) {
    EXPECT_EQ(now.count, 0);
    EXPECT_EQ(now.largest, 0U);
  }
}

}  // namespace
}  // namespace survtrack

#endif
