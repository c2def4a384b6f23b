// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include <cmath>

#include "bindings.hpp"
#include "survtrack/association/assign.hpp"
#include "survtrack/association/costs.hpp"
#include "survtrack/core/errors.hpp"

namespace survtrack::bindings {
namespace {

using Matrix = py::array_t<double, py::array::c_style | py::array::forcecast>;

CostMatrix costs_of(const Matrix& array) {
  if (array.ndim() != 2) throw InputError("costs: has " + std::to_string(array.ndim()) + " dimensions; expected 2");
  CostMatrix costs;
  costs.resize(static_cast<int>(array.shape(0)), static_cast<int>(array.shape(1)));
  const auto a = array.unchecked<2>();
  for (int i = 0; i < costs.rows(); ++i) {
    for (int j = 0; j < costs.columns(); ++j) {
      const double cost = a(i, j);
      constexpr double largest = 1e150;  // sums and differences stay finite
      if (!(std::abs(cost) <= largest) && cost != CostMatrix::gated) {
        throw InputError("costs[" + std::to_string(i) + ", " + std::to_string(j) + "]: is " +
                         std::string(py::str(py::float_(cost))) +
                         "; expected a number within +-1e150, or inf for a pair that is refused");
      }
      costs(i, j) = cost;
    }
  }
  return costs;
}

py::array_t<std::int64_t> array_of_assignment(const Assignment& assignment) {
  py::array_t<std::int64_t> array(static_cast<py::ssize_t>(assignment.size()));
  auto a = array.mutable_unchecked<1>();
  for (std::size_t i = 0; i < assignment.size(); ++i) a(static_cast<py::ssize_t>(i)) = assignment[i];
  return array;
}

}  // namespace

void bind_association(py::module_& module) {
  module.def("assign_oldest_first", [](const Matrix& costs) { return array_of_assignment(assign_oldest_first(costs_of(costs))); },
             py::arg("costs"),
             "Rows in order, each takes its cheapest free column (Narayana 2007, 3.5.4). costs: rows x columns, inf where\n"
             "a pair is refused. Returns the column of each row, -1 for none. Raises InputError.");
  module.def(
      "assign_hungarian",
      [](const Matrix& costs, double unassigned_cost) {
        if (!(unassigned_cost >= -1e150)) {
          throw InputError("unassigned_cost: is " + std::string(py::str(py::float_(unassigned_cost))) +
                           "; expected a number of at least -1e150, or inf");
        }
        return array_of_assignment(assign_hungarian(costs_of(costs), unassigned_cost));
      },
      py::arg("costs"), py::arg("unassigned_cost") = CostMatrix::gated,
      "Optimal one-to-one assignment. costs: rows x columns, inf where a pair is refused; unassigned_cost: cost of a row\n"
      "that stays alone; inf: as many pairs as possible. Returns the column of each row, -1 for none. Raises InputError.");
  module.def(
      "match_matrix",
      [](const std::vector<Track>& tracks, const std::vector<Detection>& detections, std::pair<double, double> frame_size) {
        const auto allowed = [](double side) { return side > 0.0 && std::isfinite(side); };
        if (!allowed(frame_size.first) || !allowed(frame_size.second)) {
          throw InputError("frame_size: expected a positive width and height in px");
        }
        py::array_t<double> array({tracks.size(), detections.size()});
        auto a = array.mutable_unchecked<2>();
        for (std::size_t i = 0; i < tracks.size(); ++i) {
          for (std::size_t j = 0; j < detections.size(); ++j) {
            a(static_cast<py::ssize_t>(i), static_cast<py::ssize_t>(j)) =
                match_matrix_entry(tracks[i], detections[j], frame_size.first, frame_size.second);
          }
        }
        return array;
      },
      py::arg("tracks"), py::arg("detections"), py::arg("frame_size"),
      "The match matrix of Narayana 2007, eq. 3.6: tracks x detections; frame_size is (width, height) in px.");
}

}  // namespace survtrack::bindings
