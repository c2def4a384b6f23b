// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "survtrack/segmentation/tiled_morphology.hpp"

#include <algorithm>
#include <cstdint>

#include "core/check_mask.hpp"
#include "segmentation/mask_rows.hpp"
#include "segmentation/mask_tile.hpp"
#include "survtrack/core/errors.hpp"

namespace survtrack {

using kernels::MaskElement;
using kernels::MaskTile;
using mask_bits::word_bits;

namespace {

constexpr int largest_edge_px = 255;
constexpr int largest_grid = 1000;

/// The pixels from begin to end of a side.
struct Part {
  std::size_t begin;
  std::size_t end;
  std::size_t size() const { return end - begin; }
};

Part part_of(std::size_t side, int parts, int index) {
  const auto cut = [&](int i) { return static_cast<std::size_t>(i) * side / static_cast<std::size_t>(parts); };
  return {cut(index), cut(index + 1)};
}

int reach_px(const TileEdges& edges) { return edges.erode_px / 2 + edges.dilate_px / 2; }

std::string name_of_tile(std::size_t index, int columns) {
  const auto in_row = static_cast<std::size_t>(columns);
  return "tile (row " + std::to_string(index / in_row + 1) + ", column " + std::to_string(index % in_row + 1) + ")";
}

void check_range(const std::string& name, int value, int low, int high) {
  if (value >= low && value <= high) return;
  throw ConfigError(name + ": " + std::to_string(value) + " is not allowed; expected between " + std::to_string(low) +
                    " and " + std::to_string(high));
}

bool all_equal(const std::vector<TileEdges>& edges) {
  return std::all_of(edges.begin(), edges.end(), [&](const TileEdges& one) {
    return one.erode_px == edges.front().erode_px && one.dilate_px == edges.front().dilate_px;
  });
}

}  // namespace

void check_tile_grid(const TileGrid& grid, const std::string& path) {
  const std::string prefix = path.empty() ? "" : path + ".";
  check_range(prefix + "rows", grid.rows, 1, largest_grid);
  check_range(prefix + "columns", grid.columns, 1, largest_grid);
  check_range(prefix + "overlap_px", grid.overlap_px, 0, 2 * largest_edge_px);
  const std::size_t tiles = static_cast<std::size_t>(grid.rows) * static_cast<std::size_t>(grid.columns);
  if (grid.edges.size() != tiles) {
    throw ConfigError(prefix + "edges: are " + std::to_string(grid.edges.size()) + "; expected one pair a tile, " +
                      std::to_string(grid.rows) + "x" + std::to_string(grid.columns));
  }
  for (std::size_t i = 0; i < tiles; ++i) {
    const TileEdges& edges = grid.edges[i];
    const std::string tile = name_of_tile(i, grid.columns);
    check_range(prefix + "erode_px of " + tile, edges.erode_px, 0, largest_edge_px);
    check_range(prefix + "dilate_px of " + tile, edges.dilate_px, 0, largest_edge_px);
    if (tiles == 1 || grid.overlap_px >= reach_px(edges)) continue;
    throw ConfigError(prefix + "overlap_px: " + std::to_string(grid.overlap_px) + " is not allowed; expected at least " +
                      std::to_string(reach_px(edges)) + ", the reach of " + tile + " with the edges " +
                      std::to_string(edges.erode_px) + " and " + std::to_string(edges.dilate_px) + " px: floor(" +
                      std::to_string(edges.erode_px) + " / 2) + floor(" + std::to_string(edges.dilate_px) + " / 2)");
  }
}

struct TiledMorphology::State {
  struct Tile {
    int row;
    int column;
    MaskElement erosion;
    MaskElement dilation;
    std::size_t reach;
  };
  TileGrid grid;
  int rows = 1;     ///< of the tiles that are worked on
  int columns = 1;
  std::vector<Tile> tiles;
  MaskTile pixels;
  std::vector<std::uint64_t> frame;  ///< the mask as it came, one bit a pixel

