// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <cstdlib>
#include <memory>
#include <new>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace survtrack::kernels {

/// Columns are computed in blocks of so many, beyond the right edge too, and read one block further.
constexpr std::ptrdiff_t flow_block = 16;

constexpr std::ptrdiff_t whole_blocks(std::ptrdiff_t columns) {
  return (columns + flow_block - 1) / flow_block * flow_block;
}

/// Zeros at first, on a cache line's start; kept while they are enough.
class AlignedFloats {
 public:
  float* at_least(std::size_t count) {
    if (count > count_) {
      constexpr std::size_t line = 64;
      memory_.reset();
      count_ = 0;
      // Zeros by calloc: large memory comes as zeros from the system, and is touched only once.
      memory_.reset(std::calloc(count * sizeof(float) + line, 1));
      if (memory_ == nullptr) throw std::bad_alloc();
      std::size_t room = count * sizeof(float) + line;
      void* start = memory_.get();
      ask_for_large_pages(start, room);
      first_ = static_cast<float*>(std::align(line, count * sizeof(float), start, room));
      count_ = count;
    }
    return first_;
  }
  const float* data() const { return first_; }
  float* data() { return first_; }

 private:
  /// Large memory in pages of megabytes, where the system has them: a page takes long to come and to find.
  static void ask_for_large_pages([[maybe_unused]] void* memory, [[maybe_unused]] std::size_t bytes) {
#if defined(__linux__)
    constexpr std::size_t page = 4096, least = std::size_t{4} << 20;
    void* start = memory;
    if (bytes >= least && std::align(page, bytes - page, start, bytes)) {
      static_cast<void>(madvise(start, bytes - bytes % page, MADV_HUGEPAGE));
    }
#endif
  }
  struct Free {
    void operator()(void* memory) const { std::free(memory); }
  };
  std::unique_ptr<void, Free> memory_;
  float* first_ = nullptr;
  std::size_t count_ = 0;
};

/// One number a pixel, with a margin of a block left and right of every row. Columns -1 and `width` repeat
/// their neighbours; the rest of the margin is never looked at, only loaded.
class FlowPlane {
 public:
  /// What was in it is lost when the size changes.
  void create(std::ptrdiff_t width, std::ptrdiff_t height) {
    stride_ = whole_blocks(width) + 2 * flow_block;
    floats_.at_least(static_cast<std::size_t>(stride_ * height));
    width_ = width;
    height_ = height;
  }
  std::ptrdiff_t width() const { return width_; }
  std::ptrdiff_t height() const { return height_; }
  std::ptrdiff_t stride() const { return stride_; }
  float* row(std::ptrdiff_t y) { return floats_.data() + y * stride_ + flow_block; }
  const float* row(std::ptrdiff_t y) const { return floats_.data() + y * stride_ + flow_block; }

  /// After the pixels of row `y` were written from outside.
  void repeat_edges(std::ptrdiff_t y) {
    row(y)[-1] = row(y)[0];
    row(y)[width_] = row(y)[width_ - 1];
  }

 private:
  AlignedFloats floats_;
  std::ptrdiff_t width_ = 0;
  std::ptrdiff_t height_ = 0;
  std::ptrdiff_t stride_ = 0;
};

/// A flow field: horizontal and vertical, px.
struct FlowPlanes {
  FlowPlane u;
  FlowPlane v;

  void create(std::ptrdiff_t width, std::ptrdiff_t height) {
    u.create(width, height);
    v.create(width, height);
  }
};

}  // namespace survtrack::kernels
