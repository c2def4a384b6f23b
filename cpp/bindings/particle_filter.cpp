// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "survtrack/filtering/particle_filter.hpp"

#include "filters.hpp"
#include "survtrack/filtering/random.hpp"

namespace survtrack::bindings {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

struct PyParticleFilter {
  ParticleFilter<> filter;
  Callback f, log_likelihood;
};

PyParticleFilter make_filter(const Callback& f, const Callback& log_likelihood, const Numbers& Q, const Numbers& x,
                             const Numbers& P, int count, double resample_below, std::uint64_t seed) {
  ParticleFilter<>::Model model;
  model.f = [f](const MatrixXd& particles, const VectorXd& u) {
    const py::array_t<double> rows = array_of_columns(particles);
    return columns_of("f", numbers_returned("f", u.size() == 0 ? f(rows) : f(rows, array_of_vector(u))));
  };
  model.log_likelihood = [log_likelihood](const VectorXd& z, const MatrixXd& particles) {
    const py::object returned = log_likelihood(array_of_vector(z), array_of_columns(particles));
    return vector_of("log_likelihood", numbers_returned("log_likelihood", returned));
  };
  model.Q = matrix_of("Q", Q);
  return {ParticleFilter<>(model, vector_of("x", x), matrix_of("P", P), {count, resample_below, seed}), f, log_likelihood};
}

py::tuple tuple_of_random(const Random::State& s) {
  return py::make_tuple(s.words[0], s.words[1], s.words[2], s.words[3], s.spare, s.has_spare);
}

Random::State random_of(const py::tuple& t) {
  Random::State state{{}, t[4].cast<double>(), t[5].cast<bool>()};
  for (std::size_t i = 0; i < 4; ++i) state.words[i] = t[i].cast<std::uint64_t>();
  return state;
}

StateDict get_state(const PyParticleFilter& self) {
  const ParticleFilter<>& filter = self.filter;
  StateDict state;
  state["f"] = self.f;
  state["log_likelihood"] = self.log_likelihood;
  state["Q"] = array_of_dense(filter.model().Q);
  state["options"] = py::make_tuple(filter.options().count, filter.options().resample_below, filter.options().seed);
  state["particles"] = array_of_columns(filter.particles());
  state["weights"] = array_of_vector(filter.weights());
  state["random"] = tuple_of_random(filter.random().state());
  state["last"] = py::make_tuple(filter.log_likelihood(), filter.resamplings());
  return state;
}

PyParticleFilter set_state(const StateDict& state) {
  const auto options = state["options"].cast<py::tuple>(), last = state["last"].cast<py::tuple>();
  const auto Q = state["Q"].cast<Numbers>();
  const py::array_t<double> nowhere = array_of_vector(VectorXd::Zero(Q.shape(0)));
  const py::array_t<double> nothing = array_of_dense(MatrixXd::Zero(Q.shape(0), Q.shape(0)));
  PyParticleFilter self = make_filter(state["f"].cast<Callback>(), state["log_likelihood"].cast<Callback>(), Q, nowhere, nothing,
                                      options[0].cast<int>(), options[1].cast<double>(), options[2].cast<std::uint64_t>());
  self.filter.restore(columns_of("particles", state["particles"].cast<Numbers>()),
                      vector_of("weights", state["weights"].cast<Numbers>()), random_of(state["random"].cast<py::tuple>()),
                      last[0].cast<double>(), last[1].cast<int>());
  return self;
}

template <class Draw>
py::array_t<double> drawn(py::ssize_t count, const Draw& draw) {
  if (count < 0) throw InputError("count: is " + std::to_string(count) + "; expected at least 0");
  py::array_t<double> array(count);
  for (py::ssize_t i = 0; i < count; ++i) array.mutable_at(i) = draw();
  return array;
}

}  // namespace

