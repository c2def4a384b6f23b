// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <Eigen/Core>
#include <cmath>
#include <optional>
#include <string>

#include "bindings.hpp"
#include "survtrack/core/errors.hpp"
#include "survtrack/filtering/correction.hpp"

namespace survtrack::bindings {

using Numbers = py::array_t<double, py::array::c_style | py::array::forcecast>;
/// What the filters call back.
using Callback = py::typing::Callable<py::object(py::ellipsis)>;
using StateDict = py::typing::Dict<py::str, py::object>;

inline void check_dimensions(const std::string& name, const Numbers& array, py::ssize_t dimensions) {
  if (array.ndim() == dimensions) return;
  throw InputError(name + ": has " + std::to_string(array.ndim()) + " dimensions; expected " + std::to_string(dimensions));
}

inline Eigen::VectorXd vector_of(const std::string& name, const Numbers& array) {
  check_dimensions(name, array, 1);
  return Eigen::Map<const Eigen::VectorXd>(array.data(), array.shape(0));
}

using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

inline Eigen::MatrixXd matrix_of(const std::string& name, const Numbers& array) {
  check_dimensions(name, array, 2);
  return Eigen::Map<const RowMajor>(array.data(), array.shape(0), array.shape(1));
}

/// A column for each row of an array of numbers of many filters, particles or steps.
inline Eigen::MatrixXd columns_of(const std::string& name, const Numbers& array) {
  check_dimensions(name, array, 2);
  return Eigen::Map<const Eigen::MatrixXd>(array.data(), array.shape(1), array.shape(0));
}

inline py::array_t<double> array_of_vector(const Eigen::VectorXd& vector) {
  return py::array_t<double>(vector.size(), vector.data());
}

inline py::array_t<double> array_of_dense(const Eigen::MatrixXd& matrix) {
  py::array_t<double> array({matrix.rows(), matrix.cols()});
  Eigen::Map<RowMajor>(array.mutable_data(), matrix.rows(), matrix.cols()) = matrix;
  return array;
}

/// A row for each column.
inline py::array_t<double> array_of_columns(const Eigen::MatrixXd& matrix) {
  return py::array_t<double>({matrix.cols(), matrix.rows()}, matrix.data());
}

/// What a callback returned, as numbers.
inline Numbers numbers_returned(const std::string& name, const py::object& returned) {
  Numbers array = returned.is_none() ? Numbers() : Numbers::ensure(returned);
  if (!array || returned.is_none()) {
    throw InputError(name + ": returned " + std::string(py::str(py::type::of(returned).attr("__name__"))) +
                     "; expected an array of numbers");
  }
  return array;
}

inline Covariances covariances_of(bool validate) { return validate ? Covariances::checked : Covariances::as_published; }

inline Residual residual_of(const std::optional<Callback>& callback) {
  if (!callback) return {};
  return [f = *callback](const Eigen::VectorXd& z, const Eigen::VectorXd& predicted) {
    return vector_of("residual", numbers_returned("residual", f(array_of_vector(z), array_of_vector(predicted))));
  };
}

/// A part of the last update, of which there must have been one.
inline const Correction<>& made(const std::optional<Correction<>>& last, const char* name) {
  if (last) return *last;
  throw InputError(std::string(name) + ": there has been no update yet");
}

/// The last update as Python objects, for pickles; and back.
inline py::object state_of(const std::optional<Correction<>>& last) {
  if (!last) return py::none();
  return py::make_tuple(array_of_vector(last->y), array_of_dense(last->S), array_of_dense(last->K), last->nis);
}

inline std::optional<Correction<>> correction_of(const py::object& state) {
  if (state.is_none()) return std::nullopt;
  const auto t = state.cast<py::tuple>();
  return Correction<>{vector_of("y", t[0].cast<Numbers>()), matrix_of("S", t[1].cast<Numbers>()),
                      matrix_of("K", t[2].cast<Numbers>()), t[3].cast<double>()};
}

/// The properties that all Kalman filters share: x, P, Q, R and those of the last update.
template <class Self>
void bind_common(py::class_<Self>& cls) {
  cls.def_property("x", [](const Self& self) { return array_of_vector(self.filter.x()); },
                   [](Self& self, const Numbers& x) { self.filter.set_x(vector_of("x", x)); }, "State: n numbers.")
      .def_property("P", [](const Self& self) { return array_of_dense(self.filter.P()); },
                    [](Self& self, const Numbers& P) { self.filter.set_P(matrix_of("P", P)); },
                    "Covariance of the state: n x n.")
      .def_property("Q", [](const Self& self) { return array_of_dense(self.filter.model().Q); },
                    [](Self& self, const Numbers& Q) { self.filter.set_Q(matrix_of("Q", Q)); },
                    "Covariance of the process noise of a step: n x n.")
      .def_property("R", [](const Self& self) { return array_of_dense(self.filter.model().R); },
                    [](Self& self, const Numbers& R) { self.filter.set_R(matrix_of("R", R)); },
                    "Covariance of the measurement noise: m x m.")
      .def_property_readonly("y", [](const Self& self) { return array_of_vector(made(self.last, "y").y); },
                             "Innovation of the last update: m numbers. Raises InputError before the first update.")
      .def_property_readonly("S", [](const Self& self) { return array_of_dense(made(self.last, "S").S); },
                             "Its covariance: m x m.")
      .def_property_readonly("K", [](const Self& self) { return array_of_dense(made(self.last, "K").K); },
                             "Gain of the last update: n x m.")
      .def_property_readonly("nis", [](const Self& self) { return made(self.last, "nis").nis; },
                             "Normalised innovation squared of the last update, y' S^-1 y: chi-square distributed with m\n"
                             "degrees of freedom if the model fits.")
      .def_property_readonly("log_likelihood",
                             [](const Self& self) { return made(self.last, "log_likelihood").log_likelihood(); },
                             "Logarithm of the Gaussian density of the last innovation.")
      .def("squared_mahalanobis",
           [](const Self& self, const Numbers& z) { return self.filter.squared_mahalanobis(vector_of("z", z)); }, py::arg("z"),
           "How far a measurement is from the expected one, in the metric of the coming innovation's covariance, squared:\n"
           "inside the gate for a share p of the true ones if at most chi_square_quantile(p, m). Raises InputError.")
      .def("mahalanobis",
           [](const Self& self, const Numbers& z) {
             const double squared = self.filter.squared_mahalanobis(vector_of("z", z));
             if (squared < 0.0) throw InputError("S: is not positive definite, there is no distance");
             return std::sqrt(squared);
           },
           py::arg("z"), "The root of squared_mahalanobis.");
}

void bind_kalman_bank(py::module_& module);
void bind_nonlinear_filters(py::module_& module);
void bind_particle_filter(py::module_& module);

}  // namespace survtrack::bindings
