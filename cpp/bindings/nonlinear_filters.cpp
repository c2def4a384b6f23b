// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "filters.hpp"
#include "survtrack/filtering/extended_kalman_filter.hpp"
#include "survtrack/filtering/unscented_kalman_filter.hpp"

namespace survtrack::bindings {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// A filter and what of it is Python's.
template <class Filter>
struct PyFilter {
  Filter filter;
  Callback f, h;
  std::optional<Callback> F, H, residual;
  std::optional<Correction<>> last;
};
using PyExtended = PyFilter<ExtendedKalmanFilter<>>;
using PyUnscented = PyFilter<UnscentedKalmanFilter<>>;

/// f(x), or f(x, u) where predict was given one.
Numbers called(const char* name, const Callback& f, const VectorXd& x, const VectorXd& u) {
  return numbers_returned(name, u.size() == 0 ? f(array_of_vector(x)) : f(array_of_vector(x), array_of_vector(u)));
}

NonlinearModel<> model_of(const Callback& f, const Callback& h, const Numbers& Q, const Numbers& R,
                        const std::optional<Callback>& residual) {
  return {[f](const VectorXd& x, const VectorXd& u) { return vector_of("f", called("f", f, x, u)); },
          [h](const VectorXd& x) { return vector_of("h", called("h", h, x, {})); }, matrix_of("Q", Q), matrix_of("R", R),
          residual_of(residual)};
}

PyExtended make_extended(const Callback& f, const Callback& h, const Numbers& Q, const Numbers& R, const Numbers& x,
                         const Numbers& P, const std::optional<Callback>& F, const std::optional<Callback>& H,
                         const std::optional<Callback>& residual) {
  ExtendedKalmanFilter<>::TransitionJacobian of_f;
  ExtendedKalmanFilter<>::MeasureJacobian of_h;
  if (F) of_f = [F](const VectorXd& at, const VectorXd& u) { return matrix_of("F", called("F", *F, at, u)); };
  if (H) of_h = [H](const VectorXd& at) { return matrix_of("H", called("H", *H, at, {})); };
  return {ExtendedKalmanFilter<>(model_of(f, h, Q, R, residual), vector_of("x", x), matrix_of("P", P), of_f, of_h),
          f, h, F, H, residual, std::nullopt};
}

PyUnscented make_unscented(const Callback& f, const Callback& h, const Numbers& Q, const Numbers& R, const Numbers& x,
                           const Numbers& P, double alpha, double beta, double kappa,
                           const std::optional<Callback>& residual) {
  return {UnscentedKalmanFilter<>(model_of(f, h, Q, R, residual), vector_of("x", x), matrix_of("P", P), {alpha, beta, kappa}),
          f, h, std::nullopt, std::nullopt, residual, std::nullopt};
}

template <class Self>
StateDict state_of_filter(const Self& self) {
  const auto optional = [](const std::optional<Callback>& callback) { return callback ? py::object(*callback) : py::none(); };
  StateDict state;
  state["f"] = self.f;
  state["h"] = self.h;
  state["F"] = optional(self.F);
  state["H"] = optional(self.H);
  state["residual"] = optional(self.residual);
  state["Q"] = array_of_dense(self.filter.model().Q);
  state["R"] = array_of_dense(self.filter.model().R);
  state["x"] = array_of_vector(self.filter.x());
  state["P"] = array_of_dense(self.filter.P());
  state["last"] = state_of(self.last);
  return state;
}

StateDict state_of_unscented(const PyUnscented& self) {
  StateDict state = state_of_filter(self);
  const SigmaPoints& points = self.filter.points();
  state["points"] = py::make_tuple(points.alpha, points.beta, points.kappa);
  return state;
}

template <class Type>
Type part(const StateDict& state, const char* name) {
  return state[name].cast<Type>();
}

PyExtended extended_of(const StateDict& s) {
  using Maybe = std::optional<Callback>;
  PyExtended self = make_extended(part<Callback>(s, "f"), part<Callback>(s, "h"), part<Numbers>(s, "Q"), part<Numbers>(s, "R"),
                                  part<Numbers>(s, "x"), part<Numbers>(s, "P"), part<Maybe>(s, "F"), part<Maybe>(s, "H"),
                                  part<Maybe>(s, "residual"));
  self.last = correction_of(s["last"]);
  return self;
}

PyUnscented unscented_of(const StateDict& s) {
  const auto points = part<py::tuple>(s, "points");
  PyUnscented self = make_unscented(part<Callback>(s, "f"), part<Callback>(s, "h"), part<Numbers>(s, "Q"),
                                    part<Numbers>(s, "R"), part<Numbers>(s, "x"), part<Numbers>(s, "P"),
                                    points[0].cast<double>(), points[1].cast<double>(), points[2].cast<double>(),
                                    part<std::optional<Callback>>(s, "residual"));
  self.last = correction_of(s["last"]);
  return self;
}

template <class Self>
void bind_steps(py::class_<Self>& cls) {
  cls.def("predict", [](Self& self, const std::optional<Numbers>& u) {
       self.filter.predict(u ? vector_of("u", *u) : VectorXd());
     }, py::arg("u") = py::none(), "Moves the state by f, which is called with u too where one is given. The exceptions of\n"
                                   "callables pass through; the filter is then as before.")
      .def("update", [](Self& self, const Numbers& z) {
        self.filter.update(vector_of("z", z));
        self.last = self.filter.last();
      }, py::arg("z"), "Corrects by a measurement of m numbers; a missing one is simply not passed. Raises InputError where z\n"
                       "or what a callable returns is not finite or has a wrong shape, or S is singular.");
  bind_common(cls);
}

}  // namespace

