// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "filters.hpp"
#include "results.hpp"
#include "survtrack/core/errors.hpp"
#include "survtrack/filtering/noise_identification.hpp"
#include "survtrack/offline/measurement_recorder.hpp"

namespace survtrack::bindings {
namespace {

using Tracks = std::vector<MeasuredTrack>;

std::vector<double> list_of(const char* name, const Numbers& array) {
  const Eigen::VectorXd vector = vector_of(name, array);
  return {vector.data(), vector.data() + vector.size()};
}

std::vector<Point> points_of(const Numbers& positions) {
  if (positions.ndim() != 2 || positions.shape(1) != 2) {
    throw InputError("positions: is " + std::string(py::str(positions.attr("shape"))) + "; expected an Nx2 array in px");
  }
  std::vector<Point> points;
  for (py::ssize_t i = 0; i < positions.shape(0); ++i) points.push_back({positions.at(i, 0), positions.at(i, 1)});
  return points;
}

MeasuredTrack measured_track(const Numbers& times, const Numbers& positions, const std::optional<Numbers>& lengths) {
  MeasuredTrack track{list_of("times", times), points_of(positions)};
  if (lengths) {
    track.lengths = list_of("lengths", *lengths);
    if (track.lengths.empty() && !track.times.empty()) throw InputError("lengths: is empty; expected one a time, or None");
  }
  check_measured_tracks({track}, 0);
  return track;
}

MeasurementNoise noise_of_positions(const Numbers& positions, const std::optional<Numbers>& times) {
  MeasuredTrack track;
  track.positions = points_of(positions);
  if (times) track.times = list_of("times", *times);
  while (!times && track.times.size() < track.positions.size()) {
    track.times.push_back(static_cast<double>(track.times.size()));
  }
  return identify_measurement_noise({track}, NoiseUnit::px);
}

NoiseUnit unit_of(const std::string& name) {
  std::string allowed;
  for (const auto& [known, unit] : enum_names(NoiseUnit{})) {
    if (name == known) return unit;
    allowed += (allowed.empty() ? "" : ", ") + std::string(known);
  }
  throw InputError("noise_unit: unknown \"" + name + "\"; one of: " + allowed);
}

void bind_measured(py::module_& module) {
  py::class_<MeasuredTrack>(module, "MeasuredTrack", "What was measured of one object, in order of time.")
      .def(py::init(&measured_track), py::arg("times"), py::arg("positions"), py::arg("lengths") = py::none(),
           "times: N numbers that increase, in time units; positions: Nx2, px; lengths: N, the object's size in px as it was\n"
           "known before each, None: 1. Raises InputError.")
      .def("__len__", [](const MeasuredTrack& t) { return t.times.size(); })
      .def_property_readonly("times", [](const MeasuredTrack& t) {
        return py::array_t<double>(static_cast<py::ssize_t>(t.times.size()), t.times.data());
      }, "N, time units")
      .def_property_readonly("positions", [](const MeasuredTrack& t) {
        py::array_t<double> array({static_cast<py::ssize_t>(t.positions.size()), py::ssize_t{2}});
        auto a = array.mutable_unchecked<2>();
        for (py::ssize_t i = 0; i < a.shape(0); ++i) {
          a(i, 0) = t.positions[static_cast<std::size_t>(i)].x;
          a(i, 1) = t.positions[static_cast<std::size_t>(i)].y;
        }
        return array;
      }, "Nx2, px")
      .def_property_readonly("lengths", [](const MeasuredTrack& t) -> py::typing::Optional<py::array_t<double>> {
        if (t.lengths.empty()) return py::none();
        return py::array_t<double>(static_cast<py::ssize_t>(t.lengths.size()), t.lengths.data());
      }, "N, px; None: 1 each")
      .def("stands_still", &stands_still, py::arg("max_speed") = 0.05, py::arg("max_range") = 0.3,
           "Whether its slope is at most max_speed lengths per time unit and its range max_range lengths. Raises InputError.")
      .def("__repr__", [](const MeasuredTrack& t) {
        return "MeasuredTrack(" + std::to_string(t.times.size()) + " measurements)";
      });
  py::class_<MeasurementRecorder>(module, "MeasurementRecorder",
                                  "Collects what was measured of the confirmed tracks of a run, frame by frame. Leaves out blobs that\n"
                                  "several tracks share, and detections that the frame's border cuts.")
      .def(py::init<const Config&, double>(), py::arg("config"), py::kw_only(), py::arg("max_gap_s") = 1.0,
           "After a longer gap a track goes on as another one. Raises ConfigError, InputError.")
      .def("add", [](MeasurementRecorder& self, const PyFrameResult& result) { self.add(result.value); }, py::arg("result"),
           "Takes the result of one frame; frames come in order.")
      .def("add",
           [](MeasurementRecorder& self, const TrackingResult& result, const PyDetections& detections) {
             self.add(result, detections.value);
           },
           py::arg("result"), py::arg("detections"))
      .def("tracks", &MeasurementRecorder::tracks, py::arg("least") = 2,
           "Those of at least so many measurements; times in the config's time units, lengths the tracks' sizes before.")
      .def_property_readonly("used", &MeasurementRecorder::used, "Measurements taken.")
      .def_property_readonly("shared", &MeasurementRecorder::shared, "Left out: blobs of several tracks.")
      .def_property_readonly("at_border", &MeasurementRecorder::at_border, "Left out: cut by the frame's border.");
}

void bind_found(py::module_& module) {
  py::class_<NoiseEstimate>(module, "NoiseEstimate", "A number found from data.")
      .def_readonly("value", &NoiseEstimate::value)
      .def_readonly("standard_error", &NoiseEstimate::standard_error, "0: it was given; inf: the data do not determine it.")
      .def("__repr__", [](const NoiseEstimate& e) {
        std::ostringstream text;
        text << "NoiseEstimate(" << e.value << " +- " << e.standard_error << ")";
        return text.str();
      });
  py::class_<MeasurementNoise>(module, "MeasurementNoise", "R, from objects that stand still.")
      .def_property_readonly("R", [](const MeasurementNoise& n) { return array_of_dense(n.R); },
                             "2x2 covariance of a measured position, in squares of the noise unit.")
      .def_property_readonly("standard_error", [](const MeasurementNoise& n) { return array_of_dense(n.standard_error); },
                             "2x2, of each element of R, for Gaussian noise without memory.")
      .def_readonly("position_noise", &MeasurementNoise::position_noise, "Root of the mean variance: the option.")
      .def_readonly("samples", &MeasurementNoise::samples)
      .def_readonly("degrees", &MeasurementNoise::degrees, "Of freedom: samples less 2 a track.");
  py::class_<FilterConsistency>(module, "FilterConsistency", "How well a filter fits measurements.")
      .def_readonly("steps", &FilterConsistency::steps, "Innovations: measurements after the first of each track.")
      .def_readonly("log_likelihood", &FilterConsistency::log_likelihood)
      .def_readonly("nis_mean", &FilterConsistency::nis_mean, "Mean of y' S^-1 y: 2 if Q and R fit.")
      .def_readonly("nis_band", &FilterConsistency::nis_band, "(low, high), with probability 0.95 if they fit.")
      .def_readonly("correlation", &FilterConsistency::correlation,
                    "Of innovations with the next one of the track: 0 if they fit.")
      .def_readonly("correlation_limit", &FilterConsistency::correlation_limit,
                    "Of its size, with probability 0.95 if they fit.");
  py::class_<ProcessNoise>(module, "ProcessNoise", "Q, by maximum likelihood.")
      .def_readonly("options", &ProcessNoise::options, "Those given, with what was found.")
      .def_readonly("process_noise", &ProcessNoise::process_noise, "The option velocity_noise or acceleration_noise.")
      .def_readonly("position_noise", &ProcessNoise::position_noise)
      .def_readonly("initial_velocity", &ProcessNoise::initial_velocity)
      .def_readonly("initial_acceleration", &ProcessNoise::initial_acceleration, "Of kalman_ca; 0 otherwise.")
      .def_readonly("before", &ProcessNoise::before, "FilterConsistency with the options given.")
      .def_readonly("after", &ProcessNoise::after, "The same with those found.");
}

}  // namespace

void bind_noise(py::module_& module) {
  bind_measured(module);
  bind_found(module);
  module.def("identify_measurement_noise",
             [](const Tracks& still, const std::string& noise_unit) {
               return identify_measurement_noise(still, unit_of(noise_unit));
             },
             py::arg("still"), py::arg("noise_unit") = "object_size",
             "The covariance of the measured positions of objects that stand still about a straight line in time, one each.\n"
             "noise_unit: \"object_size\" divides by the tracks' lengths, \"px\" does not. Raises InputError for fewer than 3\n"
             "measurements of an object.");
  module.def("identify_measurement_noise", &noise_of_positions, py::arg("positions"), py::arg("times") = py::none(),
             "The same of one object: Nx2 positions in px, at N times that increase (None: 0, 1, 2, ...).");
  module.def("filter_consistency", &filter_consistency, py::arg("tracks"), py::arg("options"),
             py::call_guard<py::gil_scoped_release>(),
             "Runs the filter of KalmanCvOptions or KalmanCaOptions over MeasuredTracks, each from its first measurement, and\n"
             "tests its innovations. Raises InputError, ConfigError.");
  module.def("identify_process_noise", &identify_process_noise, py::arg("tracks"), py::arg("options"), py::kw_only(),
             py::arg("fit_position_noise") = true, py::call_guard<py::gil_scoped_release>(),
             "Which noises of KalmanCvOptions or KalmanCaOptions maximise the likelihood of MeasuredTracks: the process noise,\n"
             "the deviations of a new track, and position_noise unless it is not to be fitted. Raises InputError for fewer\n"
             "than 10 steps, ConfigError.");
}

}  // namespace survtrack::bindings
