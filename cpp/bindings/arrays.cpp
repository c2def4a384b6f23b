// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include "bindings.hpp"
#include "survtrack/core/errors.hpp"

namespace survtrack::bindings {

ImageView view_of_image(const py::object& object, const char* name) {
  const std::string expected = "; expected a numpy array HxW (grey) or HxWx3 (BGR) of uint8";
  if (!py::isinstance<py::array>(object)) {
    throw InputError(std::string(name) + ": is " + std::string(py::str(py::type::of(object).attr("__name__"))) + expected);
  }
  py::array array = py::reinterpret_borrow<py::array>(object);
  const std::string what = std::string(py::str(array.attr("shape"))) + " " + std::string(py::str(array.dtype()));
  const bool plain = array.ndim() == 2 || (array.ndim() == 3 && array.shape(2) == 3);
  if (!plain || !array.dtype().is(py::dtype::of<std::uint8_t>()) || array.size() == 0) {
    throw InputError(std::string(name) + ": is " + what + expected + " with at least one pixel");
  }
  constexpr py::ssize_t longest_side = 1 << 20;
  if (array.shape(0) > longest_side || array.shape(1) > longest_side) {
    throw InputError(std::string(name) + ": is " + what + "; expected at most 1048576 pixels a side");
  }
  const py::ssize_t channels = array.ndim() == 3 ? 3 : 1;
  const bool rows_are_plain = array.strides(1) == channels && (channels == 1 || array.strides(2) == 1) &&
                              array.strides(0) >= array.shape(1) * channels;
  if (!rows_are_plain) array = py::array_t<std::uint8_t, py::array::c_style | py::array::forcecast>(array);
  // cv::Mat has no const view; images are only read.
  auto* pixels = static_cast<std::uint8_t*>(const_cast<void*>(array.data()));
  cv::Mat image(static_cast<int>(array.shape(0)), static_cast<int>(array.shape(1)), channels == 3 ? CV_8UC3 : CV_8UC1,
                pixels, static_cast<std::size_t>(array.shape(0) > 1 ? array.strides(0) : array.shape(1) * channels));
  return {array, image};
}

py::array array_of_image(const cv::Mat& image) {
  auto* owner = new cv::Mat(image);
  const py::capsule base(owner, [](void* pointer) { delete static_cast<cv::Mat*>(pointer); });
  const auto rows = static_cast<py::ssize_t>(image.rows), cols = static_cast<py::ssize_t>(image.cols);
  const auto step = static_cast<py::ssize_t>(image.step[0]);
  if (image.channels() == 1) return py::array_t<std::uint8_t>({rows, cols}, {step, py::ssize_t{1}}, owner->data, base);
  const auto channels = static_cast<py::ssize_t>(image.channels());
  return py::array_t<std::uint8_t>({rows, cols, channels}, {step, channels, py::ssize_t{1}}, owner->data, base);
}

py::array_t<float> array_of_field(const cv::Mat& field) {
  auto* owner = new cv::Mat(field);
  const py::capsule base(owner, [](void* pointer) { delete static_cast<cv::Mat*>(pointer); });
  const auto rows = static_cast<py::ssize_t>(field.rows), cols = static_cast<py::ssize_t>(field.cols);
  const auto step = static_cast<py::ssize_t>(field.step[0]), channels = static_cast<py::ssize_t>(field.channels());
  constexpr auto one = static_cast<py::ssize_t>(sizeof(float));
  const auto* numbers = owner->ptr<float>();
  if (channels == 1) return py::array_t<float>({rows, cols}, {step, one}, numbers, base);
  return py::array_t<float>({rows, cols, channels}, {step, channels * one, one}, numbers, base);
}

py::array_t<double> array_of(const Symmetric2& m) {
  py::array_t<double> array({2, 2});
  auto a = array.mutable_unchecked<2>();
  a(0, 0) = m.xx;
  a(0, 1) = a(1, 0) = m.xy;
  a(1, 1) = m.yy;
  return array;
}

py::array_t<double> array_of(const Matrix2& m) {
  py::array_t<double> array({2, 2});
  auto a = array.mutable_unchecked<2>();
  a(0, 0) = m.xx;
  a(0, 1) = m.xy;
  a(1, 0) = m.yx;
  a(1, 1) = m.yy;
  return array;
}

}  // namespace survtrack::bindings
