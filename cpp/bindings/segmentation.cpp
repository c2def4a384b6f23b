// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include <memory>
#include <optional>

#include "masks.hpp"
#include "results.hpp"
#include "survtrack/blobs/blob_extractor.hpp"
#include "survtrack/core/checks.hpp"
#include "survtrack/core/errors.hpp"
#include "survtrack/segmentation/cleanup.hpp"
#include "survtrack/segmentation/segmenter.hpp"

namespace survtrack::bindings {
namespace {

/// A background model that checks what comes from Python; models with a look-ahead go through `Detector`.
struct PySegmenter {
  explicit PySegmenter(const SegmenterOptions& options) : model(make_segmenter(options)) {
    if (model->delay_frames() > 0) {
      throw ConfigError("segmenter.window: a centred window has a delay of " + std::to_string(model->delay_frames()) +
                        " frames; Segmenter takes models without delay, Detector takes all");
    }
  }

  std::unique_ptr<Segmenter> model;
  cv::Size size;
  int channels = 0;
  std::optional<double> time_s;
};

py::array segment(PySegmenter& self, const py::object& frame, double time_s) {
  const ImageView view = view_of_image(frame, "frame");
  if (self.channels != 0) check_same_format(view.image, self.size, self.channels);
  check_time(time_s, self.time_s);
  if (self.channels == 0) self.model->check_first(view.image);
  self.size = view.image.size();
  self.channels = view.image.channels();
  self.time_s = time_s;
  Expectation expectation;
  expectation.time_s = time_s;
  std::vector<Event> events;
  cv::Mat mask;
  self.model->push(view.image);
  self.model->segment(view.image, expectation, mask, events);
  return array_of_image(mask);
}

py::array background(const PySegmenter& self) {
  if (self.channels == 0) throw InputError("background: no frame was segmented yet");
  cv::Mat picture;
  self.model->background(picture);
  if (picture.empty()) throw InputError("background: this model has none");
  return array_of_image(picture);
}

py::typing::Optional<py::array_t<float>> flow(const PySegmenter& self) {
  cv::Mat field;
  self.model->flow(field);
  if (field.empty()) return py::none();
  return array_of_field(field);
}

py::array clean_mask(const py::object& mask, const CleanupOptions& options) {
  return changed_mask(mask, [&](cv::Mat& changed) { Cleanup(options).apply(changed); });
}

PyDetections find_blobs(const py::object& mask, const py::object& frame, const BlobOptions& options, bool contours,
                        double time_s, std::int64_t index) {
  const ImageView view = view_of_image(mask, "mask");
  if (view.image.channels() != 1) throw InputError("mask: has 3 channels; expected HxW uint8");
  const ImageView colors = view_of_image(frame.is_none() ? mask : frame, "frame");
  if (colors.image.size() != view.image.size()) {
    throw InputError("frame: is " + std::to_string(colors.image.rows) + "x" + std::to_string(colors.image.cols) +
                     "; expected the mask's size, " + std::to_string(view.image.rows) + "x" +
                     std::to_string(view.image.cols));
  }
  PyDetections detections;
  detections.value.time_s = time_s;
  detections.value.index = index;
  detections.value.frame_width = view.image.cols;
  detections.value.frame_height = view.image.rows;
  BlobExtractor(options).extract(view.image, colors.image, Expectation{}, contours, detections.value);
  detections.value.mask = view.image.clone();
  return detections;
}

}  // namespace

void bind_segmentation(py::module_& module) {
  py::class_<PySegmenter>(module, "Segmenter", "A background model alone: frame in, raw foreground mask out.")
      .def(py::init<const SegmenterOptions&>(), py::arg("options") = SegmenterOptions{}, "Raises ConfigError.")
      .def("segment", &segment, py::arg("frame"), py::arg("time_s"),
           "One frame on: frame is HxW or HxWx3 (BGR) uint8, time_s increases. Returns the mask before cleanup, HxW\n"
           "uint8, 0 or 255. Raises InputError and then keeps its state.")
      .def(
          "load_background",
          [](PySegmenter& self, const py::object& picture) {
            if (self.channels != 0) {
              throw InputError("background: came after the first frame; expected it before, or after reset()");
            }
            self.model->load_background(view_of_image(picture, "background").image);
          },
          py::arg("picture"),
          "The picture to start from, with segmenter.source picture: HxW or HxWx3 (BGR) uint8 of the frames' size, copied.\n"
          "Before the first frame; it outlives reset(). Raises InputError.")
      .def("relearn", [](PySegmenter& self) { self.model->relearn(); },
           "The scene changed: learns the background anew from the coming frames.")
      .def("background", &background, "The background picture, uint8 of the frame's size.")
      .def("flow", &flow, "The last flow field, HxWx2 float32, px to the right and down; None while there is none.")
      .def("reset", [](PySegmenter& self) {
        self.model->reset();
        self.channels = 0;
        self.time_s.reset();
      }, "Forgets everything: the next frame is a first frame.");
  module.def("clean_mask", &clean_mask, py::arg("mask"), py::arg("options") = CleanupOptions{},
             "A mask (HxW uint8, 0 or 255) with its noise removed: median, opening, closing, tiles. The input is left\n"
             "alone. A temporal median has nothing to do with one mask: see Cleanup.");
  py::class_<Cleanup>(module, "Cleanup", "Noise removal on the masks of a run, one after the other.")
      .def(py::init<const CleanupOptions&>(), py::arg("options") = CleanupOptions{}, "Raises ConfigError.")
      .def("apply",
           [](Cleanup& self, const py::object& mask) {
             return changed_mask(mask, [&](cv::Mat& changed) { self.apply(changed); });
           },
           py::arg("mask"),
           "The next mask (HxW uint8, not 0 is foreground) with its noise removed, 0 or 255; the input is left alone.\n"
           "Raises InputError, for one of another size than those before it with a temporal median or for one too\n"
           "small for its tiles, and then keeps its state.")
      .def("reset", &Cleanup::reset, "Forgets the masks before: the next is a first mask.");
  module.def("find_blobs", &find_blobs, py::arg("mask"), py::arg("frame") = py::none(),
             py::arg("options") = BlobOptions{}, py::kw_only(), py::arg("contours") = false,
             py::arg("time_s") = 0.0, py::arg("index") = 0,
             "The detections of a mask (HxW uint8, not 0 is foreground), with mean colours of `frame` (same size). For\n"
             "Tracker.process they need the frame's time in seconds, and may have its index in its source.");
}

}  // namespace survtrack::bindings
