// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <atomic>

/// One binary for every CPU: a loop written once in plain C++ is compiled for several instruction
/// sets, and the best one that the CPU has is chosen when it is called.
///
///     struct AddKernel {
///       SURVTRACK_SIMD_INLINE void operator()(const Args& args) const {
///         SURVTRACK_SIMD_LOOP for (...) ...
///       }
///     };
///     void add(const Args& args) { simd::run<AddKernel>(args); }
///
/// Explicit dispatch rather than gcc's `target_clones`: it also works without glibc, with clang and
/// with the thread sanitizer, and tests can ask for every level.

#if defined(__GNUC__) || defined(__clang__)
#define SURVTRACK_SIMD_INLINE inline __attribute__((always_inline))
#else
#define SURVTRACK_SIMD_INLINE inline
#endif

/// Before a loop without dependences between its iterations: spares the checks for overlapping arrays.
#if defined(__clang__)
#define SURVTRACK_SIMD_LOOP _Pragma("clang loop vectorize(assume_safety)")
#elif defined(__GNUC__)
#define SURVTRACK_SIMD_LOOP _Pragma("GCC ivdep")
#else
#define SURVTRACK_SIMD_LOOP
#endif

#if defined(__x86_64__) && (defined(__GNUC__) || defined(__clang__))
#define SURVTRACK_SIMD_X86 1
#else
#define SURVTRACK_SIMD_X86 0
#endif

namespace survtrack::simd {

/// Asks for the cache line that holds this address.
inline void prefetch([[maybe_unused]] const void* address) {
#if defined(__GNUC__) || defined(__clang__)
  __builtin_prefetch(address);
#endif
}

/// Instruction sets, each including the ones before; baseline is what the compiler may always use.
enum class Level { baseline, avx2, avx512 };

/// The best level this CPU has.
inline Level best_level() {
#if SURVTRACK_SIMD_X86
  if (__builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512vl") &&
      __builtin_cpu_supports("avx512dq")) {
    return Level::avx512;
  }
  if (__builtin_cpu_supports("avx2")) return Level::avx2;
#endif
  return Level::baseline;
}

namespace detail {
inline std::atomic<Level>& level_in_use() {
  static std::atomic<Level> level{best_level()};
  return level;
}
}  // namespace detail

/// The level in use; every level gives the same bytes.
inline Level level() { return detail::level_in_use().load(std::memory_order_relaxed); }

/// For tests and benchmarks: uses `level`, which must not be above `best_level()`.
inline void set_level(Level level) { detail::level_in_use().store(level, std::memory_order_relaxed); }

#if SURVTRACK_SIMD_X86
namespace detail {
template <class Kernel, class... Args>
__attribute__((target("avx2"))) void run_avx2(const Args&... args) {
  Kernel{}(args...);
}
template <class Kernel, class... Args>
__attribute__((target("avx2,avx512f,avx512bw,avx512vl,avx512dq"))) void run_avx512(const Args&... args) {
  Kernel{}(args...);
}
}  // namespace detail
#endif

/// Calls `Kernel{}(args...)`, compiled for the level in use. Its call operator is marked
/// SURVTRACK_SIMD_INLINE and returns nothing.
template <class Kernel, class... Args>
void run(const Args&... args) {
#if SURVTRACK_SIMD_X86
  switch (level()) {
    case Level::avx512: return detail::run_avx512<Kernel>(args...);
    case Level::avx2: return detail::run_avx2<Kernel>(args...);
    case Level::baseline: break;
  }
#endif
  Kernel{}(args...);
}

/// Calls `Kernel<level>{}(args...)` for the level in use: for kernels that are written for its registers.
template <template <Level> class Kernel, class... Args>
void run_for_level(const Args&... args) {
#if SURVTRACK_SIMD_X86
  switch (level()) {
    case Level::avx512: return detail::run_avx512<Kernel<Level::avx512>>(args...);
    case Level::avx2: return detail::run_avx2<Kernel<Level::avx2>>(args...);
    case Level::baseline: break;
  }
#endif
  Kernel<Level::baseline>{}(args...);
}

}  // namespace survtrack::simd
