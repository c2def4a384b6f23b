// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/typing.h>

#include <opencv2/core/mat.hpp>

#include "survtrack/core/geometry.hpp"

namespace survtrack::bindings {

namespace py = pybind11;

/// A view of an array as an image; `owner` keeps the pixels alive. Strided views are used in place where rows
/// are plain, otherwise copied. Throws `InputError` naming dtype and shape; never converts values.
struct ImageView {
  py::array owner;
  cv::Mat image;
};
ImageView view_of_image(const py::object& array, const char* name);

/// An array over the pixels of `image`, which it keeps alive: HxW or HxWxC uint8.
py::array array_of_image(const cv::Mat& image);

/// An array over float32 numbers, which it keeps alive: HxW or HxWxC.
py::array_t<float> array_of_field(const cv::Mat& field);

inline py::typing::Tuple<double, double> tuple_of(const Point& p) { return py::make_tuple(p.x, p.y); }
inline py::typing::Tuple<double, double, double> tuple_of(const Color& c) {
  return py::make_tuple(c.blue, c.green, c.red);
}
py::array_t<double> array_of(const Symmetric2& m);
py::array_t<double> array_of(const Matrix2& m);

void bind_options(py::module_& module);
void bind_config(py::module_& module);
void bind_region_values(py::module_& module);
void bind_values(py::module_& module);
void bind_results(py::module_& module);
void bind_segmentation(py::module_& module);
void bind_scene_change(py::module_& module);
void bind_tiling(py::module_& module);
void bind_flow(py::module_& module);
void bind_filtering(py::module_& module);
void bind_filters(py::module_& module);
void bind_association(py::module_& module);
void bind_beliefs(py::module_& module);
void bind_pipeline(py::module_& module);
void bind_offline(py::module_& module);
void bind_patterns(py::module_& module);
void bind_paths(py::module_& module);
void bind_regions(py::module_& module);
void bind_appearance(py::module_& module);
void bind_noise(py::module_& module);

}  // namespace survtrack::bindings
