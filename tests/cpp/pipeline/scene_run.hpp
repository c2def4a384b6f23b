// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <string>
#include <utility>
#include <vector>

#include "fingerprint.hpp"
#include "survtrack/pipeline/pipeline.hpp"
#include "synthetic_scene.hpp"

namespace survtrack {

/// All results of the frames at some times, those that come after the end among them.
inline std::vector<FrameResult> run_scene(Pipeline& pipeline, const SyntheticScene& scene,
                                          const std::vector<double>& times_s) {
  std::vector<FrameResult> results;
  for (const double time_s : times_s) {
    if (auto result = pipeline.process(scene.frame(time_s), time_s)) results.push_back(std::move(*result));
  }
  for (FrameResult& result : pipeline.finish()) results.push_back(std::move(result));
  return results;
}

/// Times of a steady rate, from 0.
inline std::vector<double> steady_times(double frames_per_s, int count) {
  std::vector<double> times_s;
  for (int i = 0; i < count; ++i) times_s.push_back(i / frames_per_s);
  return times_s;
}

inline std::string fingerprint(const std::vector<FrameResult>& results) {
  std::string text;
  for (const FrameResult& result : results) text += fingerprint(result);
  return text;
}

}  // namespace survtrack
