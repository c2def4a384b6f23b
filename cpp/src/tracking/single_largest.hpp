// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "survtrack/tracking/lifecycle.hpp"

namespace survtrack {

/// One object at a time: see SingleLargestOptions.
class SingleLargest final : public Lifecycle {
 public:
  explicit SingleLargest(const SingleLargestOptions& options) : options_(options) {}
  void update(TrackTable& table, const Detections& detections, const Matches& matches) override;
  void clear() override { missed_ = 0; }

 private:
  void go_on(TrackTable& table, const Detections& detections);
  void start(TrackTable& table, const Detections& detections);

  SingleLargestOptions options_;
  int missed_ = 0;  ///< frames in a row, up to the one before
};

}  // namespace survtrack