  void run(cv::Mat& mask, const Tile& tile);
};

TiledMorphology::TiledMorphology(const TileGrid& grid) : state_(std::make_unique<State>()) {
  check_tile_grid(grid);
  state_->grid = grid;
  // With equal edges the cuts leave no trace.
  const bool whole = all_equal(grid.edges);
  state_->rows = whole ? 1 : grid.rows;
  state_->columns = whole ? 1 : grid.columns;
  for (int row = 0; row < state_->rows; ++row) {
    for (int column = 0; column < state_->columns; ++column) {
      const TileEdges& edges = grid.edges[static_cast<std::size_t>(row * grid.columns + column)];
      state_->tiles.push_back({row, column, kernels::mask_element(grid.shape, edges.erode_px),
                               kernels::mask_element(grid.shape, edges.dilate_px),
                               static_cast<std::size_t>(reach_px(edges))});
    }
  }
}

TiledMorphology::~TiledMorphology() = default;
TiledMorphology::TiledMorphology(TiledMorphology&&) noexcept = default;
TiledMorphology& TiledMorphology::operator=(TiledMorphology&&) noexcept = default;

void TiledMorphology::check(const cv::Mat& mask) const {
  check_mask(mask);
  const TileGrid& grid = state_->grid;
  const auto frame = [&] { return "mask: is " + std::to_string(mask.rows) + "x" + std::to_string(mask.cols); };
  if (mask.rows < grid.rows || mask.cols < grid.columns) {
    throw InputError(frame() + ", smaller than the grid of " + std::to_string(grid.rows) + "x" +
                     std::to_string(grid.columns) + " tiles; expected a pixel a tile at least");
  }
  for (int i = 0; i < grid.rows * grid.columns; ++i) {
    const TileEdges& edges = grid.edges[static_cast<std::size_t>(i)];
    const auto edge = static_cast<std::size_t>(std::max(edges.erode_px, edges.dilate_px));
    const Part rows = part_of(static_cast<std::size_t>(mask.rows), grid.rows, i / grid.columns);
    const Part columns = part_of(static_cast<std::size_t>(mask.cols), grid.columns, i % grid.columns);
    if (edge < 2 || edge <= std::min(rows.size(), columns.size())) continue;
    throw InputError(frame() + ", which makes " + name_of_tile(static_cast<std::size_t>(i), grid.columns) + " " +
                     std::to_string(rows.size()) + "x" + std::to_string(columns.size()) +
                     " px; expected at least its edge of " + std::to_string(edge) + " px");
  }
}

void TiledMorphology::apply(cv::Mat& mask) {
  check(mask);
  const auto width = static_cast<std::size_t>(mask.cols);
  const std::size_t row_words = mask_bits::words_for(width);
  state_->frame.resize(static_cast<std::size_t>(mask.rows) * row_words);
  for (int y = 0; y < mask.rows; ++y) {
    mask_bits::pack_row(mask.ptr(y), width, state_->frame.data() + static_cast<std::size_t>(y) * row_words);
  }
  for (const State::Tile& tile : state_->tiles) state_->run(mask, tile);
}

/// What is farther than its reach has no part in a tile's result, so that no more of the overlap is read.
void TiledMorphology::State::run(cv::Mat& mask, const Tile& tile) {
  const auto height = static_cast<std::size_t>(mask.rows);
  const auto width = static_cast<std::size_t>(mask.cols);
  const Part own_rows = part_of(height, rows, tile.row);
  const Part own_columns = part_of(width, columns, tile.column);
  const auto read = [&](const Part& own, std::size_t side) {
    return Part{own.begin - std::min(own.begin, tile.reach), std::min(own.end + tile.reach, side)};
  };
  const Part read_rows = read(own_rows, height);
  Part read_columns = read(own_columns, width);
  read_columns.begin -= read_columns.begin % word_bits;  // spares a shift of every row
  const std::size_t words = mask_bits::words_for(read_columns.size());
  const std::size_t frame_words = mask_bits::words_for(width);
  pixels.start(read_columns.size(), read_rows.size(), std::max(tile.erosion.edge, tile.dilation.edge));
  for (std::size_t y = 0; y < read_rows.size(); ++y) {
    std::copy_n(frame.data() + (read_rows.begin + y) * frame_words + read_columns.begin / word_bits, words, pixels.row(y));
  }
  pixels.erode(tile.erosion);
  pixels.dilate(tile.dilation);
  for (std::size_t y = own_rows.begin; y < own_rows.end; ++y) {
    mask_bits::unpack_row(pixels.row(y - read_rows.begin), own_columns.begin - read_columns.begin,
                          mask.ptr(static_cast<int>(y)) + own_columns.begin, own_columns.size());
  }
}

void tiled_morphology(cv::Mat& mask, const TileGrid& grid) { TiledMorphology(grid).apply(mask); }

}  // namespace survtrack
