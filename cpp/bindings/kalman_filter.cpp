// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "survtrack/filtering/kalman_filter.hpp"

#include <vector>

#include "filters.hpp"
#include "survtrack/filtering/chi_square.hpp"
#include "survtrack/filtering/rts_smoother.hpp"
#include "survtrack/filtering/white_noise.hpp"

namespace survtrack::bindings {
namespace {

struct PyKalmanFilter {
  KalmanFilter<> filter;
  std::optional<Callback> residual;
  std::optional<Correction<>> last;
};

PyKalmanFilter make_filter(const Numbers& F, const Numbers& H, const Numbers& Q, const Numbers& R, const Numbers& x,
                           const Numbers& P, const std::optional<Numbers>& B, const std::optional<Callback>& residual,
                           bool validate) {
  KalmanFilter<>::Model model;
  model.F = matrix_of("F", F);
  model.H = matrix_of("H", H);
  model.Q = matrix_of("Q", Q);
  model.R = matrix_of("R", R);
  if (B) model.B = matrix_of("B", *B);
  model.residual = residual_of(residual);
  return {KalmanFilter<>(model, vector_of("x", x), matrix_of("P", P), covariances_of(validate)), residual, std::nullopt};
}

void predict(PyKalmanFilter& self, const std::optional<Numbers>& u) {
  if (!u) return self.filter.predict();
  if (self.filter.model().B.size() == 0) throw InputError("u: the filter has no B to apply it with");
  self.filter.predict(vector_of("u", *u));
}

void update(PyKalmanFilter& self, const Numbers& z, const std::optional<Numbers>& R) {
  if (R) self.filter.update(vector_of("z", z), matrix_of("R", *R));
  else self.filter.update(vector_of("z", z));
  self.last = self.filter.last();
}

StateDict get_state(const PyKalmanFilter& self) {
  const auto& model = self.filter.model();
  StateDict state;
  state["F"] = array_of_dense(model.F);
  state["H"] = array_of_dense(model.H);
  state["Q"] = array_of_dense(model.Q);
  state["R"] = array_of_dense(model.R);
  state["x"] = array_of_vector(self.filter.x());
  state["P"] = array_of_dense(self.filter.P());
  state["B"] = model.B.size() == 0 ? py::object(py::none()) : array_of_dense(model.B);
  state["residual"] = self.residual ? py::object(*self.residual) : py::none();
  state["validate"] = self.filter.covariances() == Covariances::checked;
  state["last"] = state_of(self.last);
  return state;
}

PyKalmanFilter set_state(const StateDict& state) {
  const auto numbers = [&](const char* name) { return state[name].cast<Numbers>(); };
  PyKalmanFilter self = make_filter(numbers("F"), numbers("H"), numbers("Q"), numbers("R"), numbers("x"), numbers("P"),
                                    state["B"].cast<std::optional<Numbers>>(),
                                    state["residual"].cast<std::optional<Callback>>(), state["validate"].cast<bool>());
  self.last = correction_of(state["last"]);
  return self;
}

void bind_filter(py::module_& module) {
  py::class_<PyKalmanFilter> cls(
      module, "KalmanFilter",
      "The linear Kalman filter for any model: x = F x + B u + noise of covariance Q, z = H x + noise of covariance R.\n"
      "Joseph-form update. Letters and equations: Bar-Shalom, Li and Kirubarajan 2001, 5.2.");
  cls.def(py::init(&make_filter), py::kw_only(), py::arg("F"), py::arg("H"), py::arg("Q"), py::arg("R"), py::arg("x"),
          py::arg("P"), py::arg("B") = py::none(), py::arg("residual") = py::none(), py::arg("validate") = true,
          "F (n x n), H (m x n), Q (n x n), R (m x m), start x (n) of covariance P (n x n), B (n x k). residual(z, predicted)\n"
          "returns how a measurement differs from the expected one, for those that wrap; None: z - predicted. Raises\n"
          "InputError naming what has a wrong shape, is not finite, or is no covariance, with its smallest eigenvalue.\n"
          "validate=False leaves out the checks that Q, R, P and S are covariances: only to reproduce published listings\n"
          "whose matrices are none; estimates of such a filter mean nothing.");
  cls.def("predict", &predict, py::arg("u") = py::none(), "x = F x + B u, P = F P F' + Q. u: k numbers, or None for no input.")
      .def("update", &update, py::arg("z"), py::arg("R") = py::none(),
           "Corrects by a measurement of m numbers; a missing one is simply not passed. R: the noise of this one, if another.\n"
           "Raises InputError where z is not finite or S is singular; the filter is then as before.")
      .def_property("F", [](const PyKalmanFilter& self) { return array_of_dense(self.filter.model().F); },
                    [](PyKalmanFilter& self, const Numbers& F) { self.filter.set_F(matrix_of("F", F)); }, "Transition: n x n.")
      .def_property("H", [](const PyKalmanFilter& self) { return array_of_dense(self.filter.model().H); },
                    [](PyKalmanFilter& self, const Numbers& H) { self.filter.set_H(matrix_of("H", H)); },
                    "Measured of state: m x n.")
      .def_property_readonly("B", [](const PyKalmanFilter& self) -> py::typing::Optional<py::array_t<double>> {
        const auto& B = self.filter.model().B;
        if (B.size() == 0) return py::none();
        return array_of_dense(B);
      }, "Effect of the control input: n x k; None if there is none.")
      .def(py::pickle(&get_state, &set_state));
  bind_common(cls);
}

StateOrder order_of(const std::string& order) {
  if (order == "by_axis") return StateOrder::by_axis;
  if (order == "by_derivative") return StateOrder::by_derivative;
  throw InputError("order: is \"" + order + "\"; expected by_axis or by_derivative");
}

using MakeNoise = Eigen::MatrixXd (*)(int, double, double, int, StateOrder);

void bind_noise(py::module_& module, const char* name, const char* strength, MakeNoise make, const char* doc) {
  module.def(name, [make](int dim, double dt, double value, int axes, const std::string& order) {
    return array_of_dense(make(dim, dt, value, axes, order_of(order)));
  }, py::arg("dim"), py::arg("dt"), py::arg(strength) = 1.0, py::kw_only(), py::arg("axes") = 1, py::arg("order") = "by_axis", doc);
}

/// (T, r, c) or one (r, c) for all.
std::vector<Eigen::MatrixXd> matrices_of(const char* name, const Numbers& array) {
  if (array.ndim() == 2) return {matrix_of(name, array)};
  check_dimensions(name, array, 3);
  std::vector<Eigen::MatrixXd> matrices;
  for (py::ssize_t k = 0; k < array.shape(0); ++k) {
    matrices.emplace_back(Eigen::Map<const RowMajor>(array.data(k), array.shape(1), array.shape(2)));
  }
  return matrices;
}

std::vector<Eigen::VectorXd> vectors_of(const char* name, const Numbers& array) {
  const Eigen::MatrixXd columns = columns_of(name, array);
  std::vector<Eigen::VectorXd> vectors;
  for (Eigen::Index k = 0; k < columns.cols(); ++k) vectors.emplace_back(columns.col(k));
  return vectors;
}

py::typing::Tuple<py::array_t<double>, py::array_t<double>> smooth(const Numbers& x, const Numbers& P, const Numbers& F,
                                                                  const Numbers& Q, const std::optional<Numbers>& Bu) {
  FilteredRun<> run{vectors_of("x", x), matrices_of("P", P), matrices_of("F", F), matrices_of("Q", Q), {}};
  if (Bu) run.Bu = Bu->ndim() == 1 ? std::vector<Eigen::VectorXd>{vector_of("Bu", *Bu)} : vectors_of("Bu", *Bu);
  const SmoothedRun<> smoothed = rts_smooth(run);
  const auto steps = static_cast<py::ssize_t>(smoothed.x.size()), n = x.shape(1);
  py::array_t<double> states({steps, n}), covariances({steps, n, n});
  for (py::ssize_t k = 0; k < steps; ++k) {
    const auto at = static_cast<std::size_t>(k);
    Eigen::Map<Eigen::VectorXd>(states.mutable_data(k), n) = smoothed.x[at];
    Eigen::Map<RowMajor>(covariances.mutable_data(k), n, n) = smoothed.P[at];
  }
  return py::make_tuple(states, covariances);
}

}  // namespace

void bind_filters(py::module_& module) {
  bind_filter(module);
  bind_kalman_bank(module);
  bind_nonlinear_filters(module);
  bind_particle_filter(module);
  bind_noise(module, "discrete_white_noise", "variance", &discrete_white_noise,
             "Process noise Q over a step of dt, of a highest derivative that is constant within a step and white from step to\n"
             "step (Bar-Shalom, Li and Kirubarajan 2001, 6.3). dim: 2 (position, velocity; the noise is the acceleration), 3 or\n"
             "4 derivatives; axes of them; order: by_axis (x, x', y, y') or by_derivative (x, y, x', y'). Raises InputError;\n"
             "dt is above 0 and at most 1e6.");
  bind_noise(module, "continuous_white_noise", "density", &continuous_white_noise,
             "Process noise Q over a step of dt, of continuous white noise of a spectral density in the first derivative that is\n"
             "not modelled: two steps of dt / 2 are one of dt (Bar-Shalom, Li and Kirubarajan 2001, 6.2). Arguments and errors\n"
             "as those of discrete_white_noise.");
  module.def("rts_smooth", &smooth, py::arg("x"), py::arg("P"), py::arg("F"), py::arg("Q"), py::arg("Bu") = py::none(),
             "States and covariances given the measurements of the whole run (Rauch, Tung and Striebel 1965). x (T x n) and P\n"
             "(T x n x n): those after each update; F and Q (n x n, or T x n x n): with which each step was predicted from the\n"
             "one before (the first is not used); Bu (n, or T x n): the control input, likewise. Returns x and P. Raises InputError.");
  module.def("chi_square_quantile", &chi_square_quantile, py::arg("probability"), py::arg("degrees"),
             "What a sum of so many squared standard normal numbers stays below with this probability: 5.991 for 0.95 and 2.\n"
             "Raises InputError.");
  module.def("nis_band", [](int degrees, int count, double probability) -> py::typing::Tuple<double, double> {
    const auto band = nis_band(degrees, count, probability);
    return py::make_tuple(band.first, band.second);
  }, py::arg("degrees"), py::arg("count"), py::arg("probability") = 0.95,
             "Bounds within which the mean of `count` NIS of so many degrees lies with this probability if the model fits\n"
             "(Bar-Shalom, Li and Kirubarajan 2001, 5.4.2). Raises InputError.");
  module.def("wrapped_difference", py::vectorize(&wrapped_difference), py::arg("difference"), py::arg("period"),
             "A difference, or an array of them, brought into [-period / 2, period / 2): the shorter way round. A period of 0\n"
             "leaves it alone. Raises InputError.");
}

}  // namespace survtrack::bindings
