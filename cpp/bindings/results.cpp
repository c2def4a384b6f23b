// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "results.hpp"

#include <algorithm>
#include <cmath>

#include "survtrack/core/errors.hpp"

namespace survtrack::bindings {
namespace {

struct TrackRow {
  std::int64_t id;
  std::uint8_t status;
  bool reported;
  double x, y, width, height;
  double position_x, position_y;
  double velocity_x_px_per_s, velocity_y_px_per_s;
  double covariance_xx_px2, covariance_xy_px2, covariance_yy_px2;
  std::int32_t detection, age_frames, matched_frames, lost_frames;
  std::int64_t group;
};

struct DetectionRow {
  double x, y, width, height;
  double position_x, position_y, area_px;
  double mean_blue, mean_green, mean_red;
  double moment_xx_px2, moment_xy_px2, moment_yy_px2;
  double confidence;
  std::int32_t class_id;
};

TrackRow row_of(const Track& t) {
  const Symmetric2& P = t.position_covariance_px2;
  return {t.id, static_cast<std::uint8_t>(t.status), t.reported, t.box.x, t.box.y, t.box.width, t.box.height,
          t.position.x, t.position.y, t.velocity_px_per_s.x, t.velocity_px_per_s.y, P.xx, P.xy, P.yy,
          t.detection, t.age_frames, t.matched_frames, t.lost_frames, t.group};
}

DetectionRow row_of(const Detection& d) {
  return {d.box.x, d.box.y, d.box.width, d.box.height, d.position.x, d.position.y, d.area_px,
          d.mean_color.blue, d.mean_color.green, d.mean_color.red,
          d.moments_px2.xx, d.moments_px2.xy, d.moments_px2.yy, d.confidence, d.class_id};
}

template <class Row, class Value>
py::array rows_of(const std::vector<Value>& values) {
  py::array_t<Row> array(static_cast<py::ssize_t>(values.size()));
  auto rows = array.template mutable_unchecked<1>();
  for (std::size_t i = 0; i < values.size(); ++i) rows(static_cast<py::ssize_t>(i)) = row_of(values[i]);
  return array;
}

using Column = py::array_t<double, py::array::c_style | py::array::forcecast>;

/// An optional column of numbers, one a box.
Column column_of(const py::object& values, const char* name, py::ssize_t count) {
  Column column = Column::ensure(values);
  if (!column || column.ndim() != 1 || column.shape(0) != count) {
    PyErr_Clear();
    throw InputError(std::string(name) + ": expected " + std::to_string(count) + " numbers, one a box");
  }
  return column;
}

}  // namespace

py::array track_array(const std::vector<Track>& tracks) { return rows_of<TrackRow>(tracks); }
py::array detection_array(const std::vector<Detection>& detections) { return rows_of<DetectionRow>(detections); }

Detections detections_of_boxes(const py::object& boxes, double time_s, std::int64_t index,
                               const py::object& confidences, const py::object& class_ids,
                               std::pair<int, int> frame_size) {
  const Column array = Column::ensure(boxes);
  if (!array) PyErr_Clear();
  const bool empty = array && array.size() == 0;
  if (!array || (!empty && (array.ndim() != 2 || array.shape(1) != 4))) {
    throw InputError("boxes: is " + (array ? std::string(py::str(array.attr("shape"))) : std::string("no array")) +
                     "; expected an Nx4 array of left, top, width, height in px");
  }
  if (frame_size.first < 0 || frame_size.second < 0) {
    throw InputError("frame_size: (" + std::to_string(frame_size.first) + ", " + std::to_string(frame_size.second) +
                     ") is not allowed; expected width and height in px, (0, 0) when unknown");
  }
  Detections detections;
  detections.index = index;
  detections.time_s = time_s;
  detections.frame_width = frame_size.first;
  detections.frame_height = frame_size.second;
  const py::ssize_t count = empty ? 0 : array.shape(0);
  detections.items.resize(static_cast<std::size_t>(count));
  for (py::ssize_t i = 0; i < count; ++i) {
    detections.items[static_cast<std::size_t>(i)] =
        detection_of_box({array.at(i, 0), array.at(i, 1), array.at(i, 2), array.at(i, 3)});
  }
  if (!confidences.is_none()) {
    const Column column = column_of(confidences, "confidences", count);
    for (py::ssize_t i = 0; i < count; ++i) {
      if (!std::isfinite(column.at(i))) throw InputError("confidences: expected finite numbers");
      detections.items[static_cast<std::size_t>(i)].confidence = column.at(i);
    }
  }
  if (!class_ids.is_none()) {
    const Column column = column_of(class_ids, "class_ids", count);
    for (py::ssize_t i = 0; i < count; ++i) {
      if (!(std::abs(column.at(i)) < 1e9) || column.at(i) != std::floor(column.at(i))) throw InputError("class_ids: expected integers below 1e9");
      detections.items[static_cast<std::size_t>(i)].class_id = static_cast<int>(column.at(i));
    }
  }
  return detections;
}

namespace {

/// N x 8 x 8 x 8, blue, green, red.
py::array_t<float> histogram_array(const std::vector<ColorHistogram>& histograms) {
  constexpr py::ssize_t bins = ColorHistogram::bins;
  py::array_t<float> array({static_cast<py::ssize_t>(histograms.size()), bins, bins, bins});
  float* out = array.mutable_data();
  for (const ColorHistogram& histogram : histograms) out = std::copy(histogram.parts.begin(), histogram.parts.end(), out);
  return array;
}

std::vector<ColorHistogram> histograms_of(const py::object& given, std::size_t count) {
  if (given.is_none()) return {};
  using Parts = py::array_t<float, py::array::c_style | py::array::forcecast>;
  const Parts array = Parts::ensure(given);
  if (!array) PyErr_Clear();
  if (!array || static_cast<std::size_t>(array.size()) != count * ColorHistogram::size || array.shape(0) != static_cast<py::ssize_t>(count)) {
    throw InputError("histograms: is " + (array ? std::string(py::str(array.attr("shape"))) : std::string("no array")) +
                     "; expected " + std::to_string(count) + "x8x8x8, one a box");
  }
  std::vector<ColorHistogram> histograms(count);
  for (std::size_t i = 0; i < count; ++i) {
    std::copy_n(array.data() + i * ColorHistogram::size, ColorHistogram::size, histograms[i].parts.begin());
    check_histogram(histograms[i], "histograms[" + std::to_string(i) + "]");
  }
  return histograms;
}

/// None for an empty one.
py::typing::Optional<py::array_t<float>> optional_field(const cv::Mat& field) {
  if (field.empty()) return py::none();
  return array_of_field(field);
}
constexpr const char* flow_doc =
    "The flow field, HxWx2 float32, px to the right and down, with config.outputs.flow; else None, as in the first\n"
    "frames, which have none.";

void bind_detections(py::module_& module) {
  py::class_<PyDetections>(module, "Detections", "All detections of one frame: a sequence of Detection.")
      .def(py::init([](const py::object& boxes, double time_s, std::int64_t index, const py::object& confidences,
                       const py::object& class_ids, std::pair<int, int> frame_size, const py::object& histograms) {
             Detections detections = detections_of_boxes(boxes, time_s, index, confidences, class_ids, frame_size);
             detections.histograms = histograms_of(histograms, detections.items.size());
             return PyDetections{std::move(detections)};
           }),
           py::arg("boxes"), py::arg("time_s"), py::kw_only(), py::arg("index") = 0,
           py::arg("confidences") = py::none(), py::arg("class_ids") = py::none(),
           py::arg("frame_size") = std::pair<int, int>{0, 0}, py::arg("histograms") = py::none(),
           "From your own detector: boxes is Nx4 (left, top, width, height in px); confidences and class_ids have N\n"
           "numbers; frame_size is (width, height) in px, (0, 0) when unknown; histograms is Nx8x8x8, a color_histogram()\n"
           "a box, for appearance.model color_histogram.")
      .def("__len__", [](const PyDetections& d) { return d.value.items.size(); })
      .def(
          "__getitem__",
          [](const PyDetections& d, py::ssize_t i) {
            const auto n = static_cast<py::ssize_t>(d.value.items.size());
            if (i < -n || i >= n) throw py::index_error("detection index out of range");
            return d.value.items[static_cast<std::size_t>(i < 0 ? i + n : i)];
          },
          py::arg("index"))
      .def("__iter__", [](const PyDetections& d) -> py::typing::Iterator<Detection> {
        return py::iter(py::cast(d.value.items));
      })
      .def_property_readonly("index", [](const PyDetections& d) { return d.value.index; })
      .def_property_readonly("time_s", [](const PyDetections& d) { return d.value.time_s; })
      .def_property_readonly("frame_size", [](const PyDetections& d) {
        return std::pair<int, int>{d.value.frame_width, d.value.frame_height};
      }, "(width, height), px")
      .def_property_readonly("mask", [](const PyDetections& d) -> py::object {
        return d.value.mask.empty() ? py::object(py::none()) : array_of_image(d.value.mask);
      }, "HxW uint8, 0 or 255; None for your own boxes.")
      .def_property_readonly("background", [](const PyDetections& d) -> py::object {
        return d.value.background.empty() ? py::object(py::none()) : array_of_image(d.value.background);
      }, "The background picture, with config.outputs.background; else None.")
      .def_property_readonly("flow", [](const PyDetections& d) { return optional_field(d.value.flow); }, flow_doc)
      .def_property_readonly("contours", [](const PyDetections& d) {
        py::typing::List<py::array_t<std::int32_t>> contours;
        for (const auto& contour : d.value.contours) {
          py::array_t<std::int32_t> points({static_cast<py::ssize_t>(contour.size()), py::ssize_t{2}});
          auto p = points.mutable_unchecked<2>();
          for (std::size_t i = 0; i < contour.size(); ++i) {
            p(static_cast<py::ssize_t>(i), 0) = contour[i].x;
            p(static_cast<py::ssize_t>(i), 1) = contour[i].y;
          }
          contours.append(points);
        }
        return contours;
      }, "An Nx2 int32 array (x, y) a detection, with config.outputs.contours; else empty.")
      .def_property_readonly("histograms", [](const PyDetections& d) { return histogram_array(d.value.histograms); },
                             "Nx8x8x8 float32, the color_histogram() of each, with appearance.model color_histogram; else 0x8x8x8.")
      .def_property_readonly("regions", [](const PyDetections& d) { return d.value.regions; },
                             "The parts of the frame that were read; they may overlap.")
      .def_property_readonly("pixels_read", [](const PyDetections& d) { return d.value.pixels_read; },
                             "Number of pixels in them, each counted once.")
      .def_property_readonly("events", [](const PyDetections& d) { return d.value.events; }, "Raised by the detector.")
      .def_property_readonly("array", [](const PyDetections& d) { return detection_array(d.value.items); },
                             "All detections as one structured array.");
}

py::typing::Optional<py::array_t<double>> array_of_matrix(bool given, const CostMatrix& matrix) {
  if (!given) return py::none();
  py::array_t<double> array({matrix.rows(), matrix.columns()});
  auto a = array.mutable_unchecked<2>();
  for (int i = 0; i < matrix.rows(); ++i) {
    for (int j = 0; j < matrix.columns(); ++j) a(i, j) = matrix(i, j);
  }
  return array;
}

template <class Class, class Get>
void bind_tracking_part(Class& cls, Get get) {
  cls.def_property_readonly("index", [get](const typename Class::type& r) { return get(r).index; },
                            "The frame's index in its source.")
      .def_property_readonly("time_s", [get](const typename Class::type& r) { return get(r).time_s; })
      .def_property_readonly("tracks", [get](const typename Class::type& r) { return get(r).tracks; },
                             "Believed tracks (confirmed, lost, or closed in this frame) in order of id.")
      .def_property_readonly("tentative", [get](const typename Class::type& r) { return get(r).tentative; },
                             "Candidates, seen too few times to be believed; their id is 0.")
      .def_property_readonly("track_array", [get](const typename Class::type& r) { return track_array(get(r).tracks); },
                             "The believed tracks as one structured array.")
      .def_property_readonly("events", [get](const typename Class::type& r) { return get(r).events; },
                             "The detector's, then the tracker's.")
      .def_property_readonly("matches", [get](const typename Class::type& r) { return get(r).matches.candidates; },
                             "All pairs of track and detection that passed the gate, with their costs.")
      .def_property_readonly("matrix_track_ids", [get](const typename Class::type& r) { return get(r).matrix_track_ids; },
                             "The rows of costs and beliefs: ids of the tracks open before the frame; 0: tentative.")
      .def_property_readonly("vicinity", [get](const typename Class::type& r) { return get(r).vicinity; },
                             "The VicinityGrid of each class of detections (-1: none), with config.outputs.vicinity.")
      .def_property_readonly("beliefs", [get](const typename Class::type& r) { return array_of_matrix(get(r).has_matrices && get(r).beliefs.columns() > 0, get(r).beliefs); },
                             "Tracks x (detections + 1): probabilities, the last column for \"lost\", with cost.model belief\n"
                             "and config.outputs.cost_matrix; else None.")
      .def_property_readonly("costs", [get](const typename Class::type& r) { return array_of_matrix(get(r).has_matrices, get(r).costs); }, "Tracks x detections, inf outside the gate, with config.outputs.cost_matrix; else None.");
}

}  // namespace

void bind_results(py::module_& module) {
  PYBIND11_NUMPY_DTYPE(TrackRow, id, status, reported, x, y, width, height, position_x, position_y,
                       velocity_x_px_per_s, velocity_y_px_per_s, covariance_xx_px2, covariance_xy_px2,
                       covariance_yy_px2, detection, age_frames, matched_frames, lost_frames, group);
  PYBIND11_NUMPY_DTYPE(DetectionRow, x, y, width, height, position_x, position_y, area_px, mean_blue, mean_green,
                       mean_red, moment_xx_px2, moment_xy_px2, moment_yy_px2, confidence, class_id);
  bind_detections(module);
  py::class_<TrackingResult> tracking(module, "TrackingResult", "What the tracker knows after one frame.");
  bind_tracking_part(tracking, [](const TrackingResult& r) -> const TrackingResult& { return r; });
  py::class_<PyFrameResult> frame(module, "FrameResult", "Everything about one processed frame.");
  bind_tracking_part(frame, [](const PyFrameResult& r) -> const TrackingResult& { return r.value; });
  frame
      .def_property_readonly("frame", [](const PyFrameResult& r) { return r.frame; },
                             "The frame: the array given to process, or a copy of it when the pipeline has a delay.")
      .def_property_readonly("mask", [](const PyFrameResult& r) { return array_of_image(r.value.detections.mask); },
                             "Foreground mask after cleanup, HxW uint8, 0 or 255.")
      .def_property_readonly("background", [](const PyFrameResult& r) -> py::object {
        const cv::Mat& picture = r.value.detections.background;
        return picture.empty() ? py::object(py::none()) : array_of_image(picture);
      }, "The background picture, with config.outputs.background; else None.")
      .def_property_readonly("flow", [](const PyFrameResult& r) { return optional_field(r.value.detections.flow); }, flow_doc)
      .def_property_readonly("regions", [](const PyFrameResult& r) { return r.value.detections.regions; },
                             "The parts of the frame that were read; they may overlap.")
      .def_property_readonly("pixels_read", [](const PyFrameResult& r) { return r.value.detections.pixels_read; },
                             "Number of pixels in them, each counted once.")
      .def_property_readonly("detections", [](const PyFrameResult& r) { return PyDetections{r.value.detections}; },
                             "The frame's detections, a sequence.")
      .def_property_readonly("detection_array",
                             [](const PyFrameResult& r) { return detection_array(r.value.detections.items); },
                             "All detections as one structured array.");
}

}  // namespace survtrack::bindings
