// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>

#include "survtrack/core/geometry.hpp"

namespace survtrack {

enum class TrackStatus : std::uint8_t {
  tentative,  ///< seen too few times to be believed
  confirmed,  ///< matched in this frame, or in a group that is
  lost,       ///< not matched in this frame: predicted, or frozen, as the filter says
  closed,     ///< ended in this frame
};

const char* to_string(TrackStatus status);

/// One object followed through time, as known after one frame.
struct Track {
  std::int64_t id = 0;  ///< from 1, without gaps, given again only to who comes back; 0 while tentative
  TrackStatus status = TrackStatus::tentative;
  bool reported = false;  ///< part of the answer of this frame: written to files and drawn
  Box box;                ///< px, estimated box in this frame
  Point position;         ///< px, estimated position in this frame
  Point velocity_px_per_s;
  Symmetric2 position_covariance_px2;
  // Of what is predicted: see Estimate for the filters that know less. All zero with `mean_velocity`.
  Symmetric2 velocity_covariance_px2_per_s2;
  Matrix2 position_velocity_covariance_px2_per_s;  ///< rows: of the position
  Symmetric2 velocity_noise_px2_per_s3;  ///< process noise: what the velocity's covariance gains in a second
  Point predicted_position;  ///< px, where this frame's detection was expected
  Color mean_color;          ///< of the detection last matched
  int detection = -1;        ///< this frame's matched detection, or that of its group; -1: none
  std::int64_t group = 0;    ///< of tracks that share one detection the id of the oldest; 0: it shares none
  int age_frames = 0;        ///< frames since its first detection, that one not counted
  int matched_frames = 0;    ///< frames with a detection, the first one counted
  int lost_frames = 0;       ///< frames since its last detection
  std::int64_t start_index = 0;  ///< frame of its first detection
  std::int64_t end_index = 0;    ///< frame of its last detection
  double start_time_s = 0.0;
  double end_time_s = 0.0;
};

}  // namespace survtrack
