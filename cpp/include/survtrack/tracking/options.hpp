// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <array>
#include <utility>
#include <variant>

#include "survtrack/core/fields.hpp"

namespace survtrack {

/// A track's position is the detection's centroid and its box the detection's box (Narayana 2007, 3.4).
struct CentroidOptions {
  static constexpr const char* model = "centroid";
  static constexpr const char* meaning = "the centroid of the blob; its box as it is (Narayana 2007, 3.4)";
  static constexpr auto fields() { return std::make_tuple(); }
};

/// A track's position is the centre of its box, whose size is a running mean. In a share of a blob that several
/// tracks cover, edges may be hidden: the one that fits the prediction better counts.
struct BoxCenterOptions {
  static constexpr const char* model = "box_center";
  static constexpr const char* meaning = "the centre of the box; its size is a running mean, hidden edges are inferred";

  double size_time_s = 0.5;
  double shared_size_gain = 0.25;
  double hidden_below = 0.85;

  static constexpr auto fields() {
    using O = BoxCenterOptions;
    return std::make_tuple(
        field("size_time_s", &O::size_time_s, "s", "time constant of the mean of width and height", above_up_to(0, 1e6)),
        field("shared_size_gain", &O::shared_size_gain, "", "weight of a share's size in that mean", between(0, 1)),
        field("hidden_below", &O::hidden_below, "",
              "a share's side that is shorter than this part of the track's is partly hidden", between(0, 1)));
  }
};

using MeasurementOptions = std::variant<BoxCenterOptions, CentroidOptions>;

/// The default lifecycle: a track is believed after some matches and some time, is predicted while it is
/// lost, and closed when it was lost for too long or left the frame.
struct ConfirmAndLoseOptions {
  static constexpr const char* model = "confirm_and_lose";
  static constexpr const char* meaning = "confirmed after some matches, predicted while lost, closed after a time";

  int confirm_matches = 3;
  double confirm_s = 0.4;
  double confirm_travel = 0.3;
  double report_lost_s = 0.5;
  double max_lost_s = 2.5;
  double birth_overlap = 0.5;

  static constexpr auto fields() {
    using O = ConfirmAndLoseOptions;
    return std::make_tuple(
        field("confirm_matches", &O::confirm_matches, "frames", "matches in a row before a track is believed",
              between(1, 1e6)),
        field("confirm_s", &O::confirm_s, "s", "age before a track is believed", between(0, 1e6)),
        field("confirm_travel", &O::confirm_travel, "object sizes",
              "distance from its first place before a track is believed; what does not travel is no object",
              between(0, 1e6)),
        field("report_lost_s", &O::report_lost_s, "s", "a lost track is reported, at its prediction, for so long",
              between(0, 1e6)),
        field("max_lost_s", &O::max_lost_s, "s", "a track lost for longer is closed", between(0, 1e6)),
        field("birth_overlap", &O::birth_overlap, "",
              "a detection that lies in a matched track's box by more than this part of its area starts no track",
              between(0, 1)));
  }
};

/// Narayana 2007, 3.5.4: every blob without a track starts one, a track lost for more than L frames is deleted.
struct LostCountOptions {
  static constexpr const char* model = "lost_count";
  static constexpr const char* meaning = "a track a blob at once; deleted after more than L misses (Narayana 2007, 3.5.4)";

  int lost_after_frames = 5;

  static constexpr auto fields() {
    using O = LostCountOptions;
    return std::make_tuple(field("lost_after_frames", &O::lost_after_frames, "frames",
                                 "L: the next miss in a row closes a track", between(0, 1e6)));
  }
};

/// Contact monitoring (Semko 2007, IV.C.2; Suliman et al. 2010): there are as many contacts as the running median of the
/// detections' count says. A missing contact is predicted until the median falls.
struct CountMedianOptions {
  static constexpr const char* model = "count_median";
  static constexpr const char* meaning =
      "as many tracks as the running median of the detections' count (Semko 2007, IV.C.2)";

  int median_frames = 25;
  int max_contacts = 10;
  bool keep_contacts = false;
  double restart_after_s = 0.0;

