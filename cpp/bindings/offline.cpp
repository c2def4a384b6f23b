// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "options_class.hpp"
#include "results.hpp"
#include "survtrack/core/errors.hpp"
#include "survtrack/offline/link.hpp"

namespace survtrack::bindings {
namespace {

struct PointRow {
  std::int64_t id, index;
  double time_s, x, y, width, height;
  double position_x, position_y;
  double velocity_x_px_per_s, velocity_y_px_per_s;
  double mean_blue, mean_green, mean_red;
};

py::array array_of(const History& history) {
  std::vector<PointRow> rows;
  for (const RecordedTrack& track : history.tracks) {
    for (const TrackPoint& p : track.points) {
      rows.push_back({track.id, p.index, p.time_s, p.box.x, p.box.y, p.box.width, p.box.height, p.position.x, p.position.y,
                      p.velocity_px_per_s.x, p.velocity_px_per_s.y, p.mean_color.blue, p.mean_color.green, p.mean_color.red});
    }
  }
  return py::array_t<PointRow>(static_cast<py::ssize_t>(rows.size()), rows.data());
}

template <class Value>
using Array = py::array_t<Value, py::array::c_style | py::array::forcecast>;

/// `count` rows of `width` numbers; width 1: a plain column. Nothing was given: zeros.
template <class Value>
Array<Value> columns_of(const py::object& values, const char* name, py::ssize_t count, py::ssize_t width) {
  const std::vector<py::ssize_t> shape = width == 1 ? std::vector{count} : std::vector{count, width};
  if (values.is_none()) {
    Array<Value> zeros(shape);
    std::fill_n(zeros.mutable_data(), zeros.size(), Value{});
    return zeros;
  }
  Array<double> numbers = Array<double>::ensure(values);
  if (!numbers) PyErr_Clear();
  const bool fits = numbers && (numbers.size() == 0 ? count == 0
                                                    : std::equal(shape.begin(), shape.end(), numbers.shape(),
                                                                 numbers.shape() + numbers.ndim()));
  if (!fits) {
    throw InputError(std::string(name) + ": expected " + std::to_string(count) + (width == 1 ? "" : "x" + std::to_string(width)) +
                     " numbers, a row a point");
  }
  if constexpr (std::is_integral_v<Value>) {
    constexpr double largest = 9007199254740992.0;  // 2^53: beyond it a double skips integers
    for (py::ssize_t i = 0; i < numbers.size(); ++i) {
      const double number = numbers.data()[i];
      if (std::abs(number) <= largest && number == std::floor(number)) continue;
      throw InputError(std::string(name) + "[" + std::to_string(i) + "]: " + std::string(py::str(py::float_(number))) +
                       " is not an integer within +-2^53");
    }
  }
  return Array<Value>(numbers);
}

History history_of_columns(const py::object& ids, const py::object& indices, const py::object& times_s,
                           const py::object& boxes, const py::object& positions, const py::object& velocities_px_per_s,
                           const py::object& mean_colors) {
  const auto count = static_cast<py::ssize_t>(py::len(ids));
  const auto id = columns_of<std::int64_t>(ids, "ids", count, 1);
  const auto index = columns_of<std::int64_t>(indices, "indices", count, 1);
  const auto time_s = columns_of<double>(times_s, "times_s", count, 1);
  const auto box = columns_of<double>(boxes, "boxes", count, 4);
  const auto position = columns_of<double>(positions, "positions", count, 2);
  const auto velocity = columns_of<double>(velocities_px_per_s, "velocities_px_per_s", count, 2);
  const auto color = columns_of<double>(mean_colors, "mean_colors", count, 3);
  History history;
  std::unordered_map<std::int64_t, std::size_t> row_of_id;
  for (py::ssize_t i = 0; i < count; ++i) {
    const auto [found, is_new] = row_of_id.try_emplace(id.data()[i], history.tracks.size());
    if (is_new) history.tracks.push_back({id.data()[i], {}});
    const double *b = box.data() + 4 * i, *p = position.data() + 2 * i, *v = velocity.data() + 2 * i, *c = color.data() + 3 * i;
    const Box place{b[0], b[1], b[2], b[3]};
    history.tracks[found->second].points.push_back({index.data()[i], time_s.data()[i], place,
                                                    positions.is_none() ? place.center() : Point{p[0], p[1]},
                                                    {v[0], v[1]}, {c[0], c[1], c[2]}});
  }
  for (RecordedTrack& track : history.tracks) {
    std::stable_sort(track.points.begin(), track.points.end(),
                     [](const TrackPoint& a, const TrackPoint& b) { return a.index < b.index; });
  }
  check_history(history);
  return history;
}

void bind_history(py::module_& module) {
  PYBIND11_NUMPY_DTYPE(PointRow, id, index, time_s, x, y, width, height, position_x, position_y, velocity_x_px_per_s,
                       velocity_y_px_per_s, mean_blue, mean_green, mean_red);
  py::class_<History>(module, "History", "All tracks of a run that is over.")
      .def(py::init<>())
      .def_static("from_columns", &history_of_columns, py::kw_only(), py::arg("ids"), py::arg("indices"), py::arg("times_s"),
                  py::arg("boxes"), py::arg("positions") = py::none(), py::arg("velocities_px_per_s") = py::none(),
                  py::arg("mean_colors") = py::none(),
                  "From N points in any order: ids and indices (of frames, from 0) are N integers, times_s N numbers, boxes Nx4\n"
                  "(left, top, width, height in px), positions Nx2 in px (the box centres), velocities_px_per_s Nx2 (0),\n"
                  "mean_colors Nx3 (blue, green, red, 0 to 255; 0). Raises InputError that names track and frame index.")
      .def("__len__", [](const History& h) { return h.tracks.size(); })
      .def_property_readonly("array", &array_of, "All points as one structured array, track by track.");
  py::class_<HistoryRecorder>(module, "HistoryRecorder", "Collects the reported tracks of a run, frame by frame.")
      .def(py::init<>())
      .def("add", [](HistoryRecorder& r, const TrackingResult& result) { r.add(result); }, py::arg("result"),
           "Takes the result of one frame; frames come in order.")
      .def("add", [](HistoryRecorder& r, const PyFrameResult& result) { r.add(result.value); }, py::arg("result"))
      .def_property_readonly("history", [](const HistoryRecorder& r) { return r.history(); }, "A copy of what was collected.");
}

void bind_linked(py::module_& module) {
  py::class_<Link>(module, "Link", "Two tracks that are one, and the numbers that decided it.")
      .def_readonly("earlier_id", &Link::earlier_id)
      .def_readonly("later_id", &Link::later_id)
      .def_readonly("gap_s", &Link::gap_s, "From the last point of the one to the first of the other.")
      .def_readonly("distance", &Link::distance, "Object sizes, both extrapolated to the middle of the gap.")
      .def_readonly("speed_difference", &Link::speed_difference, "Object sizes per second.")
      .def_readonly("color_difference", &Link::color_difference, "0 to 1.73.")
      .def_readonly("cost", &Link::cost, "Mean of the four in parts of their limits, 0 to 1.")
      .def("__repr__", [](const Link& l) {
        return py::str("Link(earlier_id={}, later_id={}, cost={:.3g})").format(l.earlier_id, l.later_id, l.cost);
      });
  py::class_<DroppedTrack>(module, "DroppedTrack", "A track that is too short, after joining.")
      .def_readonly("id", &DroppedTrack::id)
      .def_readonly("frames", &DroppedTrack::frames, "In which it has a point.")
      .def_readonly("duration_s", &DroppedTrack::duration_s)
      .def_readonly("travel", &DroppedTrack::travel, "Object sizes; largest distance from its first place.")
      .def("__repr__", [](const DroppedTrack& d) {
        return py::str("DroppedTrack(id={}, frames={})").format(d.id, d.frames);
      });
  py::class_<Linked>(module, "Linked", "What is left of a history, and why.")
      .def_readonly("history", &Linked::history, "By id.")
      .def_readonly("links", &Linked::links, "In order of the earlier one's start; ids are those of the given tracks.")
      .def_readonly("dropped", &Linked::dropped, "By id.");
  module.def("link_tracks", &link_tracks, py::arg("history"), py::arg_v("options", LinkOptions{}, "LinkOptions()"),
             py::call_guard<py::gil_scoped_release>(),
             "Joins the pieces of broken tracks, then drops tracks that are too short (Narayana 2007, 11.2). A chain of\n"
             "pieces gets the id of its first; its gaps stay gaps. Raises InputError naming track and frame index.");
}

}  // namespace

void bind_offline(py::module_& module) {
  bind_history(module);
  bind_plain_options<LinkOptions>(module, "LinkOptions",
                                  "When two tracks are one, and which tracks are too short to be real");
  bind_linked(module);
}

}  // namespace survtrack::bindings
