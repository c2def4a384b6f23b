// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "bindings.hpp"
#include "survtrack/core/color_histogram.hpp"
#include "survtrack/core/errors.hpp"

namespace survtrack::bindings {
namespace {

using Parts = py::array_t<float, py::array::c_style | py::array::forcecast>;

ColorHistogram histogram_of(const Parts& array, const char* name) {
  if (static_cast<std::size_t>(array.size()) != ColorHistogram::size) {
    throw InputError(std::string(name) + ": has " + std::to_string(array.size()) + " numbers; expected 8x8x8");
  }
  ColorHistogram histogram;
  std::copy_n(array.data(), ColorHistogram::size, histogram.parts.begin());
  check_histogram(histogram, name);
  return histogram;
}

}  // namespace

void bind_appearance(py::module_& module) {
  module.def(
      "color_histogram",
      [](const py::object& image, const py::object& mask) {
        const ImageView view = view_of_image(image, "image");
        const ImageView inside = mask.is_none() ? ImageView{} : view_of_image(mask, "mask");
        const ColorHistogram histogram = color_histogram(view.image, inside.image);
        constexpr py::ssize_t bins = ColorHistogram::bins;
        py::array_t<float> array({bins, bins, bins});
        std::copy(histogram.parts.begin(), histogram.parts.end(), array.mutable_data());
        return array;
      },
      py::arg("image"), py::arg("mask") = py::none(),
      "What part of the pixels has which colour: 8x8x8 float32 over blue, green and red, 32 levels a bin, of sum 1. image:\n"
      "HxW or HxWx3 (BGR) uint8; mask: HxW uint8, pixels where it is 0 do not count; without any left all is 0. Raises\n"
      "InputError.");
  module.def(
      "histogram_intersection",
      [](const Parts& a, const Parts& b) { return histogram_intersection(histogram_of(a, "a"), histogram_of(b, "b")); },
      py::arg("a"), py::arg("b"),
      "The sum of the smaller parts of two color_histogram() (Swain and Ballard 1991): 1 for equal colours, 0 for none in\n"
      "common. Raises InputError for what is no histogram.");
}

}  // namespace survtrack::bindings
