// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "options_class.hpp"

#include <optional>
#include <string_view>

#include "survtrack/core/errors.hpp"
#include "survtrack/pipeline/config.hpp"

namespace survtrack::bindings {
namespace {

constexpr Py_ssize_t longest_list = 1000;  // no option takes one as long; a range may have any length

/// The entries of a list, tuple, array of one dimension or other sequence; nothing for what is none. What is no number
/// among them, another list too, becomes its text, which no option takes.
std::optional<Json> list_of_sequence(const py::handle& value) {
  if (PySequence_Check(value.ptr()) == 0 || py::isinstance<py::bytes>(value)) return std::nullopt;
  const Py_ssize_t size = PySequence_Size(value.ptr());
  if (size < 0 || size > longest_list) {  // numpy's arrays without dimensions have no size
    PyErr_Clear();
    return std::nullopt;
  }
  Json list = Json::array();
  for (Py_ssize_t i = 0; i < size; ++i) {
    const auto entry = py::reinterpret_steal<py::object>(PySequence_GetItem(value.ptr(), i));
    if (!entry) throw py::error_already_set();
    const bool is_list = PySequence_Check(entry.ptr()) != 0 && !py::isinstance<py::str>(entry);
    list.push_back(is_list ? Json(std::string(py::repr(entry))) : json_of(entry));
  }
  return list;
}

}  // namespace

Json json_of(const py::handle& value) {
  if (value.is_none()) return nullptr;
  if (py::isinstance<py::bool_>(value)) return value.cast<bool>();
  if (py::isinstance<py::str>(value)) return value.cast<std::string>();
  if (std::string_view(Py_TYPE(value.ptr())->tp_name) == "numpy.bool") return value.cast<bool>();
  if (py::hasattr(value, "to_dict")) return json_of(value.attr("to_dict")());
  if (py::isinstance<py::dict>(value)) {
    Json object = Json::object();
    for (const auto& [key, item] : py::reinterpret_borrow<py::dict>(value)) {
      object[std::string(py::str(key))] = json_of(item);
    }
    return object;
  }
  if (const auto list = list_of_sequence(value)) return *list;
  // numpy's numbers pass too: they have __index__ or __float__. Its arrays have both, and may refuse.
  if (const auto number = py::reinterpret_steal<py::object>(PyNumber_Index(value.ptr()))) {
    int overflow = 0;
    const long long integer = PyLong_AsLongLongAndOverflow(number.ptr(), &overflow);
    if (overflow == 0) return integer;
  }
  PyErr_Clear();
  if (py::hasattr(value, "__float__")) {
    const double number = PyFloat_AsDouble(value.ptr());
    if (PyErr_Occurred() == nullptr) return number;
    PyErr_Clear();
  }
  return std::string(py::repr(value));
}

py::object object_of(const Json& json) {
  if (json.is_boolean()) return py::bool_(json.get<bool>());
  if (json.is_number_integer()) return py::int_(json.get<long long>());
  if (json.is_number()) return py::float_(json.get<double>());
  if (json.is_string()) return py::str(json.get<std::string>());
  if (json.is_object()) {
    py::dict dict;
    for (const auto& [key, item] : json.items()) dict[py::str(key)] = object_of(item);
    return dict;
  }
  if (json.is_array()) {
    py::tuple tuple(json.size());
    for (std::size_t i = 0; i < json.size(); ++i) tuple[i] = object_of(json[i]);
    return tuple;
  }
  return py::none();
}

void refuse_assignment(const std::string& option) {
  const std::string text = option + ": options are values and part of a config is a copy; use config.set(\"<section>." +
                           option + "=<value>\"), or assign config.<section> = config.<section>.replace(" + option +
                           "=<value>)";
  throw py::attribute_error(text);
}

void bind_config(py::module_& module) {
  py::class_<Config> cls = bind_option_struct<Config>(
      module, "Config", "All options of a pipeline; the defaults are the preset \"survtrack\"");
  for_each_field<Config>([&](const auto& f) {
    py::options no_signatures;
    no_signatures.disable_function_signatures();
    const auto member = f.member;
    const std::string option = f.name;
    const PropertyType type = property_type<Config>(f.name);
    cls.def_property(
        f.name, py::cpp_function([member](const Config& self) { return python_value(self.*member); }, type.getter.c_str()),
        py::cpp_function([option](Config& self, const py::object& value) {
          Json object = Json::object();
          object[option] = json_of(value);
          Config changed = self;
          options_json::assign_struct(changed, object, "");
          check_fields(changed);
          self = changed;
        }, type.setter.c_str()),
        property_doc<Config>(f.name).c_str());
  });
  cls.def_static("from_toml", &Config::from_toml, py::arg("text"), py::arg("source") = "config",
                 "Reads options from TOML on top of the defaults; `source` names the text in errors.");
  cls.def_static("from_json", &Config::from_json, py::arg("text"), py::arg("source") = "config",
                 "Reads options from JSON on top of the defaults; `source` names the text in errors.");
  cls.def("update_from_toml", &Config::update_from_toml, py::arg("text"), py::arg("source") = "config",
          "Reads options from TOML on top of the present ones; an error leaves the config as it was.");
  cls.def("update_from_json", &Config::update_from_json, py::arg("text"), py::arg("source") = "config",
          "Reads options from JSON on top of the present ones; an error leaves the config as it was.");
  cls.def("set", &Config::set, py::arg("option_and_value"),
          "Sets one option, as in set(\"filter.model=kalman_ca\"). Choosing a model resets its options.");
  cls.def("to_toml", &Config::to_toml, "All options as a TOML file, each with its unit and meaning.");
  cls.def("to_json", &Config::to_json, "All options as JSON.");
  cls.def("check", [](const Config& self) { self.check(); }, "Raises ConfigError unless all bounds and the rules between sections hold.");

  module.def("preset_names", &preset_names, "Names of the presets, the default one first.");
  module.def("preset_text", &preset_text, py::arg("name"),
             "A preset's TOML file: what differs from the defaults, with the reasons.");
  module.def("preset", &preset, py::arg("name") = "survtrack", "The config of a preset.");
  module.def("options_reference", &options_reference, "The reference of all options in Markdown.");
}

}  // namespace survtrack::bindings
