// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include <pybind11/native_enum.h>

#include "bindings.hpp"
#include "survtrack/core/detection.hpp"
#include "survtrack/core/event.hpp"
#include "survtrack/core/expectation.hpp"
#include "survtrack/core/matches.hpp"
#include "survtrack/core/track.hpp"

namespace survtrack::bindings {
namespace {

using BoxState = py::typing::Tuple<double, double, double, double>;

std::string box_repr(const Box& b) {
  return py::str("Box(x={:.6g}, y={:.6g}, width={:.6g}, height={:.6g})").format(b.x, b.y, b.width, b.height);
}

void bind_box(py::module_& module) {
  py::class_<Box>(module, "Box", "An axis-parallel box: left and top edge and size, in px.")
      .def(py::init([](double x, double y, double width, double height) { return Box{x, y, width, height}; }),
           py::arg("x"), py::arg("y"), py::arg("width"), py::arg("height"))
      .def_readonly("x", &Box::x, "Left edge, px.")
      .def_readonly("y", &Box::y, "Top edge, px.")
      .def_readonly("width", &Box::width, "px")
      .def_readonly("height", &Box::height, "px")
      .def_property_readonly("right", &Box::right, "px")
      .def_property_readonly("bottom", &Box::bottom, "px")
      .def_property_readonly("area_px", &Box::area_px, "px^2")
      .def_property_readonly("center", [](const Box& b) { return tuple_of(b.center()); }, "(x, y), px")
      .def("__iter__", [](const Box& b) -> py::typing::Iterator<double> {
        return py::iter(py::make_tuple(b.x, b.y, b.width, b.height));
      })
      .def("__eq__", [](const Box& a, const py::object& b) { return py::isinstance<Box>(b) && a == b.cast<Box>(); })
      .def("__hash__", [](const Box& b) { return py::hash(py::make_tuple(b.x, b.y, b.width, b.height)); })
      .def("__repr__", &box_repr)
      .def(py::pickle([](const Box& b) -> BoxState { return py::make_tuple(b.x, b.y, b.width, b.height); },
                      [](const BoxState& state) {
                        const auto number = [&](py::size_t k) { return state[k].cast<double>(); };
                        return Box{number(0), number(1), number(2), number(3)};
                      }));
  module.def("iou", &iou, py::arg("a"), py::arg("b"), "Intersection over union of two boxes, 0 to 1.");
}

void bind_detection(py::module_& module) {
  py::class_<Detection>(module, "Detection", "Something seen in one frame: a blob, or a box of your own detector.")
      .def_readonly("box", &Detection::box, "px")
      .def_property_readonly("position", [](const Detection& d) { return tuple_of(d.position); },
                             "(x, y) in px: a blob's centroid over all its pixels, else the box centre.")
      .def_readonly("area_px", &Detection::area_px, "Number of foreground pixels; a box's area for own boxes.")
      .def_property_readonly("mean_color", [](const Detection& d) { return tuple_of(d.mean_color); },
                             "(blue, green, red), 0 to 255; zero when there was no image.")
      .def_property_readonly("moments_px2", [](const Detection& d) { return array_of(d.moments_px2); },
                             "2x2 second central moments over the pixels, px^2.")
      .def_readonly("confidence", &Detection::confidence, "1 for blobs; your detector's score otherwise.")
      .def_readonly("class_id", &Detection::class_id, "-1: no class.")
      .def_readonly("shared", &Detection::shared, "A share of a blob that several tracks cover.")
      .def("__repr__", [](const Detection& d) {
        return py::str("Detection(box={}, area_px={:.6g})").format(box_repr(d.box), d.area_px);
      });
}

void bind_track(py::module_& module) {
  py::native_enum<TrackStatus>(module, "TrackStatus", "enum.Enum", "Where a track is in its life.")
      .value("tentative", TrackStatus::tentative, "seen too few times to be believed")
      .value("confirmed", TrackStatus::confirmed, "matched in this frame, or in a group that is")
      .value("lost", TrackStatus::lost, "not matched in this frame")
      .value("closed", TrackStatus::closed, "ended in this frame")
      .finalize();
  py::class_<Track>(module, "Track", "One object followed through time, as known after one frame.")
      .def_readonly("id", &Track::id, "From 1, without gaps, given again only to who comes back; 0 while tentative.")
      .def_readonly("status", &Track::status)
      .def_readonly("reported", &Track::reported, "Part of the answer of this frame: written to files and drawn.")
      .def_readonly("box", &Track::box, "Estimated box in this frame, px.")
      .def_property_readonly("position", [](const Track& t) { return tuple_of(t.position); }, "(x, y), px")
      .def_property_readonly("velocity_px_per_s", [](const Track& t) { return tuple_of(t.velocity_px_per_s); }, "(x, y)")
      .def_property_readonly("position_covariance_px2",
                             [](const Track& t) { return array_of(t.position_covariance_px2); }, "2x2, px^2")
      .def_property_readonly("velocity_covariance_px2_per_s2",
                             [](const Track& t) { return array_of(t.velocity_covariance_px2_per_s2); },
                             "2x2; zero of filters that do not know theirs (mean_velocity)")
      .def_property_readonly("position_velocity_covariance_px2_per_s",
                             [](const Track& t) { return array_of(t.position_velocity_covariance_px2_per_s); },
                             "2x2, rows of the position, columns of the velocity")
      .def_property_readonly("velocity_noise_px2_per_s3",
                             [](const Track& t) { return array_of(t.velocity_noise_px2_per_s3); },
                             "2x2, process noise: what the velocity's covariance gains in a second")
      .def_property_readonly("predicted_position", [](const Track& t) { return tuple_of(t.predicted_position); },
                             "(x, y) in px: where this frame's detection was expected.")
      .def_property_readonly("mean_color", [](const Track& t) { return tuple_of(t.mean_color); },
                             "(blue, green, red) of the detection last matched.")
      .def_readonly("detection", &Track::detection, "Index of this frame's matched detection, or that of its group; -1: none.")
      .def_readonly("group", &Track::group, "Of tracks that share one detection the id of the oldest; 0: it shares none.")
      .def_readonly("age_frames", &Track::age_frames, "Frames since its first detection, that one not counted.")
      .def_readonly("matched_frames", &Track::matched_frames, "Frames with a detection, the first one counted.")
      .def_readonly("lost_frames", &Track::lost_frames, "Frames since its last detection.")
      .def_readonly("start_index", &Track::start_index, "Index of the frame of its first detection.")
      .def_readonly("end_index", &Track::end_index, "Index of the frame of its last detection.")
      .def_readonly("start_time_s", &Track::start_time_s)
      .def_readonly("end_time_s", &Track::end_time_s)
      .def("__repr__", [](const Track& t) {
        return py::str("Track(id={}, status={}, box={})").format(t.id, to_string(t.status), box_repr(t.box));
      });
}

void bind_event(py::module_& module) {
  py::native_enum<LostPlace>(module, "LostPlace", "enum.Enum", "Where a track was when it was seen last.")
      .value("none", LostPlace::none, "the event is no loss")
      .value("border", LostPlace::border, "at the frame's border: it left")
      .value("behind_object", LostPlace::behind_object, "beside or behind another track: occluded, or merged")
      .value("open", LostPlace::open, "with nothing near: it stopped, or went behind the scene")
      .finalize();
  py::native_enum<EventKind>(module, "EventKind", "enum.Enum", "What happened.")
      .value("track_started", EventKind::track_started, "a track was confirmed")
      .value("track_reentered", EventKind::track_reentered, "the same of one that has the id of a track that had ended")
      .value("track_lost", EventKind::track_lost, "a confirmed track found no detection")
      .value("track_recovered", EventKind::track_recovered, "a lost track found a detection again")
      .value("track_ended", EventKind::track_ended, "a confirmed track was closed")
      .value("merged", EventKind::merged, "tracks share one detection from here on")
      .value("split", EventKind::split, "tracks of a group have detections of their own again")
      .value("converged", EventKind::converged, "tracks believe to be the same blob")
      .value("anomalous_speed", EventKind::anomalous_speed, "a track moves unlike those before it there")
      .value("scene_changed", EventKind::scene_changed, "the whole scene changed")
      .finalize();
  py::class_<Event>(module, "Event", "Something that happened in one frame.")
      .def_readonly("kind", &Event::kind)
      .def_readonly("index", &Event::index, "The frame's index in its source.")
      .def_readonly("time_s", &Event::time_s)
      .def_readonly("track_id", &Event::track_id, "0: concerns no track.")
      .def_readonly("place", &Event::place, "Where a track that ended was lost.")
      .def_readonly("confidence", &Event::confidence, "Of a track that came back: that it is the same, 0 to 1.")
      .def_readonly("other_track_ids", &Event::other_track_ids, "The other tracks concerned, by id.")
      .def_property_readonly("position", [](const Event& e) { return tuple_of(e.position); }, "(x, y), px")
      .def_readonly("box", &Event::box, "px")
      .def_property_readonly("position_covariance_px2",
                             [](const Event& e) { return array_of(e.position_covariance_px2); }, "2x2, px^2")
      .def_readonly("text", &Event::text, "One readable sentence.")
      .def("__repr__", [](const Event& e) {
        return py::str("Event(kind={}, index={}, track_id={})").format(to_string(e.kind), e.index, e.track_id);
      });
}

template <class Get>
py::array_t<double> cell_array(const VicinityGrid& grid, Get get) {
  py::array_t<double> array({grid.rows, grid.columns});
  double* out = array.mutable_data();
  for (const VicinityCell& cell : grid.cells) *out++ = static_cast<double>(get(cell));
  return array;
}

void bind_vicinity(py::module_& module) {
  py::class_<VicinityGrid>(module, "VicinityGrid",
                           "The vicinity factor: how much things move, and so how near they are, in each cell of the\n"
                           "scene (Narayana 2007, 6). Arrays are rows x columns float64.")
      .def_readonly("cell_px", &VicinityGrid::cell_px, "Side of a cell, px.")
      .def_property_readonly("frame_size", [](const VicinityGrid& g) { return std::pair<int, int>{g.frame_width, g.frame_height}; },
                             "(width, height), px")
      .def_readonly("max_factor", &VicinityGrid::max_factor)
      .def_property_readonly("factor_y", [](const VicinityGrid& g) {
        return cell_array(g, [](const VicinityCell& c) { return c.factor_y; });
      }, "Vicinity factor in Y, 1 to max_factor.")
      .def_property_readonly("factor_x", [](const VicinityGrid& g) {
        return cell_array(g, [](const VicinityCell& c) { return c.factor_x; });
      }, "Vicinity factor in X, 1 to max_factor.")
      .def_property_readonly("updates", [](const VicinityGrid& g) {
        return cell_array(g, [](const VicinityCell& c) { return c.updates; });
      }, "Number of displacements learned.")
      .def_property_readonly("active", [](const VicinityGrid& g) {
        py::array_t<bool> array({g.rows, g.columns});
        bool* out = array.mutable_data();
        for (const VicinityCell& cell : g.cells) *out++ = VicinityGrid::active(cell);
        return array;
      }, "Rows x columns bool: cells where something was followed (7.2).")
      .def_property_readonly("relative_size", [](const VicinityGrid& g) {
        return cell_array(g, [](const VicinityCell& c) { return VicinityGrid::relative_size(c); });
      }, "Relative size of objects: sqrt(factor_y^2 + factor_x^2) (7.2).")
      .def_property_readonly("mean_step_px", [](const VicinityGrid& g) {
        return cell_array(g, [](const VicinityCell& c) { return c.mean_step_px; });
      }, "Mean length of a displacement, px per time unit.")
      .def_property_readonly("step_deviation_px", [](const VicinityGrid& g) {
        return cell_array(g, [](const VicinityCell& c) { return std::sqrt(c.step_variance_px2); });
      }, "Its standard deviation, px per time unit.");
}

void bind_expectation(py::module_& module) {
  py::class_<PredictedTrack>(module, "PredictedTrack", "A track as the tracker expects to see it in the coming frame.")
      .def_readonly("id", &PredictedTrack::id)
      .def_readonly("confirmed", &PredictedTrack::confirmed)
      .def_readonly("box", &PredictedTrack::box, "px")
      .def_property_readonly("position", [](const PredictedTrack& t) { return tuple_of(t.position); }, "(x, y), px")
      .def_property_readonly("velocity_px_per_s",
                             [](const PredictedTrack& t) { return tuple_of(t.velocity_px_per_s); }, "(x, y)")
      .def_property_readonly("innovation_covariance_px2",
                             [](const PredictedTrack& t) { return array_of(t.innovation_covariance_px2); },
                             "2x2, px^2, of the measurement about its predicted position")
      .def_readonly("lost_s", &PredictedTrack::lost_s, "Time since its last detection, at the coming frame.");
  py::class_<SceneScale>(module, "SceneScale", "How large an object should measure where its foot stands.")
      .def_readonly("known", &SceneScale::known, "Enough was seen for the law to be used.")
      .def("height_px", &SceneScale::height_px, py::arg("bottom"),
           "Expected height in px of an object whose lower edge is at row `bottom`.");
  py::class_<Expectation>(module, "Expectation", "What the tracker expects of the coming frame.")
      .def_readonly("time_s", &Expectation::time_s)
      .def_readonly("tracks", &Expectation::tracks)
      .def_readonly("scale", &Expectation::scale, "How large objects are, where.")
      .def_readonly("vicinity", &Expectation::vicinity, "How much things move, where; None without vicinity.model grid.")
      .def_readonly("only_regions", &Expectation::only_regions, "Only regions are read, and what is refreshed in turn; else all is.")
      .def_readonly("regions", &Expectation::regions, "Where to look.")
      .def_readonly("keep", &Expectation::keep, "Places that the background must not learn.");
  py::class_<Match>(module, "Match", "A pair of track and detection that passed the gate.")
      .def_readonly("track_id", &Match::track_id)
      .def_readonly("track", &Match::track, "Row among the tracks open before the frame.")
      .def_readonly("detection", &Match::detection, "Index among the frame's detections.")
      .def_readonly("cost", &Match::cost, "The smaller, the better.")
      .def_readonly("assigned", &Match::assigned, "Chosen by the assignment.");
}

}  // namespace

void bind_values(py::module_& module) {
  bind_box(module);
  bind_region_values(module);
  bind_detection(module);
  bind_track(module);
  bind_event(module);
  bind_vicinity(module);
  bind_expectation(module);
}

}  // namespace survtrack::bindings