void bind_particle_filter(py::module_& module) {
  py::class_<PyParticleFilter>(
      module, "ParticleFilter",
      "Bootstrap particle filter (Gordon, Salmond and Smith 1993): any motion, any noise of measurements. Systematic\n"
      "resampling when the effective sample size falls under a share. The same seed gives the same particles everywhere.")
      .def(py::init(&make_filter), py::kw_only(), py::arg("f"), py::arg("log_likelihood"), py::arg("Q"), py::arg("x"),
           py::arg("P"), py::arg("count") = 1000, py::arg("resample_below") = 0.5, py::arg("seed") = 0,
           "f(particles) or f(particles, u) moves all particles at once, (count x n) to (count x n); the filter adds noise of\n"
           "covariance Q (zero: f adds its own). log_likelihood(z, particles) returns count numbers, up to a constant; -inf\n"
           "where z is impossible. The particles are drawn from the Gaussian of mean x (n) and covariance P (n x n).\n"
           "resample_below: share of count, 0 to 1. Raises InputError naming what is wrong.")
      .def("predict", [](PyParticleFilter& self, const std::optional<Numbers>& u) {
        self.filter.predict(u ? vector_of("u", *u) : VectorXd());
      }, py::arg("u") = py::none(), "Moves the particles by f and adds noise. The exceptions of callables pass through.")
      .def("update", [](PyParticleFilter& self, const Numbers& z) { self.filter.update(vector_of("z", z)); }, py::arg("z"),
           "Weights the particles by a measurement, and resamples where needed. Raises InputError where z is not finite, or\n"
           "impossible for every particle; the filter is then as before.")
      .def_property_readonly("x", [](const PyParticleFilter& self) { return array_of_vector(self.filter.x()); },
                             "Weighted mean of the particles: n numbers.")
      .def_property_readonly("P", [](const PyParticleFilter& self) { return array_of_dense(self.filter.P()); },
                             "Their weighted covariance: n x n.")
      .def_property_readonly("particles", [](const PyParticleFilter& self) { return array_of_columns(self.filter.particles()); },
                             "count x n.")
      .def_property_readonly("weights", [](const PyParticleFilter& self) { return array_of_vector(self.filter.weights()); },
                             "count numbers, of sum 1.")
      .def_property_readonly("effective_size", [](const PyParticleFilter& self) { return self.filter.effective_size(); },
                             "1 / sum of squared weights, as they are now: 1 to count.")
      .def_property_readonly("log_likelihood", [](const PyParticleFilter& self) { return self.filter.log_likelihood(); },
                             "Logarithm of the likelihood of the last measurement given those before, as estimated; 0 at first.")
      .def_property_readonly("resamplings", [](const PyParticleFilter& self) { return self.filter.resamplings(); }, "So far.")
      .def(py::pickle(&get_state, &set_state));
  py::class_<Random>(module, "Random",
                     "Random numbers that are the same bytes on every platform: xoshiro256++, normal numbers by Marsaglia's polar\n"
                     "method.")
      .def(py::init<std::uint64_t>(), py::arg("seed") = 0)
      .def("uniform", [](Random& self, py::ssize_t count) { return drawn(count, [&] { return self.uniform(); }); },
           py::arg("count"), "So many numbers in [0, 1).")
      .def("normal", [](Random& self, py::ssize_t count) { return drawn(count, [&] { return self.normal(); }); },
           py::arg("count"), "So many numbers of mean 0 and variance 1.");
  module.def("systematic_resample", [](const Numbers& weights, double offset) {
    const std::vector<int> chosen = systematic_resample(vector_of("weights", weights), offset);
    py::array_t<std::int64_t> array(static_cast<py::ssize_t>(chosen.size()));
    for (std::size_t i = 0; i < chosen.size(); ++i) array.mutable_at(static_cast<py::ssize_t>(i)) = chosen[i];
    return array;
  }, py::arg("weights"), py::arg("offset"),
             "Which of the weighted items systematic resampling draws, in order, as many as there are weights (Kitagawa 1996).\n"
             "offset: the one random number, in [0, 1). Raises InputError.");
}

}  // namespace survtrack::bindings
