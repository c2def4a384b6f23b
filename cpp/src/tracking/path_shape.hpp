// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <vector>

#include "survtrack/tracking/path.hpp"
#include "tracking/path_chords.hpp"
#include "tracking/path_cubic.hpp"

namespace survtrack {

/// A stretch of one cubic, so short that its chord is close to it; a leg of straight lines is one piece.
struct PathPiece {
  std::size_t leg = 0;
  double begin = 0.0, end = 1.0;  ///< parameters on the leg's cubic
  double s_px = 0.0;              ///< of its beginning
  double length_px = 0.0;
};

/// A place on a path. Where two pieces meet it is at the beginning of the later one.
struct PathSpot {
  std::size_t piece = 0;
  double u = 0.0;
  int side = 0;  ///< the nearest point is: -1 where the piece begins, 1 at the end of an open path, 0 between
};

/// What belongs to a place on a path.
struct PathFrame {
  Point origin;
  Point tangent;          ///< of length 1
  bool corner = false;    ///< the tangent is the mean of two directions
};

/// A path as it is computed with. It never changes.
struct PathShape {
  std::vector<Point> points;
  bool closed = false;
  PathKind kind = PathKind::line;
  double max_distance_px = 0.0;

  std::vector<PathCubic> legs;
  std::vector<PathPiece> pieces;
  PathChords chords;       // of the pieces
  double bulge_px = 0.0;   // a piece is at most so far from its chord
  double length_px = 0.0;

  PathShape(std::vector<Point> points, bool closed, PathKind kind, double max_distance_px);

  const PathCubic& cubic(std::size_t piece) const { return legs[pieces[piece].leg]; }
  bool has_before(std::size_t piece) const { return closed || piece > 0; }
  bool has_after(std::size_t piece) const { return closed || piece + 1 < pieces.size(); }
  std::size_t before(std::size_t piece) const { return piece > 0 ? piece - 1 : pieces.size() - 1; }
  std::size_t after(std::size_t piece) const { return piece + 1 < pieces.size() ? piece + 1 : 0; }

  double wrap(double s_px) const;
  PathSpot nearest(const Point& p, const NearestChord& chord) const;
  PathSpot spot_at(double s_px) const;  ///< the nearest end for an S beyond it
  double s_of(const PathSpot& spot) const;
  PathFrame frame_at(const PathSpot& spot) const;
  /// 1 / radius, positive where the path turns to the side of positive T; 0 at ends and corners.
  double curvature(const PathSpot& spot) const;

 private:
  PathSpot nearest_on(std::size_t piece, const Point& p) const;
  PathSpot settled(PathSpot spot, const Point& p) const;
};

}  // namespace survtrack
