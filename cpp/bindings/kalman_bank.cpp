// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include <functional>

#include "filters.hpp"
#include "survtrack/filtering/kalman_array.hpp"

namespace survtrack::bindings {
namespace {

/// Filters by (N, n) states and (N, n, n) covariances, or one (n, n) for all; returns the first slot. All or none.
int add(KalmanArray& self, const Numbers& states, const Numbers& covariances) {
  const Eigen::MatrixXd x = columns_of("states", states);
  const bool for_all = covariances.ndim() == 2;
  if (!for_all) check_dimensions("covariances", covariances, 3);
  if (!for_all && covariances.shape(0) != states.shape(0)) {
    throw InputError("covariances: has " + std::to_string(covariances.shape(0)) + " matrices; expected " +
                     std::to_string(states.shape(0)) + ", one a filter, or one for all");
  }
  const py::ssize_t rows = covariances.shape(for_all ? 0 : 1), columns = covariances.shape(for_all ? 1 : 2);
  const int first = self.size();
  try {
    for (Eigen::Index k = 0; k < x.cols(); ++k) {
      const double* const P = covariances.data() + (for_all ? 0 : k * rows * columns);
      self.add(x.col(k), Eigen::Map<const RowMajor>(P, rows, columns));
    }
  } catch (...) {  // passed on: the bank is first as it was before
    while (self.size() > first) self.remove(self.size() - 1);
    throw;
  }
  return first;
}

KalmanArray make_bank(const Numbers& F, const Numbers& H, const Numbers& Q, const Numbers& R,
                      const std::optional<Numbers>& states, const std::optional<Numbers>& covariances,
                      const std::optional<Numbers>& B, const std::optional<Numbers>& periods, bool validate) {
  KalmanArray::Model model{matrix_of("F", F), matrix_of("H", H), matrix_of("Q", Q), matrix_of("R", R), {}, {}};
  if (B) model.B = matrix_of("B", *B);
  if (periods) model.periods = vector_of("periods", *periods);
  KalmanArray bank(model, covariances_of(validate));
  if (states.has_value() != covariances.has_value()) throw InputError("states, covariances: expected both or none");
  if (states) add(bank, *states, *covariances);
  return bank;
}

void predict(KalmanArray& self, const std::optional<Numbers>& u) {
  if (!u) return self.predict();
  if (self.model().B.size() == 0) throw InputError("u: the bank has no B to apply it with");
  self.predict(u->ndim() == 1 ? Eigen::MatrixXd(vector_of("u", *u)) : columns_of("u", *u));
}

py::array_t<double> states_of(const KalmanArray& self) { return array_of_columns(self.states()); }

py::array_t<double> matrices(int count, Eigen::Index order, const std::function<Eigen::MatrixXd(int)>& get) {
  py::array_t<double> array({static_cast<py::ssize_t>(count), order, order});
  for (int k = 0; k < count; ++k) Eigen::Map<Eigen::MatrixXd>(array.mutable_data(k), order, order) = get(k);
  return array;
}

py::array_t<double> covariances_array(const KalmanArray& self) {
  return matrices(self.size(), self.model().F.rows(), [&](int k) { return self.covariance(k); });
}

StateDict get_state(const KalmanArray& self) {
  const KalmanArray::Model& model = self.model();
  StateDict state;
  state["F"] = array_of_dense(model.F);
  state["H"] = array_of_dense(model.H);
  state["Q"] = array_of_dense(model.Q);
  state["R"] = array_of_dense(model.R);
  state["states"] = states_of(self);
  state["covariances"] = covariances_array(self);
  state["B"] = model.B.size() == 0 ? py::object(py::none()) : array_of_dense(model.B);
  state["periods"] = model.periods.size() == 0 ? py::object(py::none()) : array_of_vector(model.periods);
  state["validate"] = self.covariances() == Covariances::checked;
  return state;
}

KalmanArray set_state(const StateDict& state) {
  const auto numbers = [&](const char* name) { return state[name].cast<Numbers>(); };
  const auto optional = [&](const char* name) { return state[name].cast<std::optional<Numbers>>(); };
  return make_bank(numbers("F"), numbers("H"), numbers("Q"), numbers("R"), optional("states"), optional("covariances"),
                   optional("B"), optional("periods"), state["validate"].cast<bool>());
}

template <Eigen::MatrixXd KalmanArray::Model::* member, void (KalmanArray::*set)(const Eigen::MatrixXd&)>
void bind_matrix(py::class_<KalmanArray>& cls, const char* name, const char* doc) {
  cls.def_property(name, [](const KalmanArray& self) { return array_of_dense(self.model().*member); },
                   [name](KalmanArray& self, const Numbers& value) { (self.*set)(matrix_of(name, value)); }, doc);
}

}  // namespace

void bind_kalman_bank(py::module_& module) {
  using Model = KalmanArray::Model;
  py::class_<KalmanArray> cls(module, "KalmanBank",
                              "Many Kalman filters with one model between them, predicted and updated together, side by side in the\n"
                              "processor's vector registers. Equal to KalmanFilter up to rounding. In C++: KalmanArray.");
  cls.def(py::init(&make_bank), py::arg("F"), py::arg("H"), py::arg("Q"), py::arg("R"), py::arg("states") = py::none(),
          py::arg("covariances") = py::none(), py::kw_only(), py::arg("B") = py::none(), py::arg("periods") = py::none(),
          py::arg("validate") = true,
          "F (n x n), H (m x n), Q (n x n), R (m x m), B (n x k). Starts with N filters at states (N x n) of covariances\n"
          "(N x n x n, or n x n for all), or with none. periods (m): the lengths after which measurements wrap, 0 where they\n"
          "do not. validate as for KalmanFilter. Raises InputError naming what is wrong.")
      .def("__len__", &KalmanArray::size)
      .def("add", &add, py::arg("states"), py::arg("covariances"),
           "Adds filters, as the constructor takes them; returns the slot of the first. Raises InputError, and then adds none.")
      .def("remove", &KalmanArray::remove, py::arg("slot"), "Ends a filter; later slots move down by one.")
      .def("predict", &predict, py::arg("u") = py::none(),
           "x = F x + B u, P = F P F' + Q for all. u: k numbers for all filters, N x k, or None for no input.")
      .def("update", [](KalmanArray& self, const Numbers& z) { self.update(columns_of("z", z)); }, py::arg("z"),
           "Corrects all filters by an N x m array; a row of NaN is missing, its filter stays as predicted. Raises InputError\n"
           "naming the filter where a row is neither finite nor missing or S is singular; the bank is then as before.")
      .def("squared_mahalanobis",
           [](const KalmanArray& self, const Numbers& z) { return array_of_dense(self.squared_mahalanobis(columns_of("z", z))); },
           py::arg("z"), "N x M: of each filter to each of M measurements (M x m), as KalmanFilter.squared_mahalanobis.")
      .def_property_readonly("states", &states_of, "N x n.")
      .def_property_readonly("covariances", &covariances_array, "N x n x n.")
      .def_property_readonly("innovations", [](const KalmanArray& self) { return array_of_columns(self.innovations()); },
                             "N x m, of the last update; NaN where the measurement was missing.")
      .def_property_readonly("innovation_covariances", [](const KalmanArray& self) {
        return matrices(self.size(), self.model().H.rows(), [&](int k) { return self.innovation_covariance(k); });
      }, "N x m x m, of the last update; NaN where the measurement was missing.")
      .def_property_readonly("nis", [](const KalmanArray& self) { return array_of_vector(self.nis()); },
                             "N numbers: y' S^-1 y of the last update; NaN where the measurement was missing.")
      .def_property_readonly("log_likelihoods", [](const KalmanArray& self) { return array_of_vector(self.log_likelihoods()); },
                             "N numbers: logarithms of the Gaussian densities of the last innovations; NaN likewise.")
      .def(py::pickle(&get_state, &set_state));
  bind_matrix<&Model::F, &KalmanArray::set_F>(cls, "F", "Transition: n x n.");
  bind_matrix<&Model::H, &KalmanArray::set_H>(cls, "H", "Measured of state: m x n.");
  bind_matrix<&Model::Q, &KalmanArray::set_Q>(cls, "Q", "Covariance of the process noise of a step: n x n.");
  bind_matrix<&Model::R, &KalmanArray::set_R>(cls, "R", "Covariance of the measurement noise: m x m.");
}

}  // namespace survtrack::bindings
