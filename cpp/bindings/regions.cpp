// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include <pybind11/native_enum.h>

#include <cmath>

#include "bindings.hpp"
#include "survtrack/core/errors.hpp"
#include "survtrack/core/region.hpp"
#include "survtrack/tracking/predicted_region.hpp"

namespace survtrack::bindings {
namespace {

using Pair = std::pair<double, double>;
using Numbers = py::array_t<double, py::array::c_style | py::array::forcecast>;
using RegionState = py::typing::Tuple<Box, RegionKind, std::int64_t>;

Region make_region(const Box& box, RegionKind kind, std::int64_t track_id) {
  const bool finite =
      std::isfinite(box.x) && std::isfinite(box.y) && std::isfinite(box.width) && std::isfinite(box.height);
  if (!finite || box.width <= 0.0 || box.height <= 0.0) {
    throw InputError("box: " + std::string(py::repr(py::cast(box))) +
                     " is not allowed; expected finite numbers, with a width and height above 0");
  }
  if (track_id < 0) throw InputError("track_id: " + std::to_string(track_id) + " is not allowed; expected 0 or more");
  if (track_id > 0 && kind != RegionKind::predicted) {
    throw InputError("track_id: " + std::to_string(track_id) + " is not allowed of the kind " + to_string(kind) +
                     "; expected 0, or the kind predicted");
  }
  return {box, kind, track_id};
}

Symmetric2 covariance_of(const Numbers& matrix, const char* name) {
  if (matrix.ndim() != 2 || matrix.shape(0) != 2 || matrix.shape(1) != 2 || matrix.at(0, 1) != matrix.at(1, 0)) {
    throw InputError(std::string(name) + ": expected a symmetric 2x2 matrix");
  }
  return {matrix.at(0, 0), matrix.at(0, 1), matrix.at(1, 1)};
}

ExpectedObject object_of(const Pair& before, const Pair& position, const Numbers& covariance_px2, const Box& box, double lost_s) {
  return {{before.first, before.second}, {position.first, position.second}, covariance_of(covariance_px2, "covariance_px2"), box,
          lost_s};
}

}  // namespace

void bind_region_values(py::module_& module) {
  py::native_enum<RegionKind>(module, "RegionKind", "enum.Enum", "Why a part of a frame is read.")
      .value("whole_frame", RegionKind::whole_frame, "Nothing is known yet, or regions would cost about as much.")
      .value("predicted", RegionKind::predicted, "Where a track is expected.")
      .value("acquisition", RegionKind::acquisition, "Where newcomers appear.")
      .value("refresh", RegionKind::refresh, "In turn, so that the background stays up to date.")
      .finalize();
  py::class_<Region>(module, "Region", "A part of a frame that is read.")
      .def(py::init(&make_region), py::arg("box"), py::arg("kind"), py::arg("track_id") = 0,
           "box: px, finite, width and height above 0; track_id: 0 or more, and 0 of every kind but predicted. Raises\n"
           "InputError.")
      .def_readonly("box", &Region::box, "px")
      .def_readonly("kind", &Region::kind)
      .def_readonly("track_id", &Region::track_id, "Of a predicted one; 0: of a tentative track, or of none.")
      .def("__eq__", [](const Region& a, const py::object& b) { return py::isinstance<Region>(b) && a == b.cast<Region>(); })
      .def("__hash__", [](const Region& r) {
        return py::hash(py::make_tuple(r.box.x, r.box.y, r.box.width, r.box.height, to_string(r.kind), r.track_id));
      })
      .def("__repr__", [](const Region& r) {
        return py::str("Region({}, ({:.6g}, {:.6g}, {:.6g}, {:.6g}), track_id={})")
            .format(to_string(r.kind), r.box.x, r.box.y, r.box.width, r.box.height, r.track_id);
      })
      // Any region of the core's own comes back as it was: no checks.
      .def(py::pickle([](const Region& r) -> RegionState { return py::make_tuple(r.box, r.kind, r.track_id); },
                      [](const RegionState& state) {
                        return Region{state[0].cast<Box>(), state[1].cast<RegionKind>(), state[2].cast<std::int64_t>()};
                      }));
}

void bind_regions(py::module_& module) {
  module.def(
      "predicted_region",
      [](const PredictedRegionsOptions& options, const Pair& before, const Pair& position, const Numbers& covariance_px2,
         const Box& box, double lost_s) {
        return predicted_region(options, object_of(before, position, covariance_px2, box, lost_s));
      },
      py::arg("options"), py::arg("before"), py::arg("position"), py::arg("covariance_px2"), py::arg("box"), py::kw_only(),
      py::arg("lost_s") = 0.0,
      "The part of the coming frame that must be read to see an object (O'Malley 2000, 4), a Box that is not cut to the\n"
      "frame. before: (x, y) in px in the frame before; position: the predicted one, with its 2x2 covariance; box: the\n"
      "object's at that position; lost_s: time since it was found last. Raises InputError.");
  module.def(
      "predicted_region_on_path",
      [](const PredictedRegionsOptions& options, const Path& path, const Pair& before, const Pair& place,
         const Numbers& covariance_px2, const Pair& size_px, double lost_s) {
        const ExpectedOnPath expected{{before.first, before.second}, {place.first, place.second},
                                      covariance_of(covariance_px2, "covariance_px2")};
        const Point position = path.to_image(expected.position);
        const ExpectedObject object{path.to_image(expected.before), position, {}, Box::around(position, size_px.first, size_px.second),
                                    lost_s};
        return predicted_region(options, object, path, expected);
      },
      py::arg("options"), py::arg("path"), py::arg("before"), py::arg("place"), py::arg("covariance_px2"), py::arg("size_px"),
      py::kw_only(), py::arg("lost_s") = 0.0,
      "The same of an object on a path: before and place are (S, T) in px, covariance_px2 the 2x2 covariance of the\n"
      "predicted (S, T), size_px the (width, height) of its box. Raises InputError.");
}

}  // namespace survtrack::bindings
