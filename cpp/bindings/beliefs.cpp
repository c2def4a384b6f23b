// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

// The parts of the Bayesian correspondence (Narayana 2007, chapter 8), one by one.

#include <cmath>
#include <string>

#include "bindings.hpp"
#include "survtrack/association/belief_matrix.hpp"
#include "survtrack/association/density.hpp"
#include "survtrack/association/velocity_factor.hpp"
#include "survtrack/core/errors.hpp"

namespace survtrack::bindings {
namespace {

using Numbers = py::array_t<double, py::array::c_style | py::array::forcecast>;

std::string text_of(double value) { return py::str(py::float_(value)); }

/// "evidence[1, 3]"; without brackets for a plain number.
std::string place_of(const std::string& name, const Numbers& array, py::ssize_t flat) {
  std::string text;
  for (py::ssize_t axis = array.ndim(); axis-- > 0;) {
    text = std::to_string(flat % array.shape(axis)) + (text.empty() ? "" : ", ") + text;
    flat /= array.shape(axis);
  }
  return text.empty() ? name : name + "[" + text + "]";
}

void check_numbers(const std::string& name, const Numbers& array, double low, double high, const char* expected) {
  for (py::ssize_t i = 0; i < array.size(); ++i) {
    const double value = array.data()[i];
    if (value >= low && value <= high) continue;
    throw InputError(place_of(name, array, i) + ": is " + text_of(value) + "; expected " + expected);
  }
}

void check_scale(const char* name, double value) {
  constexpr double least = 1e-100, most = 1e100;  // products and quotients stay finite
  if (value >= least && value <= most) return;
  throw InputError(std::string(name) + ": is " + text_of(value) + "; expected a number between 1e-100 and 1e100");
}

/// `function` of each number; the shape stays.
template <class Function>
py::array_t<double> mapped(const Numbers& array, Function&& function) {
  py::array_t<double> result(std::vector<py::ssize_t>(array.shape(), array.shape() + array.ndim()));
  double* const out = result.mutable_data();
  for (py::ssize_t i = 0; i < array.size(); ++i) out[i] = function(array.data()[i]);
  return result;
}

std::vector<Evidence> evidence_of(const Numbers& array) {
  if (array.ndim() != 2 || array.shape(1) != 4) {
    throw InputError("evidence: has the shape " + std::string(py::str(array.attr("shape"))) +
                     "; expected (blobs, 4): ratios of colour, position and size, and the velocity factor");
  }
  // Products of four stay finite, and so does their sum.
  check_numbers("evidence", array, 0.0, 1e60, "a ratio between 0 and 1e60");
  const auto a = array.unchecked<2>();
  std::vector<Evidence> evidence;
  for (py::ssize_t i = 0; i < array.shape(0); ++i) evidence.push_back({a(i, 0), a(i, 1), a(i, 2), a(i, 3)});
  return evidence;
}

template <class Rule>
py::array_t<double> row_of(const Numbers& array, Rule&& rule) {
  const std::vector<Evidence> evidence = evidence_of(array);
  py::array_t<double> row(static_cast<py::ssize_t>(evidence.size()) + 1);
  rule(evidence, row.mutable_data());
  return row;
}

void bind_rows(py::module_& module) {
  module.def(
      "order_free_beliefs", [](const Numbers& evidence) { return row_of(evidence, order_free_beliefs); }, py::arg("evidence"),
      "One row of the belief matrix (Narayana 2007, 8.3): the probabilities that a track is each of v blobs, and last that\n"
      "it is \"lost\"; they sum to 1. evidence: v x 4, a row a blob: the ratios p(observed | assigned) /\n"
      "p(observed | not assigned) of colour, position and size (1: not observed), and the falling velocity factor (1:\n"
      "none); 0 to 1e60. With the products w of a blob's four, b_i = w_i / (1 + sum of w), and 1 / (1 + sum of w) of\n"
      "\"lost\": Bayes' rule blob by blob with the velocity factor on the odds, whatever their order. Returns v + 1\n"
      "numbers. Raises InputError.");
  module.def(
      "published_beliefs",
      [](const Numbers& evidence) {
        std::vector<double> scales;
        return row_of(evidence, [&](const std::vector<Evidence>& e, double* row) { published_beliefs(e, row, scales); });
      },
      py::arg("evidence"),
      "The same as published: a row starts at 1 / (v + 1); blob after blob each ratio r makes its entry\n"
      "b' = r b / (r b + 1 - b) (eq. 8.13 to 8.17), the velocity factor f then min(f b', 1 - 1e-9), and after each step\n"
      "the other entries are multiplied by (1 - b') / (1 - b) (eq. 8.19). The order of the blobs matters as soon as there\n"
      "are velocity factors. Raises InputError.");
}

void bind_velocity_factors(py::module_& module) {
  const auto check = [](const Numbers& difference, double break_point) {
    check_numbers("difference", difference, 0.0, 1e300, "a number between 0 and 1e300");
    check_scale("break_point", break_point);
  };
  module.def(
      "falling_velocity_factor",
      [check](const Numbers& difference, double break_point) {
        check(difference, break_point);
        return mapped(difference, [&](double d) { return falling_velocity_factor(d, break_point); });
      },
      py::arg("difference"), py::arg("break_point"),
      "The velocity factor of a belief (Narayana 2007, fig. 8.6): 2 - 1.8 min(difference / break_point, 1), from 2 to 0.2.\n"
      "difference: array of any shape, at least 0, in the unit of break_point (px per time unit), which is above 0.\n"
      "Returns an array of the same shape. Raises InputError.");
  module.def(
      "velocity_factor",
      [check](const Numbers& difference, double break_point) {
        check(difference, break_point);
        return mapped(difference, [&](double d) { return velocity_factor(d, break_point); });
      },
      py::arg("difference"), py::arg("break_point"),
      "The velocity factor of a match-matrix entry (Narayana 2007, fig. 4.12): 1 / falling_velocity_factor, from 0.5 to 5.\n"
      "Arguments, result and errors are those of falling_velocity_factor.");
}

Density density_of(double range, const Numbers& values) {
  if (values.ndim() != 1) {
    throw InputError("values: has " + std::to_string(values.ndim()) + " dimensions; expected 1");
  }
  return Density::from_values(range, std::vector<double>(values.data(), values.data() + values.size()), "Density");
}

py::array_t<double> array_of(const std::vector<double>& values) {
  return py::array_t<double>(static_cast<py::ssize_t>(values.size()), values.data());
}

void bind_density(py::module_& module) {
  py::class_<Density>(module, "Density",
                      "The density of a difference between a track and its blob (Narayana 2007, 8.3.3): a table of equal bins\n"
                      "over -range to range, relative to its peak, linear between the bins' middles.")
      .def_static(
          "two_sided_exponential",
          [](double range, double scale) {
            check_scale("range", range);
            check_scale("scale", scale);
            return Density::two_sided_exponential(range, scale);
          },
          py::arg("range"), py::arg("scale"),
          "exp(-abs(difference) / scale) in 401 bins: what stands in until enough was seen. Both are above 0, in the unit of\n"
          "the differences. Raises InputError.")
      .def_static("from_values", &density_of, py::arg("range"), py::arg("values"),
                  "From a table of 3 or more values, at least 0, whose integral over -range to range is 1 within 1e-6. Raises\n"
                  "InputError.")
      .def(
          "__call__",
          [](const Density& density, const Numbers& difference) {
            check_numbers("difference", difference, -1e300, 1e300, "a number within +-1e300");
            return mapped(difference, density);
          },
          py::arg("difference"),
          "Relative to the peak, 0 to 1, for an array of differences of any shape; beyond the range the last bin counts.\n"
          "Raises InputError.")
      .def_property_readonly("range", &Density::range)
      .def_property_readonly("values", [](const Density& d) { return array_of(d.values()); }, "The table, with the integral 1.")
      .def_property_readonly("relative", [](const Density& d) { return array_of(d.relative()); }, "The table, with the peak 1.");
}

}  // namespace

void bind_beliefs(py::module_& module) {
  bind_rows(module);
  bind_velocity_factors(module);
  bind_density(module);
}

}  // namespace survtrack::bindings
