// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "bindings.hpp"
#include "survtrack/core/errors.hpp"
#include "survtrack/core/version.hpp"

namespace py = pybind11;

PYBIND11_MODULE(_core, module) {
  using namespace survtrack;
  module.doc() = "The C++ core of survtrack.";
  module.attr("__version__") = version();

  // The exception classes live in survtrack.errors, so that Python code raises the same ones.
  py::register_exception_translator([](std::exception_ptr pointer) {
    const auto raise = [](const char* name, const std::exception& error) {
      py::set_error(py::module_::import("survtrack.errors").attr(name), error.what());
    };
    try {
      if (pointer) std::rethrow_exception(pointer);
    } catch (const ConfigError& error) {
      raise("ConfigError", error);
    } catch (const InputError& error) {
      raise("InputError", error);
    }
  });

  bindings::bind_values(module);
  bindings::bind_options(module);
  bindings::bind_config(module);
  bindings::bind_results(module);
  bindings::bind_segmentation(module);
  bindings::bind_scene_change(module);
  bindings::bind_tiling(module);
  bindings::bind_flow(module);
  bindings::bind_filters(module);
  bindings::bind_association(module);
  bindings::bind_beliefs(module);
  bindings::bind_offline(module);
  bindings::bind_patterns(module);
  bindings::bind_paths(module);
  bindings::bind_filtering(module);
  bindings::bind_pipeline(module);
  bindings::bind_regions(module);
  bindings::bind_appearance(module);
  bindings::bind_noise(module);
}
