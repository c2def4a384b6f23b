// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <array>
#include <memory>
#include <opencv2/core/mat.hpp>
#include <string>
#include <utility>
#include <vector>

namespace survtrack {

/// A structuring element of an edge k, odd or even, on the offsets -floor(k/2) to k - 1 - floor(k/2) in both
/// directions: the pixels of OpenCV's `getStructuringElement` with its default anchor.
enum class MorphologyShape {
  square,
  cross,    ///< the row and the column of the origin
  ellipse,  ///< inscribed; with an even edge its outermost row and column on the negative side are single pixels
};
constexpr auto enum_names(MorphologyShape) {
  return std::array{std::pair{"square", MorphologyShape::square}, std::pair{"cross", MorphologyShape::cross},
                    std::pair{"ellipse", MorphologyShape::ellipse}};
}

/// Of one tile: 0 or 1 leaves the step out, up to 255.
struct TileEdges {
  int erode_px = 0;
  int dilate_px = 0;
};

/// A grid over the frame, each tile with edges of its own. Tile (r, c) of a frame of H rows and W columns is the
/// rows floor(r H / rows) to floor((r + 1) H / rows), likewise the columns: a grid need not divide the frame.
struct TileGrid {
  int rows = 1;
  int columns = 1;
  int overlap_px = 0;  ///< by which a tile reads beyond its own part on each side; two share a band of twice this
  MorphologyShape shape = MorphologyShape::square;
  std::vector<TileEdges> edges = {{}};  ///< rows * columns, row by row
};

/// Throws `ConfigError`, its message starting with `path`, for numbers out of range, for edges that are not one a
/// tile, and for an overlap below a tile's reach, floor(erode_px / 2) + floor(dilate_px / 2).
void check_tile_grid(const TileGrid& grid, const std::string& path = "");

/// Erosion, then dilation of a mask tile by tile (Semko 2007, chain step 5). Dilation is by the reflected element
/// (Minkowski's sum), so that equal edges, even ones too, are an opening and two even or two odd edges move
/// nothing; one even and one odd edge move an outline by half a pixel towards the lower right. What lies beyond the
/// frame is neutral: foreground to erosion, background to dilation. The overlap is cut off on rejoining. As it is
/// at least the reach, a tile's part is what its edges make of the whole frame, wherever the cuts lie.
class TiledMorphology {
 public:
  /// Throws `ConfigError` as `check_tile_grid` does.
  explicit TiledMorphology(const TileGrid& grid);
  ~TiledMorphology();
  TiledMorphology(TiledMorphology&&) noexcept;
  TiledMorphology& operator=(TiledMorphology&&) noexcept;

  /// In place; CV_8UC1, not 0 is foreground, the result is 0 or 255; strided views are fine. Allocates nothing
  /// while the size stays. Throws `InputError` as `check` does and then leaves the mask alone.
  void apply(cv::Mat& mask);

  /// Throws `InputError` for what is no mask, and for a frame with fewer rows or columns than the grid or with a
  /// tile (its own part) smaller than its edges.
  void check(const cv::Mat& mask) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// The same once, for a single mask.
void tiled_morphology(cv::Mat& mask, const TileGrid& grid);

}  // namespace survtrack
