// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "survtrack/segmentation/tiled_morphology.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <string>

#include "masks.hpp"

namespace survtrack::bindings {
namespace {

using EdgeArray = py::array_t<std::int64_t, py::array::c_style | py::array::forcecast>;

/// Edges are one for all tiles, or rows x columns of them.
EdgeArray edges_from(const py::object& given, int rows, int columns, const char* name) {
  const py::array array = py::array::ensure(given);
  const bool integers = array && (array.dtype().kind() == 'i' || array.dtype().kind() == 'u');
  const bool one = integers && array.ndim() == 0;
  const bool grid = integers && array.ndim() == 2 && array.shape(0) == rows && array.shape(1) == columns;
  if (one || grid) return EdgeArray::ensure(array);
  throw InputError(std::string(name) + ": is " + std::string(py::repr(given)) + "; expected an integer or " +
                   std::to_string(rows) + "x" + std::to_string(columns) + " integers");
}

/// What an int does not hold the grid's check cannot name.
int edge_of_tile(const EdgeArray& edges, py::ssize_t tile, const char* name) {
  const std::int64_t edge = edges.data()[edges.ndim() == 0 ? 0 : tile];
  constexpr std::int64_t low = std::numeric_limits<int>::min(), high = std::numeric_limits<int>::max();
  if (edge >= low && edge <= high) return static_cast<int>(edge);
  throw ConfigError(std::string(name) + ": " + std::to_string(edge) + " is not allowed; expected between 0 and 255");
}

MorphologyShape shape_from(const std::string& name) {
  std::string names;
  for (const auto& [one, shape] : enum_names(MorphologyShape{})) {
    if (name == one) return shape;
    names += (names.empty() ? "" : ", ") + std::string(one);
  }
  throw ConfigError("shape: \"" + name + "\" is not allowed; expected one of: " + names);
}

py::array tile_mask(const py::object& mask, int rows, int columns, int overlap_px, const py::object& erode_px,
                    const py::object& dilate_px, const std::string& shape) {
  const EdgeArray erode = edges_from(erode_px, rows, columns, "erode_px");
  const EdgeArray dilate = edges_from(dilate_px, rows, columns, "dilate_px");
  TileGrid grid{rows, columns, overlap_px, shape_from(shape), {}};
  // More tiles than a grid may have are refused before their edges are looked at.
  const py::ssize_t tiles = std::min(py::ssize_t{rows} * columns, py::ssize_t{1000} * 1000);
  for (py::ssize_t i = 0; i < tiles; ++i) grid.edges.push_back({edge_of_tile(erode, i, "erode_px"), edge_of_tile(dilate, i, "dilate_px")});
  return changed_mask(mask, [&](cv::Mat& changed) { tiled_morphology(changed, grid); });
}

}  // namespace

void bind_tiling(py::module_& module) {
  module.def("tiled_morphology", &tile_mask, py::arg("mask"), py::kw_only(), py::arg("rows"), py::arg("columns"),
             py::arg("overlap_px"), py::arg("erode_px"), py::arg("dilate_px"), py::arg("shape") = "square",
             "Erosion, then dilation of a mask (HxW uint8, not 0 is foreground), tile by tile (Semko 2007).\n\n"
             "Args:\n"
             "    rows, columns: of the grid, 1 to 1000; it need not divide the mask.\n"
             "    overlap_px: by which a tile reads beyond its own part on each side; at least the reach of each tile,\n"
             "        floor(erode_px / 2) + floor(dilate_px / 2).\n"
             "    erode_px, dilate_px: edges of the elements, an integer or rows x columns of them; 0 to 255, even ones\n"
             "        too: a pixel's offsets are -floor(k / 2) to k - 1 - floor(k / 2). 0 and 1 leave the step out.\n"
             "    shape: \"square\", \"cross\" or \"ellipse\", as OpenCV's elements.\n\n"
             "Dilation is by the reflected element. What lies beyond the mask is neutral to both. Returns a new mask,\n"
             "0 or 255. Raises ConfigError for the grid and InputError for a mask too small for it.");
}

}  // namespace survtrack::bindings