void bind_nonlinear_filters(py::module_& module) {
  py::class_<PyExtended> extended(
      module, "ExtendedKalmanFilter",
      "Kalman filter for x = f(x, u) + noise of covariance Q, z = h(x) + noise of covariance R, linearised where the estimate\n"
      "is: F at the estimate before the step, H at the predicted one (Bar-Shalom, Li and Kirubarajan 2001, 10.3).");
  extended.def(py::init(&make_extended), py::kw_only(), py::arg("f"), py::arg("h"), py::arg("Q"), py::arg("R"), py::arg("x"),
               py::arg("P"), py::arg("F") = py::none(), py::arg("H") = py::none(), py::arg("residual") = py::none(),
               "f(x) or f(x, u) returns n numbers, h(x) m numbers; F (called as f is) and H return their derivatives, n x n and\n"
               "m x n; None: central differences. residual(z, predicted) as for KalmanFilter. Raises InputError.");
  bind_steps(extended);
  extended.def(py::pickle(&state_of_filter<PyExtended>, &extended_of));
  py::class_<PyUnscented> unscented(
      module, "UnscentedKalmanFilter",
      "Kalman filter for x = f(x, u) + noise of covariance Q, z = h(x) + noise of covariance R, by sigma points that go through\n"
      "f and h (Wan and van der Merwe 2000); no derivatives are needed.");
  unscented.def(py::init(&make_unscented), py::kw_only(), py::arg("f"), py::arg("h"), py::arg("Q"), py::arg("R"), py::arg("x"),
                py::arg("P"), py::arg("alpha") = 0.1, py::arg("beta") = 2.0, py::arg("kappa") = 0.0,
                py::arg("residual") = py::none(),
                "f(x) or f(x, u) returns n numbers, h(x) m numbers. alpha (1e-4 to 1): spread of the points; beta: 2 for a\n"
                "Gaussian; kappa: above -n. residual(z, predicted) as for KalmanFilter, for means too. Raises InputError.");
  bind_steps(unscented);
  unscented.def_property_readonly("sigma_points",
                                  [](const PyUnscented& self) { return array_of_columns(self.filter.sigma_points()); },
                                  "(2 n + 1) x n: those of the present state, the mean first.")
      .def(py::pickle(&state_of_unscented, &unscented_of));
  module.def("numeric_jacobian", [](const Callback& function, const Numbers& x) {
    const auto call = [&](const VectorXd& at) { return vector_of("function", called("function", function, at, {})); };
    return array_of_dense(numeric_jacobian(call, vector_of("x", x)));
  }, py::arg("function"), py::arg("x"),
             "Derivative of function(x), which returns m numbers, at x (n numbers): m x n, by central differences. Raises\n"
             "InputError.");
}

}  // namespace survtrack::bindings