  static constexpr auto fields() {
    using O = CountMedianOptions;
    return std::make_tuple(
        field("median_frames", &O::median_frames, "frames", "length of the median of the count; 0 and 1: the count itself",
              odd_up_to(99999)),
        field("max_contacts", &O::max_contacts, "", "most tracks at a time", between(1, 100000)),
        field("keep_contacts", &O::keep_contacts, "",
              "a missing contact is predicted for ever, and the next newcomer is taken for it (Suliman et al. 2010)"),
        field("restart_after_s", &O::restart_after_s, "s",
              "a kept contact that was missing for longer starts anew where it is seen; 0: it never does", between(0, 1e6)));
  }
};

/// O'Malley 2000: who crosses an acquisition region is followed; a track that is not found is at its prediction, while
/// its covariance and with it its region grow, and is lost after a limit.
struct RegionGrowthOptions {
  static constexpr const char* model = "region_growth";
  static constexpr const char* meaning =
      "followed from an acquisition region on; predicted while not found, up to a limit (O'Malley 2000)";

  int lost_after_frames = 15;
  int max_objects = 100;

  static constexpr auto fields() {
    using O = RegionGrowthOptions;
    return std::make_tuple(
        field("lost_after_frames", &O::lost_after_frames, "frames", "the next miss in a row closes a track", between(0, 1e6)),
        field("max_objects", &O::max_objects, "", "most tracks at a time", between(1, 100000)));
  }
};

/// One object at a time (Nashenda 2011): the largest detection starts its track, which is predicted in every frame without
/// one. With assignment.model largest the largest detection is also its measurement in each frame.
struct SingleLargestOptions {
  static constexpr const char* model = "single_largest";
  static constexpr const char* meaning = "one track at a time, started by the largest detection (Nashenda 2011)";

  int lost_after_frames = 0;
  int restart_after_frames = 0;

  static constexpr auto fields() {
    using O = SingleLargestOptions;
    return std::make_tuple(
        field("lost_after_frames", &O::lost_after_frames, "frames",
              "the next miss in a row closes the track; 0: it is predicted for ever", between(0, 1e6)),
        field("restart_after_frames", &O::restart_after_frames, "frames",
              "a track that missed more starts anew where it is seen; 0: it never does", between(0, 1e6)));
  }
};

using LifecycleOptions = std::variant<ConfirmAndLoseOptions, LostCountOptions, CountMedianOptions, RegionGrowthOptions,
                                      SingleLargestOptions>;

/// No vicinity factor is learned.
struct NoVicinityOptions {
  static constexpr const char* model = "none";
  static constexpr const char* meaning = "no vicinity factor";
  static constexpr auto fields() { return std::make_tuple(); }
};

/// How the factor v of a cell follows a displacement d, px per time unit.
enum class VicinityForm {
  settling,            ///< v += rate (target - v), target = clip(v0 |d| / m, 1, largest)
  published_constant,  ///< v += (|d| - 1) largest rate (Narayana 2007, eq. 6.4)
  published_mean,      ///< v += (|d| - m) largest rate (the words of 6.2); m: the mean |d| of the whole scene
};
constexpr auto enum_names(VicinityForm) {
  return std::array{std::pair{"settling", VicinityForm::settling},
                    std::pair{"published_constant", VicinityForm::published_constant},
                    std::pair{"published_mean", VicinityForm::published_mean}};
}

/// The vicinity factor (Narayana 2007, 6): a grid over the scene that learns how much things move.
struct GridVicinityOptions {
  static constexpr const char* model = "grid";
  static constexpr const char* meaning = "how much things move in each cell of the scene (Narayana 2007, 6)";

  VicinityForm form = VicinityForm::settling;
  int cell_px = 30;
  double max_factor = 5.0;
  double learning_rate = 0.1;
  double anomaly_deviations = 4.0;
  int anomaly_after_updates = 50;
  int anomaly_frames = 3;

  static constexpr auto fields() {
    using O = GridVicinityOptions;
    return std::make_tuple(
        field("form", &O::form, "", "how the factor follows a displacement"),
        field("cell_px", &O::cell_px, "px", "side of a cell; no larger than the frame", between(1, 100000)),
        field("max_factor", &O::max_factor, "", "the largest factor; the smallest is 1, the first (1 + largest) / 2",
              between(1, 1000)),
        field("learning_rate", &O::learning_rate, "", "alpha: how fast a factor follows", above_up_to(0, 1)),
        field("anomaly_deviations", &O::anomaly_deviations, "standard deviations",
              "a track faster or slower by more than those before it in its cell is anomalous; 0: none is", between(0, 1e6)),
        field("anomaly_after_updates", &O::anomaly_after_updates, "updates", "a cell that saw fewer calls nothing anomalous",
              between(2, 1e9)),
        field("anomaly_frames", &O::anomaly_frames, "frames", "so many in a row raise the event anomalous_speed",
              between(1, 1e6)));
  }
};

using VicinityOptions = std::variant<NoVicinityOptions, GridVicinityOptions>;

}  // namespace survtrack
