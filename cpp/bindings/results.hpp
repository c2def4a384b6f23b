// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <mutex>

#include "bindings.hpp"
#include "survtrack/pipeline/frame_result.hpp"

namespace survtrack::bindings {

/// A detector's result in Python: images as arrays made once, the rest as it is.
struct PyDetections {
  Detections value;
};

/// A frame's result in Python. The frame is the caller's own array when the pipeline has no delay.
struct PyFrameResult {
  FrameResult value;
  py::object frame;
};

/// One structured array of all tracks or detections, a row each.
py::array track_array(const std::vector<Track>& tracks);
py::array detection_array(const std::vector<Detection>& detections);

/// An Nx4 array (left, top, width, height in px) and optional columns as detections.
Detections detections_of_boxes(const py::object& boxes, double time_s, std::int64_t index,
                               const py::object& confidences, const py::object& class_ids,
                               std::pair<int, int> frame_size);

}  // namespace survtrack::bindings
