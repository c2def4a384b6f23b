// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include <memory>
#include <mutex>

#include "results.hpp"
#include "survtrack/pipeline/pipeline.hpp"

namespace survtrack::bindings {
namespace {

/// A stage with the lock that makes calls from several Python threads take turns: the GIL is released while
/// the core works.
template <class Stage>
struct Guarded {
  explicit Guarded(const Config& options) : stage(options), config(options) {}

  template <class Work>
  auto run(Work&& work) {
    const py::gil_scoped_release release;
    const std::lock_guard<std::mutex> lock(mutex);
    return work(stage);
  }

  Stage stage;
  Config config;
  std::mutex mutex;
};

using PyPipeline = Guarded<Pipeline>;
using PyDetector = Guarded<Detector>;

struct PyTracker : Guarded<Tracker> {
  using Guarded::Guarded;
  std::int64_t next_index = 0;
};

py::object process_frame(PyPipeline& self, const py::object& frame, double time_s, std::optional<std::int64_t> index) {
  const ImageView view = view_of_image(frame, "frame");
  PyFrameResult result;
  const bool due = self.run([&](Pipeline& p) { return p.process(view.image, time_s, result.value, index); });
  if (!due) return py::none();
  // Without delay the result's image shares the array's pixels, or a copy's: give the array itself.
  result.frame = self.stage.delay_frames() == 0 ? frame : py::object(array_of_image(result.value.frame));
  result.value.frame = cv::Mat();
  return py::cast(std::move(result));
}

std::vector<PyFrameResult> finish_pipeline(PyPipeline& self) {
  std::vector<PyFrameResult> rest;
  for (FrameResult& result : self.run([](Pipeline& p) { return p.finish(); })) {
    const py::array frame = array_of_image(result.frame);
    result.frame = cv::Mat();
    rest.push_back({std::move(result), frame});
  }
  return rest;
}

void bind_whole(py::module_& module) {
  py::class_<PyPipeline>(module, "Pipeline", "The whole system: frame in, tracks and events out. One object a camera.")
      .def(py::init<const Config&>(), py::arg("config") = Config{}, "Raises ConfigError.")
      .def_static("from_preset", [](const std::string& name) { return std::make_unique<PyPipeline>(preset(name)); },
                  py::arg("name") = "survtrack", "A pipeline with a preset's config.")
      .def_property_readonly("config", [](const PyPipeline& self) { return self.config; }, "A copy of the config.")
      .def_property_readonly("delay_frames", [](const PyPipeline& self) { return self.stage.delay_frames(); },
                             "Frames by which results come late.")
      .def("process", &process_frame, py::arg("frame"), py::arg("time_s"), py::arg("index") = py::none(),
           "One frame on. frame: HxW (grey) or HxWx3 (BGR) uint8, one size for the whole run; time_s: increasing, in\n"
           "seconds; index: the frame's index in its source, increasing, counts on from the last by default.\n"
           "None while a delayed pipeline fills. Raises InputError and then keeps its state.")
      .def("finish", &finish_pipeline, "The source has ended: the results still due. After it only reset() is allowed.")
      .def("reset", [](PyPipeline& self) { self.run([](Pipeline& p) { p.reset(); }); },
           "Forgets frames, tracks and all that was learned, but no picture that was loaded nor zones; the next frame is a\n"
           "first frame and ids start at 1.")
      .def(
          "load_zones",
          [](PyPipeline& self, const std::vector<Box>& zones) { self.run([&](Pipeline& s) { s.load_zones(zones); }); },
          py::arg("zones"),
          "Where newcomers are looked for, boxes in px, with regions.acquisition zones; before the first frame. Kept by\n"
          "reset(). Raises InputError for none, for zones without size, and when the config has no use for them.")
      .def(
          "load_background",
          [](PyPipeline& self, const py::object& picture) {
            const ImageView view = view_of_image(picture, "background");
            self.run([&](Pipeline& p) { p.load_background(view.image); });
          },
          py::arg("picture"),
          "The picture to start from, with segmenter.model static_reference and source picture: HxW or HxWx3 (BGR) uint8 of\n"
          "the frames' size, copied. Before the first frame; it outlives reset(). Raises InputError.")
      .def("relearn_background", [](PyPipeline& self) { self.run([](Pipeline& p) { p.relearn_background(); }); },
           "The scene changed: the background is learned anew from the coming frames.")
      .def("learned_scene", [](PyPipeline& self) { return self.run([](Pipeline& s) { return s.learned_scene(); }); },
           "What was learned of the scene, as JSON: the law of sizes, the vicinity grids, the densities of beliefs.")
      .def(
          "load_learned_scene",
          [](PyPipeline& self, const std::string& json, const std::string& source) {
            self.run([&](Pipeline& s) { s.load_learned_scene(json, source); });
          },
          py::arg("json"), py::arg("source") = "scene",
          "Starts from what an earlier run learned; what this config does not use is left aside. Raises InputError,\n"
          "naming source and the entry, and then keeps its state.")
      .def("load_paths", [](PyPipeline& self, const Paths& paths) { self.run([&](Pipeline& s) { s.load_paths(paths); }); },
           py::arg("paths"),
           "The paths that filter.model kalman_path follows objects along; other filters leave them aside. reset() keeps\n"
           "them. Raises InputError when there are none, they are drawn on frames of another size, or frames were processed\n"
           "already.");
}

void bind_detector(py::module_& module) {
  py::class_<PyDetector>(module, "Detector", "The first half: frame in, detections out.")
      .def(py::init<const Config&>(), py::arg("config") = Config{}, "Raises ConfigError.")
      .def_property_readonly("delay_frames", [](const PyDetector& self) { return self.stage.delay_frames(); },
                             "Frames by which detections come late.")
      .def(
          "process",
          [](PyDetector& self, const py::object& frame, double time_s, std::optional<std::int64_t> index,
             const std::vector<Box>& keep, const std::vector<Box>& regions) -> py::object {
            const ImageView view = view_of_image(frame, "frame");
            auto detections = self.run([&](Detector& d) { return d.process(view.image, time_s, index, keep, regions); });
            return detections ? py::cast(PyDetections{std::move(*detections)}) : py::none();
          },
          py::arg("frame"), py::arg("time_s"), py::arg("index") = py::none(), py::kw_only(),
          py::arg("keep") = std::vector<Box>{}, py::arg("regions") = std::vector<Box>{},
          "Frame in, detections out; None while a delayed model fills. Arguments as for Pipeline.process; keep: places\n"
          "that the background must not learn; regions: where to look, for models that can read parts; none: everywhere.")
      .def(
          "finish",
          [](PyDetector& self) {
            std::vector<PyDetections> rest;
            for (Detections& d : self.run([](Detector& stage) { return stage.finish(); })) rest.push_back({std::move(d)});
            return rest;
          },
          "The rest of a delayed model. After it only reset() is allowed.")
      .def(
          "load_background",
          [](PyDetector& self, const py::object& picture) {
            const ImageView view = view_of_image(picture, "background");
            self.run([&](Detector& d) { d.load_background(view.image); });
          },
          py::arg("picture"),
          "The picture to start from, with segmenter.model static_reference and source picture: HxW or HxWx3 (BGR) uint8 of\n"
          "the frames' size, copied. Before the first frame; it outlives reset(). Raises InputError.")
      .def("relearn_background", [](PyDetector& self) { self.run([](Detector& d) { d.relearn_background(); }); },
           "The scene changed: the background is learned anew from the coming frames.")
      .def("reset", [](PyDetector& self) { self.run([](Detector& d) { d.reset(); }); },
           "Forgets everything but a picture that was loaded.");
}

void bind_tracker(py::module_& module) {
  py::class_<PyTracker>(module, "Tracker", "The second half: detections in, tracks out; for any detector's boxes.")
      .def(py::init<const Config&>(), py::arg("config") = Config{}, "Raises ConfigError.")
      .def(
          "process",
          [](PyTracker& self, const PyDetections& detections) {
            TrackingResult result = self.run([&](Tracker& t) { return t.process(detections.value); });
            self.next_index = detections.value.index + 1;
            return result;
          },
          py::arg("detections"), "One frame on: predicts to detections.time_s, associates, updates.")
      .def(
          "process",
          [](PyTracker& self, const py::object& boxes, double time_s) {
            const Detections detections =
                detections_of_boxes(boxes, time_s, self.next_index, py::none(), py::none(), {0, 0});
            TrackingResult result = self.run([&](Tracker& t) { return t.process(detections); });
            ++self.next_index;
            return result;
          },
          py::arg("boxes"), py::arg("time_s"), "The same with an Nx4 array: left, top, width, height in px.")
      .def(
          "predict",
          [](PyTracker& self, double time_s, std::pair<int, int> frame_size) {
            return self.run([&](Tracker& t) { return t.predict(time_s, frame_size.first, frame_size.second); });
          },
          py::arg("time_s"), py::kw_only(), py::arg("frame_size") = std::pair<int, int>{0, 0},
          "Moves all tracks on to the coming frame's time and says what is expected there. frame_size: (width, height) in\n"
          "px, needed for regions only; (0, 0): that of the frames before.")
      .def(
          "update",
          [](PyTracker& self, const PyDetections& detections) {
            TrackingResult result;
            self.run([&](Tracker& t) { t.update(detections.value, result); });
            return result;
          },
          py::arg("detections"), "The second step of process, after predict for the same time.")
      .def("reset", [](PyTracker& self) { self.run([](Tracker& t) { t.reset(); }); self.next_index = 0; },
           "Forgets all tracks and all that was learned; ids start at 1 again.")
      .def(
          "load_zones",
          [](PyTracker& self, const std::vector<Box>& zones) { self.run([&](Tracker& s) { s.load_zones(zones); }); },
          py::arg("zones"),
          "Where newcomers are looked for, boxes in px, with regions.acquisition zones; before the first frame. Kept by\n"
          "reset(). Raises InputError for none, for zones without size, and when the config has no use for them.")
      .def("learned_scene", [](PyTracker& self) { return self.run([](Tracker& s) { return s.learned_scene(); }); },
           "What was learned of the scene, as JSON: the law of sizes, the vicinity grids, the densities of beliefs.")
      .def(
          "load_learned_scene",
          [](PyTracker& self, const std::string& json, const std::string& source) {
            self.run([&](Tracker& s) { s.load_learned_scene(json, source); });
          },
          py::arg("json"), py::arg("source") = "scene",
          "Starts from what an earlier run learned; what this config does not use is left aside. Raises InputError,\n"
          "naming source and the entry, and then keeps its state.")
      .def("load_paths", [](PyTracker& self, const Paths& paths) { self.run([&](Tracker& s) { s.load_paths(paths); }); },
           py::arg("paths"),
           "The paths that filter.model kalman_path follows objects along; other filters leave them aside. reset() keeps\n"
           "them. Raises InputError when there are none, they are drawn on frames of another size, or frames were processed\n"
           "already.");
}

}  // namespace

void bind_pipeline(py::module_& module) {
  bind_whole(module);
  bind_detector(module);
  bind_tracker(module);
}

}  // namespace survtrack::bindings
