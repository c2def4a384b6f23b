// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "survtrack/segmentation/scene_change.hpp"

#include <pybind11/native_enum.h>

#include "bindings.hpp"

namespace survtrack::bindings {

void bind_scene_change(py::module_& module) {
  py::native_enum<SceneChangeKind>(module, "SceneChangeKind", "enum.Enum", "How a scene changed.")
      .value("cut", SceneChangeKind::cut, "suddenly, to another scene")
      .value("gradual", SceneChangeKind::gradual, "slowly, away from the long-term reference")
      .value("brightness", SceneChangeKind::brightness, "suddenly, and the scene is the same: a lamp")
      .value("infrared", SceneChangeKind::infrared, "its colour went or came back")
      .value("black", SceneChangeKind::black, "a black frame")
      .finalize();
  py::class_<SceneChange>(module, "SceneChange", "A change of the scene, with what showed it.")
      .def_readonly("kind", &SceneChange::kind)
      .def_readonly("measure", &SceneChange::measure, "The measure's name, \"color_part\" or \"black_part\".")
      .def_readonly("value", &SceneChange::value, "What was measured, 0 to 1.")
      .def_readonly("threshold", &SceneChange::threshold, "What it passed, 0 to 1.");
  py::class_<SceneLook>(module, "SceneLook", "What one look of a SceneGuard found.")
      .def_readonly("change", &SceneLook::change, "A SceneChange, or None.")
      .def_readonly("black", &SceneLook::black, "The frame is black, and the scene was not.")
      .def_readonly("against_reference", &SceneLook::against_reference,
                    "The measure between the frame and the long-term reference, 0 to 1.")
      .def_readonly("against_before", &SceneLook::against_before, "The same, and the frame frames_back before.")
      .def_readonly("correlation", &SceneLook::correlation, "Of grey levels with those of the reference, -1 to 1.")
      .def_readonly("color", &SceneLook::color, "Mean of largest less smallest channel, grey levels.")
      .def_readonly("reference_color", &SceneLook::reference_color, "The same of the reference.")
      .def_readonly("black_part", &SceneLook::black_part, "Part of the samples that are black, 0 to 1.");
  py::class_<SceneGuard>(module, "SceneGuard", "Watches a scene as a whole, on a grid of samples; Pipeline does so with scene_change.model guard.")
      .def(py::init<const GuardOptions&>(), py::arg("options") = GuardOptions{}, "Raises ConfigError.")
      .def(
          "look",
          [](SceneGuard& self, const py::object& frame, double time_s) {
            const ImageView view = view_of_image(frame, "frame");
            return self.look(view.image, time_s);
          },
          py::arg("frame"), py::arg("time_s"),
          "The next frame: HxW or HxWx3 (BGR) uint8, all of one size; time_s increases. Raises InputError and then keeps\n"
          "its state.")
      .def_property_readonly("sample_count", &SceneGuard::sample_count, "Pixels that are samples; 0 before the first frame.")
      .def("reset", &SceneGuard::reset, "Forgets everything: the next frame is a first frame.");
}

}  // namespace survtrack::bindings
