// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include <cmath>
#include <memory>
#include <optional>
#include <utility>

#include "bindings.hpp"
#include "core/text_of.hpp"
#include "survtrack/core/errors.hpp"
#include "survtrack/filtering/filter_bank.hpp"
#include "survtrack/tracking/path_bank.hpp"

namespace survtrack::bindings {
namespace {

struct PyPathState {
  Path path;
  PathState state;
};

using Positions = py::array_t<double, py::array::c_style | py::array::forcecast>;

/// A filter bank that checks what comes from Python.
struct PyFilterBank {
  PyFilterBank(const FilterOptions& options, const std::optional<Paths>& paths,
               const std::optional<std::pair<int, int>>& frame_size) {
    if (const auto* along = std::get_if<KalmanPathOptions>(&options)) {
      auto path_bank = std::make_unique<PathBank>(*along);
      if (paths) path_bank->set_paths(*paths);
      bank = std::move(path_bank);
    } else {
      bank = make_filter_bank(options);
    }
    const auto [width, height] = frame_size.value_or(std::pair{0, 0});
    bank->check_frame_size(width, height);
    bank->set_frame_size(width, height);
  }

  int slot(int index) const {
    if (index >= 0 && index < bank->size()) return index;
    throw InputError("slot: " + std::to_string(index) + " is not allowed; the bank has " + std::to_string(bank->size()) +
                     " filters, counted from 0");
  }

