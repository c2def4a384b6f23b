// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <cstdint>

#include "segmentation/flow_plane.hpp"
#include "survtrack/segmentation/horn_schunck_options.hpp"

/// The loops of Horn-Schunck's method (Horn and Schunck 1981): derivatives and some sweeps over the whole
/// image in one pass over memory. The same bytes on every CPU, however the work is cut up.
namespace survtrack::kernels {

/// Rows of grey levels, `stride` elements apart: either 8-bit ones or floats, the other is nullptr.
struct GreyRows {
  const std::uint8_t* bytes = nullptr;
  const float* floats = nullptr;
  std::ptrdiff_t stride = 0;
};

/// Rows of a flow field to write, so many elements apart; `margins`: columns -1 and `width` too.
struct FlowRows {
  float* u = nullptr;
  float* v = nullptr;
  std::ptrdiff_t u_stride = 0;
  std::ptrdiff_t v_stride = 0;
  bool margins = false;
};
inline FlowRows rows_of(FlowPlanes& field) {
  return {field.u.row(0), field.v.row(0), field.u.stride(), field.v.stride(), true};
}

/// Sweeps of one pass: the more, the less memory traffic, and the wider the columns' overlap.
constexpr int most_sweeps_in_pass = 25;

/// Wider images are worked on in tiles of at most so many columns, for the second-level cache's sake. Narrower
/// tiles are slower: where their rows end, what fetches memory ahead has to start anew.
constexpr std::ptrdiff_t most_tile_columns = 2048;

struct FlowPass {
  std::ptrdiff_t width;
  std::ptrdiff_t height;
  GreyRows previous;
  GreyRows current;
  Derivatives derivatives;
  float smoothness2;  ///< a^2, grey levels^2
  int sweeps;         ///< 1 to most_sweeps_in_pass
  /// Horizontal, vertical and temporal derivative, each divided by the root of a^2 + Ix^2 + Iy^2; nullptr: in
  /// this pass only. `derive`: they are computed, otherwise read.
  FlowPlane* normalised[3];
  bool derive;
  const FlowPlanes* about;  ///< `current` was warped by it; nullptr: by nothing
  const FlowPlanes* from;   ///< where the sweeps start; nullptr: zeros
  FlowRows to;              ///< may be `from` when there is one tile and more than one sweep
  float* largest_change;    ///< px, of each sweep; nullptr: not asked for
  std::ptrdiff_t tile_columns;  ///< worked on together; 0: as many as is best
};

/// `memory` grows to what the pass needs to work in.
void run_flow_pass(const FlowPass& pass, AlignedFloats& memory);

/// mask = 255 where the flow is faster than `threshold` (px), else 0.
void mask_of_flow(const float* u, const float* v, float threshold, std::uint8_t* mask, std::size_t count);

}  // namespace survtrack::kernels
