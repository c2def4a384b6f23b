// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "survtrack/tracking/paths.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "bindings.hpp"
#include "survtrack/core/errors.hpp"
#include "survtrack/offline/pattern_path.hpp"

namespace survtrack::bindings {
namespace {

using Numbers = py::array_t<double, py::array::c_style | py::array::forcecast>;
using FrameSize = std::optional<std::pair<int, int>>;

static_assert(sizeof(Point) == 2 * sizeof(double) && sizeof(PathPosition) == 2 * sizeof(double), "rows of an Nx2 array");

/// Nx2 numbers; an empty list has no rows.
Numbers rows_of(const py::object& values, const char* name) {
  Numbers rows = Numbers::ensure(values);
  if (!rows) PyErr_Clear();
  if (rows && rows.ndim() == 1 && rows.size() == 0) return Numbers(std::vector<py::ssize_t>{0, 2});
  if (!rows || rows.ndim() != 2 || rows.shape(1) != 2) {
    throw InputError(std::string(name) + ": expected Nx2 numbers" +
                     (rows ? ", not an array of shape " + std::string(py::str(py::array(rows).attr("shape"))) : ""));
  }
  return rows;
}

template <class Value>
const Value* values_of(const Numbers& rows) {
  return reinterpret_cast<const Value*>(rows.data());
}

/// An Nx2 array that `fill(count, values)` writes without the interpreter's lock.
template <class Value, class Fill>
py::array_t<double> filled(py::ssize_t count, Fill&& fill) {
  py::array_t<double> array({count, py::ssize_t{2}});
  auto* values = reinterpret_cast<Value*>(array.mutable_data());
  const py::gil_scoped_release release;
  fill(static_cast<std::size_t>(count), values);
  return array;
}

std::vector<Point> points_of(const py::object& values) {
  const Numbers rows = rows_of(values, "points");
  const auto* points = values_of<Point>(rows);
  return {points, points + rows.shape(0)};
}

PathKind kind_of(const std::string& name) {
  for (const PathKind kind : {PathKind::line, PathKind::curve}) {
    if (name == to_string(kind)) return kind;
  }
  throw InputError("kind: \"" + name + "\" is not allowed; expected line or curve");
}

double most_distance(const std::optional<double>& max_distance_px) {
  return max_distance_px.value_or(std::numeric_limits<double>::infinity());
}

py::array_t<double> directions(const Path& path, const Numbers& s_px, Point (Path::*direction)(double) const) {
  if (s_px.ndim() != 1) throw InputError("s_px: expected a list of numbers");
  return filled<Point>(s_px.size(), [&](std::size_t count, Point* out) {
    for (std::size_t i = 0; i < count; ++i) out[i] = (path.*direction)(s_px.data()[i]);
  });
}

py::array_t<double> velocities(const Path& path, const py::object& positions, const py::object& moving) {
  const Numbers points = rows_of(positions, "points"), speeds = rows_of(moving, "velocities_px_per_s");
  if (points.shape(0) != speeds.shape(0)) {
    throw InputError("velocities_px_per_s: has " + std::to_string(speeds.shape(0)) + " rows; expected " +
                     std::to_string(points.shape(0)) + ", as points");
  }
  return filled<PathPosition>(points.shape(0), [&](std::size_t count, PathPosition* out) {
    const Point *p = values_of<Point>(points), *v = values_of<Point>(speeds);
    for (std::size_t i = 0; i < count; ++i) out[i] = path.velocity(p[i], v[i]);
  });
}

void bind_path(py::module_& module) {
  py::class_<Path> path(module, "Path",
      "A way through the image and coordinates by it: S along and T across (O'Malley 2000, 3), both in px.\n\n"
      "T is positive to the right of who goes along the path, as seen in the picture. To each position belongs the\n"
      "nearest point of the path; of those at equal distance the one with the smallest S. Beyond the ends of an open path\n"
      "both go straight on. Outside of a corner S is the corner's and T the distance from it. A Path never changes.");
  path.def(py::init([](const py::object& points, bool closed, const std::string& kind, std::optional<double> max_distance_px) {
             return Path(points_of(points), closed, kind_of(kind), most_distance(max_distance_px));
           }),
           py::arg("points"), py::arg("closed") = false, py::kw_only(), py::arg("kind") = "line",
           py::arg("max_distance_px") = py::none(),
           "points: Nx2 (x, y) in px, 2 to 2000, 3 or more when closed; the last of a closed path is not the first again.\n"
           "kind: \"line\", straight with corners, or \"curve\", a centripetal Catmull-Rom spline. max_distance_px: a position\n"
           "farther off the path gets NaN. Raises InputError that names the point: not finite or beyond 1e6 px, the same as the\n"
           "one before, where the path turns straight back, or meets itself.")
      .def_static("from_json", &Path::from_json, py::arg("json"), py::arg("source") = "path",
                  "Reads what to_json() wrote. Raises InputError that names source, the entry and what is expected there.")
      .def("to_json", &Path::to_json, "Text that from_json() reads back to the same path.")
      .def_static("from_pattern",
                  [](const Pattern& pattern, const std::string& kind, std::optional<double> close_within_px,
                     std::optional<double> max_distance_px) {
                    return path_of_pattern(pattern, kind_of(kind), close_within_px, most_distance(max_distance_px));
                  },
                  py::arg("pattern"), py::kw_only(), py::arg("kind") = "curve", py::arg("close_within_px") = py::none(),
                  py::arg("max_distance_px") = py::none(),
                  "Along the way of a learned pattern. Closed when the way, having been twice as far away, comes back to within\n"
                  "close_within_px of its start (None: the objects' size), in about the direction in which it left; what comes\n"
                  "after is another lap and left out. Raises InputError, such as for a way that meets itself elsewhere.");
  path.def_property_readonly("points", [](const Path& p) {
            return filled<Point>(static_cast<py::ssize_t>(p.points().size()), [&](std::size_t count, Point* out) {
              std::copy_n(p.points().data(), count, out);
            });
          }, "Nx2 (x, y), px.")
      .def_property_readonly("closed", &Path::closed)
      .def_property_readonly("kind", [](const Path& p) { return to_string(p.kind()); }, "\"line\" or \"curve\".")
      .def_property_readonly("max_distance_px", [](const Path& p) {
            return std::isfinite(p.max_distance_px()) ? std::optional<double>(p.max_distance_px()) : std::nullopt;
          }, "Or None.")
      .def_property_readonly("length_px", &Path::length_px, "Of a closed path once round.")
      .def("to_path", [](const Path& p, const py::object& points) {
            const Numbers rows = rows_of(points, "points");
            return filled<PathPosition>(rows.shape(0), [&](std::size_t count, PathPosition* out) {
              p.to_path(values_of<Point>(rows), count, out);
            });
          }, py::arg("points"),
          "Nx2 (S, T) of Nx2 (x, y), px. S of a closed path is at least 0 and below the length. Rows farther off the path than\n"
          "max_distance_px are NaN. Raises InputError for a number that is not finite or beyond 1e9.")
      .def("to_image", [](const Path& p, const py::object& places) {
            const Numbers rows = rows_of(places, "places");
            return filled<Point>(rows.shape(0), [&](std::size_t count, Point* out) {
              p.to_image(values_of<PathPosition>(rows), count, out);
            });
          }, py::arg("places"),
          "Nx2 (x, y) of Nx2 (S, T), px; a closed path goes round and round. Raises InputError as to_path() does.")
      .def("velocities", &velocities, py::arg("points"), py::arg("velocities_px_per_s"),
           "Nx2 (dS/dt, dT/dt) in px/s of points that move, both Nx2: ds/dt = (v . tangent) / (1 - T / radius), the divisor\n"
           "kept above 0.01. NaN as of to_path().")
      .def("stretches", [](const Path& p, const py::object& places) {
            const Numbers rows = rows_of(places, "places");
            py::array_t<double> array(rows.shape(0));
            for (py::ssize_t i = 0; i < rows.shape(0); ++i) array.mutable_at(i) = p.stretch(values_of<PathPosition>(rows)[i]);
            return array;
          }, py::arg("places"),
          "How far points at Nx2 places (S, T) move along for each px of S: 1 - T / radius, kept between 0.01 and 100.")
      .def("tangents", [](const Path& p, const Numbers& s) { return directions(p, s, &Path::tangent); }, py::arg("s_px"),
           "Nx2, of length 1: where the path goes at each S; at a corner the mean of both directions.")
      .def("normals", [](const Path& p, const Numbers& s) { return directions(p, s, &Path::normal); }, py::arg("s_px"),
           "Nx2, of length 1: to the side where T is positive.")
      .def("wrap", py::vectorize([](const Path* p, double s_px) { return p->wrap(s_px); }), py::arg("s_px"),
           "S of a closed path brought to at least 0 and below the length; a number, or an array of them.")
      .def("residual", py::vectorize([](const Path* p, double measured, double predicted) { return p->residual(measured, predicted); }),
           py::arg("measured_s_px"), py::arg("predicted_s_px"),
           "From the predicted to the measured S, numbers or arrays: of a closed path the shorter way round,\n"
           "((d + l/2) mod l) - l/2 (O'Malley 2000).")
      .def("__eq__", [](const Path& self, const py::object& other) { return py::isinstance<Path>(other) && self == other.cast<const Path&>(); })
      .def("__repr__", [](const Path& p) {
        return py::str("Path({} points, {}{}, {:.1f} px)").format(p.points().size(), p.closed() ? "closed " : "", to_string(p.kind()), p.length_px());
      });
}

const Path& named(const Paths& paths, const std::string& name) {
  std::string names;
  for (const NamedPath& item : paths.items()) {
    if (item.name == name) return item.path;
    names += (names.empty() ? "" : ", ") + item.name;
  }
  throw py::key_error("no path \"" + name + "\"; there are: " + names);
}

FrameSize frame_size_of(const Paths& p) {
  if (p.frame_width <= 0 || p.frame_height <= 0) return {};
  return std::pair{p.frame_width, p.frame_height};
}

Paths make_paths(const py::typing::Dict<std::string, Path>& given, const FrameSize& size) {
  constexpr int longest = 1'000'000;
  const auto allowed = [](int side) { return side >= 1 && side <= longest; };
  if (size && !(allowed(size->first) && allowed(size->second))) {
    throw InputError("frame_size: (" + std::to_string(size->first) + ", " + std::to_string(size->second) +
                     ") is not allowed; expected a width and height between 1 and 1000000 px, or None");
  }
  Paths paths;
  for (const auto& [name, path] : given) {
    if (!py::isinstance<py::str>(name) || !py::isinstance<Path>(path)) {
      throw InputError("paths: " + std::string(py::repr(name)) + ": " + std::string(py::repr(path)) +
                       " is not allowed; expected a text and its Path");
    }
    paths.add(name.cast<std::string>(), path.cast<const Path&>());
  }
  paths.frame_width = size ? size->first : 0;
  paths.frame_height = size ? size->second : 0;
  return paths;
}

void bind_named(py::module_& module) {
  py::class_<Paths>(module, "Paths", "The paths of a scene by name, in their order, and the file that holds them.")
      .def(py::init(&make_paths), py::arg("paths"), py::arg("frame_size") = py::none(),
           "paths: Path by name; frame_size: (width, height) in px of the frames that they are drawn on, or None. Raises\n"
           "InputError for a name that is not 1 to 100 bytes without control characters.")
      .def_static("from_json", &Paths::from_json, py::arg("json"), py::arg("source") = "paths",
                  "Reads a file of paths. Raises InputError that names source, the entry and what is expected there.")
      .def("to_json", &Paths::to_json, "Text that from_json() reads back to the same paths.")
      .def_property_readonly("frame_size", &frame_size_of, "(width, height) in px, or None.")
      .def_property_readonly("names", [](const Paths& p) {
            std::vector<std::string> names;
            for (const NamedPath& item : p.items()) names.push_back(item.name);
            return names;
          })
      .def("__getitem__", &named, py::arg("name"), "The Path of this name.")
      .def("__contains__", [](const Paths& p, const std::string& name) {
            for (const NamedPath& item : p.items()) {
              if (item.name == name) return true;
            }
            return false;
          }, py::arg("name"))
      .def("__len__", [](const Paths& p) { return p.items().size(); })
      .def("__eq__", [](const Paths& self, const py::object& other) {
        return py::isinstance<Paths>(other) && self.to_json() == other.cast<const Paths&>().to_json();
      })
      .def("__repr__", [](const Paths& p) { return py::str("Paths({} paths)").format(p.items().size()); });
}

}  // namespace

void bind_paths(py::module_& module) {
  bind_path(module);
  bind_named(module);
}

}  // namespace survtrack::bindings
