// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include <pybind11/native_enum.h>

#include "options_class.hpp"
#include "survtrack/core/errors.hpp"
#include "survtrack/offline/patterns.hpp"

namespace survtrack::bindings {
namespace {

using FrameSize = std::optional<std::pair<int, int>>;

py::array_t<double> array_of(const std::vector<Point>& points) {
  py::array_t<double> array({static_cast<py::ssize_t>(points.size()), py::ssize_t{2}});
  auto a = array.mutable_unchecked<2>();
  for (py::ssize_t i = 0; i < array.shape(0); ++i) {
    a(i, 0) = points[static_cast<std::size_t>(i)].x;
    a(i, 1) = points[static_cast<std::size_t>(i)].y;
  }
  return array;
}

FrameSize frame_size_of(const Patterns& p) {
  if (p.frame_width <= 0 || p.frame_height <= 0) return {};
  return std::pair{p.frame_width, p.frame_height};
}

void set_frame_size(Patterns& p, const FrameSize& size) {
  constexpr int longest = 1'000'000;
  const auto allowed = [](int side) { return side >= 1 && side <= longest; };
  if (size && !(allowed(size->first) && allowed(size->second))) {
    throw InputError("frame_size: (" + std::to_string(size->first) + ", " + std::to_string(size->second) +
                     ") is not allowed; expected a width and height between 1 and 1000000 px, or None");
  }
  p.frame_width = size ? size->first : 0;
  p.frame_height = size ? size->second : 0;
}

void bind_pattern(py::module_& module) {
  py::class_<Pattern>(module, "Pattern", "A way that many tracks go, and how (Narayana 2007, 11.5).")
      .def_readonly("id", &Pattern::id, "From 1; the most frequent pattern first.")
      .def_readonly("count", &Pattern::count, "Tracks that it was learned from.")
      .def_property_readonly("way", [](const Pattern& p) { return array_of(p.way); },
                             "Nx2 (x, y) in px: the mean of their ways, from where it enters to where it leaves.")
      .def_property_readonly(
          "spread_px",
          [](const Pattern& p) { return py::array_t<double>(static_cast<py::ssize_t>(p.spread_px.size()), p.spread_px.data()); },
          "N numbers: at each point of the way the root mean square distance across it.")
      .def_property_readonly(
          "time_s", [](const Pattern& p) { return py::array_t<double>(static_cast<py::ssize_t>(p.time_s.size()), p.time_s.data()); },
          "N numbers: at each point of the way the mean time since the first.")
      .def_property_readonly("enters", [](const Pattern& p) { return tuple_of(p.enters()); }, "(x, y), px: the way's first point.")
      .def_property_readonly("leaves", [](const Pattern& p) { return tuple_of(p.leaves()); }, "(x, y), px: the way's last point.")
      .def_readonly("size_px", &Pattern::size_px, "Mean of the objects' sizes (root of the box area).")
      .def_readonly("speed_px_per_s", &Pattern::speed_px_per_s, "Mean of the tracks' mean speeds, standing still counted.")
      .def_readonly("speed_deviation_px_per_s", &Pattern::speed_deviation_px_per_s, "Standard deviation over the tracks.")
      .def_readonly("duration_s", &Pattern::duration_s, "Mean over the tracks.")
      .def_readonly("duration_deviation_s", &Pattern::duration_deviation_s, "Standard deviation over the tracks.")
      .def("__repr__", [](const Pattern& p) { return py::str("Pattern(id={}, count={})").format(p.id, p.count); });
}

void bind_activity(py::module_& module) {
  py::native_enum<ActivityKind>(module, "ActivityKind", "enum.Enum", "What a track does, seen by the patterns.")
      .value("usual", ActivityKind::usual, "follows a pattern at about its speed")
      .value("standing", ActivityKind::standing, "has not gone min_travel away from its first place")
      .value("other_way", ActivityKind::other_way, "follows no pattern: elsewhere, in another direction, turning back")
      .value("too_fast", ActivityKind::too_fast, "follows a pattern")
      .value("too_slow", ActivityKind::too_slow, "follows a pattern; a halt on the way counts")
      .finalize();
  py::class_<Activity>(module, "Activity", "What one track does, and the numbers that decided it.")
      .def_readonly("track_id", &Activity::track_id)
      .def_readonly("kind", &Activity::kind)
      .def_property_readonly("unusual", &Activity::unusual, "Neither usual nor standing.")
      .def_readonly("pattern", &Activity::pattern, "Id of the pattern that it follows, or None.")
      .def_readonly("partial", &Activity::partial, "It follows a stretch of the pattern's way, not the whole.")
      .def_readonly("distance", &Activity::distance,
                    "Mean distance from the pattern's way in object sizes; from the nearest when it follows none.\n"
                    "None of a standing track, or without patterns.")
      .def_readonly("angle_deg", &Activity::angle_deg, "Between the directions, 0 to 180; None as distance is.")
      .def_readonly("speed_px_per_s", &Activity::speed_px_per_s, "Length of its way by its duration.")
      .def_readonly("speed_ratio", &Activity::speed_ratio, "In parts of the pattern's mean speed, of a stretch in parts of its speed there; None without a pattern.")
      .def("__repr__", [](const Activity& a) {
        return py::str("Activity(track_id={}, kind={}, pattern={})")
            .format(a.track_id, py::cast(a.kind).attr("name"), a.pattern ? py::object(py::int_(*a.pattern)) : py::none());
      });
}

void bind_learned(py::module_& module) {
  py::class_<Patterns>(module, "Patterns", "The patterns of activity in a scene; len() is their number.")
      .def_static("from_json", &Patterns::from_json, py::arg("json"), py::arg("source") = "patterns",
                  "Reads what to_json() wrote. Raises InputError that names source, the entry and what is expected there.")
      .def("to_json", &Patterns::to_json, "Text that from_json() reads back to the same patterns.")
      .def("classify", py::overload_cast<const History&>(&Patterns::classify, py::const_), py::arg("history"),
           py::call_guard<py::gil_scoped_release>(),
           "What each track does, by its id. A track that follows no whole way may follow a stretch of one: it may begin\n"
           "late, end early, or be still underway. Of several patterns within the limits the nearest is taken. Raises\n"
           "InputError naming track and frame index.")
      .def_readonly("patterns", &Patterns::patterns, "By id.")
      .def_readwrite("options", &Patterns::options, "In force for classify().")
      .def_property("frame_size", &frame_size_of, &set_frame_size,
                    "(width, height) in px of the frames that the tracks come from, or None. It is kept for those who load\n"
                    "the patterns; classify() does not look at it.")
      .def("__len__", [](const Patterns& p) { return p.patterns.size(); })
      .def("__eq__", [](const Patterns& self, const py::object& other) {
        return py::isinstance<Patterns>(other) && self.to_json() == other.cast<const Patterns&>().to_json();
      })
      .def("__repr__", [](const Patterns& p) { return py::str("Patterns({} patterns)").format(p.patterns.size()); });
  module.def("learn_patterns", &learn_patterns, py::arg("history"), py::arg_v("options", PatternOptions{}, "PatternOptions()"),
             py::call_guard<py::gil_scoped_release>(),
             "Groups tracks by the ways they go (Narayana 2007, 11.5). A track is described by points evenly spaced along\n"
             "its way; two go the same way when mean distance and angle are within the limits. The track with most like it\n"
             "leads the first group, of the rest again the one with most, and so on; then each track goes to the group whose\n"
             "mean way is nearest, until none changes. The order of the tracks does not matter; the time grows with the\n"
             "square of their number. Raises InputError naming track and frame index.");
}

}  // namespace

void bind_patterns(py::module_& module) {
  bind_plain_options<PatternOptions>(module, "PatternOptions", "When tracks go the same way, and which are unusual");
  bind_pattern(module);
  bind_activity(module);
  bind_learned(module);
}

}  // namespace survtrack::bindings