  std::unique_ptr<FilterBank> bank;
};

int add(PyFilterBank& self, double x, double y, double object_size_px) {
  if (!std::isfinite(x) || !std::isfinite(y)) throw InputError("position: expected finite numbers");
  if (!(object_size_px > 0.0) || !std::isfinite(object_size_px)) {
    throw InputError("object_size_px: " + std::to_string(object_size_px) + " is not allowed; expected a number above 0");
  }
  return self.bank->add({x, y}, object_size_px);
}

void predict(PyFilterBank& self, double dt) {
  if (!(dt > 0.0) || !(dt <= 1e6)) {
    throw InputError("dt: " + text_of(dt) + " is not allowed; expected a number above 0 and at most 1e6");
  }
  self.bank->predict(dt);
}

/// An Nx2 array of sizes in px, of those filters that are measured.
void check_sizes(const PyFilterBank& self, const Positions& sizes, const Positions& measured) {
  if (sizes.ndim() != 2 || sizes.shape(0) != self.bank->size() || sizes.shape(1) != 2) {
    throw InputError("sizes: expected an array of shape (" + std::to_string(self.bank->size()) +
                     ", 2), a width and height a filter");
  }
  const auto s = sizes.unchecked<2>();
  for (int i = 0; i < self.bank->size(); ++i) {
    const bool whole = s(i, 0) > 0.0 && s(i, 0) < 1e9 && s(i, 1) > 0.0 && s(i, 1) < 1e9;
    if (whole || std::isnan(measured.at(i, 0))) continue;
    throw InputError("sizes: row " + std::to_string(i) + " is not two numbers above 0 and below 1e9");
  }
}

/// Rows that hold NaN are missing measurements: their filters only predict.
void correct(PyFilterBank& self, const Positions& measured, const std::optional<Positions>& sizes) {
  if (measured.ndim() != 2 || measured.shape(0) != self.bank->size() || measured.shape(1) != 2) {
    throw InputError("measured: expected an array of shape (" + std::to_string(self.bank->size()) +
                     ", 2), a position a filter, NaN where one is missing");
  }
  const auto z = measured.unchecked<2>();
  for (int i = 0; i < self.bank->size(); ++i) {
    const bool whole = std::isfinite(z(i, 0)) && std::isfinite(z(i, 1));
    if (!whole && !(std::isnan(z(i, 0)) && std::isnan(z(i, 1)))) {
      throw InputError("measured: row " + std::to_string(i) + " is neither a finite position nor missing (NaN, NaN)");
    }
  }
  if (sizes) check_sizes(self, *sizes, measured);
  for (int i = 0; i < self.bank->size(); ++i) {
    if (std::isnan(z(i, 0))) continue;
    self.bank->correct(i, {z(i, 0), z(i, 1)});
    if (sizes) self.bank->correct_size(i, {sizes->at(i, 0), sizes->at(i, 1)}, {});
  }
}

template <class Get>
py::array_t<double> points(const PyFilterBank& self, const Get& get) {
  py::array_t<double> array({self.bank->size(), 2});
  auto a = array.mutable_unchecked<2>();
  for (int i = 0; i < self.bank->size(); ++i) {
    const Point p = get(i);
    a(i, 0) = p.x;
    a(i, 1) = p.y;
  }
  return array;
}

Matrix2 full(const Symmetric2& m) { return {m.xx, m.xy, m.xy, m.yy}; }
Matrix2 full(const Matrix2& m) { return m; }

template <class Get>
py::array_t<double> matrices(const PyFilterBank& self, const Get& get) {
  py::array_t<double> array({self.bank->size(), 2, 2});
  auto a = array.mutable_unchecked<3>();
  for (int i = 0; i < self.bank->size(); ++i) {
    const Matrix2 m = full(get(i));
    a(i, 0, 0) = m.xx;
    a(i, 0, 1) = m.xy;
    a(i, 1, 0) = m.yx;
    a(i, 1, 1) = m.yy;
  }
  return array;
}

py::array_t<double> array_of_matrix(const Eigen::MatrixXd& matrix) {
  py::array_t<double> array({matrix.rows(), matrix.cols()});
  auto a = array.mutable_unchecked<2>();
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
    for (Eigen::Index j = 0; j < matrix.cols(); ++j) a(i, j) = matrix(i, j);
  }
  return array;
}

void bind_path_state(py::module_& module) {
  const auto pair = [](const PathPosition& p) { return tuple_of(Point{p.s_px, p.t_px}); };
  // Its path is the bank's.
  py::class_<PyPathState>(module, "PathState", "What a filter along a path believes, by that path.")
      .def_property_readonly("path", [](const PyPathState& s) { return s.path; }, "The Path.")
      .def_property_readonly("place_before", [pair](const PyPathState& s) { return pair(s.state.place_before); },
                             "(S, T) px: the estimate before the last prediction.")
      .def_property_readonly("predicted", [pair](const PyPathState& s) { return pair(s.state.predicted); },
                             "(S, T) px: the estimate now; after predict the predicted one.")
      .def_property_readonly("velocity", [pair](const PyPathState& s) { return pair(s.state.velocity); },
                             "Rates of (S, T), px per time unit.")
      .def_property_readonly("covariance_px2", [](const PyPathState& s) { return array_of(s.state.covariance_px2); },
                             "2x2 over (S, T), of predicted.");
}

}  // namespace

