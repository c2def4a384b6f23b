// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "bindings.hpp"
#include "survtrack/core/errors.hpp"

namespace survtrack::bindings {

/// A copy of a mask from Python with `work` done on it.
template <class Work>
py::array changed_mask(const py::object& mask, const Work& work) {
  const ImageView view = view_of_image(mask, "mask");
  if (view.image.channels() != 1) throw InputError("mask: has 3 channels; expected HxW uint8");
  cv::Mat changed = view.image.clone();
  work(changed);
  return array_of_image(changed);
}

}  // namespace survtrack::bindings
