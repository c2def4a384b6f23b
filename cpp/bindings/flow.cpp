// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include <optional>
#include <string>
#include <utility>

#include "core/options_json.hpp"
#include "options_class.hpp"
#include "survtrack/core/errors.hpp"
#include "survtrack/segmentation/horn_schunck.hpp"

namespace survtrack::bindings {
namespace {

using Pair = py::typing::Tuple<py::array_t<float>, py::array_t<float>>;

/// A field's component, copied. Its size is left to `horn_schunck`.
cv::Mat component_of(const py::handle& object, const char* name) {
  const std::string expected = "; expected a numpy array HxW of float32 or float64";
  if (!py::isinstance<py::array>(object)) {
    const std::string type = py::str(py::type::of(object).attr("__name__"));
    throw InputError(std::string(name) + ": is " + type + expected);
  }
  const auto array = py::reinterpret_borrow<py::array>(object);
  const bool floats = py::isinstance<py::array_t<float>>(array) || py::isinstance<py::array_t<double>>(array);
  if (!floats || array.ndim() != 2) {
    throw InputError(std::string(name) + ": is " + std::string(py::str(array.attr("shape"))) + " " +
                     std::string(py::str(array.dtype())) + expected);
  }
  const py::array_t<float, py::array::c_style | py::array::forcecast> numbers(array);
  cv::Mat component(static_cast<int>(numbers.shape(0)), static_cast<int>(numbers.shape(1)), CV_32FC1);
  std::copy_n(numbers.data(), numbers.size(), component.ptr<float>());
  return component;
}

FlowField field_of(const py::object& initial) {
  if (initial.is_none()) return {};
  if (!py::isinstance<py::sequence>(initial) || py::len(initial) != 2) {
    throw InputError("initial: is " + std::string(py::str(py::type::of(initial).attr("__name__"))) +
                     "; expected a pair (u, v) of arrays, or None");
  }
  const auto pair = py::reinterpret_borrow<py::sequence>(initial);
  FlowField field{component_of(pair[0], "initial.u"), component_of(pair[1], "initial.v")};
  if (field.u.empty() || field.v.empty()) throw InputError("initial: is empty; expected arrays of the frames' size");
  return field;
}

Pair flow_of(const py::object& previous, const py::object& current, double smoothness, int sweeps, double tolerance,
             const std::string& derivatives, const py::object& initial, int levels, int warps) {
  const ImageView before = view_of_image(previous, "previous");
  const ImageView now = view_of_image(current, "current");
  FlowOptions options;
  options_json::assign_value(options.derivatives, Json(derivatives), {}, "derivatives");
  options.smoothness = smoothness;
  options.sweeps = sweeps;
  options.tolerance = tolerance;
  options.levels = levels;
  options.warps = warps;
  const FlowField start = field_of(initial);
  FlowField flow;
  {
    const py::gil_scoped_release release;
    horn_schunck(before.image, now.image, options, flow, start);
  }
  return py::make_tuple(array_of_field(flow.u), array_of_field(flow.v));
}

}  // namespace

void bind_flow(py::module_& module) {
  const FlowOptions usual;
  const std::string doc =
      "Optical flow (u, v) from previous to current: how far each pixel moves to the right and down, px a frame\n"
      "pair, float32 HxW (Horn and Schunck, Determining optical flow, 1981). One thread.\n"
      "\n"
      "Each sweep gives every pixel, from the means of its neighbourhood,\n"
      "u = mean u - Ix (Ix mean u + Iy mean v + It) / (a^2 + Ix^2 + Iy^2), and v likewise, with grey levels in\n"
      "0 to 1 and the image's edges repeated. One level without warps is the method as published; more levels\n"
      "find movements of more than a pixel or two.\n"
      "\n"
      "Args:\n"
      "    previous: HxW (grey) or HxWx3 (BGR, turned to grey) uint8.\n"
      "    current: the later frame, of the same size.\n"
      "    initial: a field (u, v) of the frames' size to start from, in place of zeros.\n" +
      arguments_doc<FlowOptions>() +
      "\n"
      "Raises:\n"
      "    InputError: frames or an initial field that do not fit, or are not finite.\n"
      "    ConfigError: options out of their ranges, or more levels than the size has.\n";
  module.def("horn_schunck", &flow_of, py::arg("previous"), py::arg("current"), py::kw_only(),
             py::arg("smoothness") = usual.smoothness, py::arg("sweeps") = usual.sweeps,
             py::arg("tolerance") = usual.tolerance, py::arg("derivatives") = "hs1981",
             py::arg("initial") = py::none(), py::arg("levels") = usual.levels, py::arg("warps") = usual.warps,
             doc.c_str());
}

}  // namespace survtrack::bindings