void bind_filtering(py::module_& module) {
  bind_path_state(module);
  py::class_<PyFilterBank>(module, "FilterBank",
                           "The filters of many objects in one, a slot an object; each is predicted and corrected in turn.")
      .def(py::init<const FilterOptions&, const std::optional<Paths>&, const std::optional<std::pair<int, int>>&>(),
           py::arg("options"), py::kw_only(), py::arg("paths") = py::none(), py::arg("frame_size") = py::none(),
           "paths: for kalman_path, which needs some; frame_size: (width, height) in px, for kalman_discrete with start\n"
           "frame_center, which needs it. Raises ConfigError and InputError.")
      .def("__len__", [](const PyFilterBank& self) { return self.bank->size(); })
      .def("add", &add, py::arg("x"), py::arg("y"), py::kw_only(), py::arg("object_size_px") = 1.0,
           "Starts a filter at a measured position in px; returns its slot. object_size_px is the unit of noises that\n"
           "are relative to the object's size. Raises InputError.")
      .def("remove", [](PyFilterBank& self, int slot) { self.bank->remove(self.slot(slot)); }, py::arg("slot"),
           "Ends a filter; later slots move down by one.")
      .def("predict", &predict, py::arg("dt"), "Moves all filters on by dt time units, above 0.")
      .def("correct", &correct, py::arg("measured"), py::arg("sizes") = py::none(),
           "Corrects all filters by an Nx2 array of positions in px; rows of NaN are missing measurements. sizes: for\n"
           "kalman_box an Nx2 array of widths and heights in px.")
      .def_property_readonly("positions", [](const PyFilterBank& self) {
        return points(self, [&](int i) { return self.bank->estimate(i).position; });
      }, "Nx2, px")
      .def_property_readonly("predicted_positions", [](const PyFilterBank& self) {
        return points(self, [&](int i) { return self.bank->predicted_position(i); });
      }, "Nx2, px: where the measurements are expected, after predict")
      .def_property_readonly("velocities", [](const PyFilterBank& self) {
        return points(self, [&](int i) { return self.bank->estimate(i).velocity; });
      }, "Nx2, px per time unit")
      .def_property_readonly("position_covariances_px2", [](const PyFilterBank& self) {
        return matrices(self, [&](int i) { return self.bank->estimate(i).covariance_px2; });
      }, "Nx2x2, px^2")
      .def_property_readonly("velocity_covariances", [](const PyFilterBank& self) {
        return matrices(self, [&](int i) { return self.bank->estimate(i).velocity_covariance; });
      }, "Nx2x2, px^2 per time unit^2; zero for filters without one")
      .def_property_readonly("cross_covariances", [](const PyFilterBank& self) {
        return matrices(self, [&](int i) { return self.bank->estimate(i).cross_covariance; });
      }, "Nx2x2, px^2 per time unit: rows of the position, columns of the velocity")
      .def_property_readonly("velocity_noises", [](const PyFilterBank& self) {
        return matrices(self, [&](int i) { return self.bank->estimate(i).velocity_noise; });
      }, "Nx2x2, px^2 per time unit^3: what the velocities' covariances gain in a time unit by process noise; zero for\n"
         "kalman_ca with continuous noise, which is in the acceleration, and for filters without covariances.")
      .def_property_readonly("innovation_covariances_px2", [](const PyFilterBank& self) {
        return matrices(self, [&](int i) { return self.bank->innovation_covariance_px2(i); });
      }, "Nx2x2, px^2")
      .def_property_readonly("box_sizes", [](const PyFilterBank& self) {
        return points(self, [&](int i) {
          const BoxSize box = self.bank->box_size(i).value_or(BoxSize{std::nan(""), std::nan("")});
          return Point{box.width_px, box.height_px};
        });
      }, "Nx2, px: width and height; NaN of filters over positions")
      .def("path_state", [](const PyFilterBank& self, int slot) -> std::optional<PyPathState> {
        const std::optional<PathState> state = self.bank->path_state(self.slot(slot));
        if (!state) return std::nullopt;
        return PyPathState{*state->path, *state};
      }, py::arg("slot"), "What is believed by the path that the object is on; None of filters without one.")
      .def("state", [](const PyFilterBank& self, int slot) {
        const Eigen::VectorXd x = self.bank->state(self.slot(slot));
        return py::array_t<double>(x.size(), x.data());
      }, py::arg("slot"), "The raw state: positions, velocities, accelerations (x, y each); of kalman_box (x, y, w, h) and their rates, of\n"
         "kalman_path (S, T, vS, vT).")
      .def("state_covariance", [](const PyFilterBank& self, int slot) {
        return array_of_matrix(self.bank->state_covariance(self.slot(slot)));
      }, py::arg("slot"), "The raw state's covariance; empty for filters without one.");
}

}  // namespace survtrack::bindings
