// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "survtrack/tracking/lifecycle.hpp"

#include "tracking/count_median.hpp"
#include "tracking/region_growth.hpp"
#include "tracking/single_largest.hpp"

namespace survtrack {
namespace {

constexpr double time_slack_s = 1e-6;  // frame times are sums of rounded steps

class ConfirmAndLose final : public Lifecycle {
 public:
  explicit ConfirmAndLose(const ConfirmAndLoseOptions& options) : options_(options) {}

  void update(TrackTable& table, const Detections& detections, const Matches& matches) override {
    const int open = table.size();
    for (int i = 0; i < open; ++i) {
      if (table.row(i).believed()) {
        keep_or_close(table, i, detections);
      } else {
        believe_or_close(table, i, detections);
      }
    }
    for (int d = 0; d < static_cast<int>(detections.items.size()); ++d) {
      const auto at = static_cast<std::size_t>(d);
      if (matches.track_of_detection[at] < 0 && table.accepts(detections.items[at]) &&
          !inside_a_track(table, open, d, detections)) {
        try_to_believe(table, table.start(d, detections), detections);
      }
    }
  }

 private:
  void keep_or_close(TrackTable& table, int i, const Detections& now) const {
    const Track& track = table.row(i).track;
    const double lost_s = now.time_s - track.end_time_s;
    if (track.lost_frames == 0) {
      table.set_status(i, TrackStatus::confirmed);
    } else if (lost_s > options_.max_lost_s + time_slack_s || outside_frame(track.box, now)) {
      table.set_status(i, TrackStatus::closed);
    } else {
      table.set_status(i, TrackStatus::lost);
    }
    table.set_reported(i, track.status != TrackStatus::closed && lost_s <= options_.report_lost_s + time_slack_s);
  }

  /// A tentative track ends with its first miss.
  void believe_or_close(TrackTable& table, int i, const Detections& now) const {
    if (table.row(i).track.lost_frames > 0) {
      table.set_status(i, TrackStatus::closed);
    } else {
      try_to_believe(table, i, now);
    }
  }

  void try_to_believe(TrackTable& table, int i, const Detections& now) const {
    const OpenTrack& row = table.row(i);
    if (row.track.matched_frames < options_.confirm_matches) return;
    if (now.time_s - row.track.start_time_s < options_.confirm_s - time_slack_s) return;
    if (row.travelled_px < options_.confirm_travel * row.size_px()) return;
    table.believe(i);
    table.set_reported(i, true);
  }

  bool inside_a_track(const TrackTable& table, int open, int d, const Detections& detections) const {
    const Box& box = detections.items[static_cast<std::size_t>(d)].box;
    for (int i = 0; i < open; ++i) {
      const OpenTrack& row = table.row(i);
      if (!row.believed() || row.track.lost_frames > 0) continue;
      if (intersection_px(row.track.box, box) > options_.birth_overlap * box.area_px()) return true;
    }
    return false;
  }

  ConfirmAndLoseOptions options_;
};

class LostCount final : public Lifecycle {
 public:
  explicit LostCount(const LostCountOptions& options) : options_(options) {}

  void update(TrackTable& table, const Detections& detections, const Matches& matches) override {
    for (int i = 0; i < table.size(); ++i) {
      const int lost = table.row(i).track.lost_frames;
      const TrackStatus status = lost == 0                           ? TrackStatus::confirmed
                                 : lost <= options_.lost_after_frames ? TrackStatus::lost
                                                                      : TrackStatus::closed;
      table.set_status(i, status);
      table.set_reported(i, status == TrackStatus::confirmed);
    }
    for (std::size_t d = 0; d < detections.items.size(); ++d) {
      if (matches.track_of_detection[d] >= 0 || !table.accepts(detections.items[d])) continue;
      const int i = table.start(static_cast<int>(d), detections);
      table.believe(i);
      table.set_reported(i, true);
    }
  }

 private:
  LostCountOptions options_;
};

struct MakeLifecycle {
  std::unique_ptr<Lifecycle> operator()(const ConfirmAndLoseOptions& o) const {
    return std::make_unique<ConfirmAndLose>(o);
  }
  std::unique_ptr<Lifecycle> operator()(const LostCountOptions& o) const { return std::make_unique<LostCount>(o); }
  std::unique_ptr<Lifecycle> operator()(const CountMedianOptions& o) const { return std::make_unique<CountMedian>(o); }
  std::unique_ptr<Lifecycle> operator()(const RegionGrowthOptions& o) const { return std::make_unique<RegionGrowth>(o); }
  std::unique_ptr<Lifecycle> operator()(const SingleLargestOptions& o) const {
    return std::make_unique<SingleLargest>(o);
  }
};

}  // namespace

bool outside_frame(const Box& box, const Detections& now) {
  if (now.frame_width <= 0 || now.frame_height <= 0) return false;
  const Box frame{0.0, 0.0, static_cast<double>(now.frame_width), static_cast<double>(now.frame_height)};
  return !frame.contains(box.center());
}

std::unique_ptr<Lifecycle> make_lifecycle(const LifecycleOptions& options) {
  return std::visit(MakeLifecycle{}, options);
}

}  // namespace survtrack
