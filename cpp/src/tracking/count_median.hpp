// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <vector>

#include "survtrack/tracking/lifecycle.hpp"

namespace survtrack {

/// Contact monitoring: see CountMedianOptions.
class CountMedian final : public Lifecycle {
 public:
  explicit CountMedian(const CountMedianOptions& options) : options_(options) {}
  void update(TrackTable& table, const Detections& detections, const Matches& matches) override;
  void clear() override;

 private:
  int median_with(int count);
  bool is_of_use(const Track& track, const Detections& now) const;
  void close_missing(TrackTable& table, int surplus);
  void start_newcomers(TrackTable& table, const Detections& detections, const Matches& matches, int places);

  CountMedianOptions options_;
  std::vector<int> counts_;   ///< the last ones, in a ring
  std::vector<int> sorted_;
  std::vector<int> chosen_;
  std::size_t oldest_ = 0;
};

}  // namespace survtrack
