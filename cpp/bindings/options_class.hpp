// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <sstream>
#include <string>
#include <tuple>

#include "bindings.hpp"
#include "core/options_json.hpp"

/// Python classes of option structs, made from their fields(): keyword constructor, read-only properties with
/// docstrings, replace(), to_dict(), comparison. Options are values: a part of a config is a copy.
namespace survtrack::bindings {

using options_json::Json;

Json json_of(const py::handle& value);
py::object object_of(const Json& json);
[[noreturn]] void refuse_assignment(const std::string& option);

template <class Struct, class = void>
struct has_model : std::false_type {};
template <class Struct>
struct has_model<Struct, std::void_t<decltype(Struct::model)>> : std::true_type {};

template <class Value>
py::object python_value(const Value& value) {
  if constexpr (is_variant<Value>::value) {
    return std::visit([](const auto& alternative) { return py::cast(alternative); }, value);
  } else if constexpr (has_fields<Value>::value) {
    return py::cast(value);
  } else {
    return object_of(options_json::value_to_json(value));
  }
}

template <class Struct>
std::string class_name() {
  return py::str(py::type::of<Struct>().attr("__name__"));
}

template <class Variant, std::size_t... I>
std::string class_names(std::index_sequence<I...>) {
  std::string text;
  ((text += (I == 0 ? "" : " | ") + class_name<std::variant_alternative_t<I, Variant>>()), ...);
  return text;
}

/// The type that a property has in Python; classes of nested options are bound before their owners.
template <class Value>
std::string python_type() {
  if constexpr (is_variant<Value>::value) {
    return class_names<Value>(std::make_index_sequence<std::variant_size_v<Value>>{});
  } else if constexpr (has_fields<Value>::value) {
    return class_name<Value>();
  } else if constexpr (std::is_same_v<Value, bool>) {
    return "bool";
  } else if constexpr (std::is_integral_v<Value>) {
    return "int";
  } else if constexpr (std::is_floating_point_v<Value>) {
    return "float";
  } else if constexpr (is_number_list<Value>::value) {
    std::string text = "tuple[float";
    for (std::size_t i = 1; i < std::tuple_size_v<Value>; ++i) text += ", float";
    return text + "]";
  } else {
    return "str";
  }
}

/// The type that it is given as: a list of numbers may be any sequence.
template <class Value>
std::string keyword_type() {
  return is_number_list<Value>::value ? "collections.abc.Sequence[float]" : python_type<Value>();
}

/// "name: meaning [unit], allowed" for each field, as the Args section of a docstring.
template <class Struct>
std::string arguments_doc() {
  std::ostringstream out;
  for_each_field<Struct>([&](const auto& f) {
    using Value = typename std::decay_t<decltype(f)>::value_type;
    out << "    " << f.name << ": " << f.meaning;
    if (*f.unit != '\0') out << " [" << f.unit << "]";
    if constexpr (std::is_enum_v<Value>) {
      out << "; one of";
      for (const auto& entry : enum_names(Value{})) out << " \"" << entry.first << "\"";
    } else if constexpr (std::is_arithmetic_v<Value> && !std::is_same_v<Value, bool>) {
      out << "; " << describe(f.bounds);
    } else if constexpr (is_number_list<Value>::value) {
      out << "; " << describe(f.bounds, std::tuple_size_v<Value>);
    }
    out << "\n";
  });
  return out.str();
}

/// "(self, *, name: type = default, ...)" for signatures and stubs.
template <class Struct>
std::string keyword_signature() {
  std::ostringstream out;
  const Struct defaults;
  bool first = true;
  for_each_field<Struct>([&](const auto& f) {
    using Value = typename std::decay_t<decltype(f)>::value_type;
    out << (first ? "*, " : ", ") << f.name << ": " << keyword_type<Value>() << " = ";
    first = false;
    if constexpr (is_variant<Value>::value || has_fields<Value>::value) {
      out << "...";
    } else {
      out << std::string(py::repr(python_value(defaults.*(f.member))));
    }
  });
  return out.str();
}

template <class Struct>
Struct struct_from_keywords(Struct options, const py::kwargs& keywords, const std::string& path) {
  options_json::assign_struct(options, json_of(keywords), path);
  check_fields(options, path);
  return options;
}

template <class Struct>
py::class_<Struct> bind_option_struct(py::module_& module, const char* name, const std::string& doc) {
  py::options no_signatures;
  no_signatures.disable_function_signatures();
  py::class_<Struct> cls(module, name, (doc + ".\n\nArgs:\n" + arguments_doc<Struct>()).c_str());
  const std::string keywords = keyword_signature<Struct>();
  const std::string more = keywords.empty() ? "" : ", " + keywords;
  const std::string path = name;
  cls.def(py::init([path](const py::kwargs& k) { return struct_from_keywords(Struct{}, k, path); }),
          ("__init__(self" + more + ") -> None\n\nRaises ConfigError naming the option and what is allowed.").c_str());
  cls.def(
      "replace", [path](const Struct& self, const py::kwargs& k) { return struct_from_keywords(self, k, path); },
      ("replace(self, **options: object) -> " + path + "\n\nA copy with some options changed.").c_str());
  cls.def(
      "to_dict",
      [](const Struct& self) {
        Json object = Json::object();
        if constexpr (has_model<Struct>::value) object["model"] = Struct::model;
        object.update(options_json::struct_to_json(self));
        return object_of(object);
      },
      "to_dict(self) -> dict[str, object]\n\nAll options by name, and the model's name if it is one of several.");
  cls.def(
      "__repr__",
      [path](const Struct& self) {
        std::string text;
        for_each_field<Struct>([&](const auto& f) {
          text += (text.empty() ? "" : ", ") + std::string(f.name) + "=" +
                  std::string(py::repr(python_value(self.*(f.member))));
        });
        return path + "(" + text + ")";
      },
      "__repr__(self) -> str");
  cls.def(
      "__eq__",
      [](const Struct& self, const py::object& other) {
        return py::isinstance<Struct>(other) &&
               options_json::struct_to_json(self) == options_json::struct_to_json(other.cast<const Struct&>());
      },
      "__eq__(self, other: object) -> bool");
  cls.attr("__hash__") = py::none();
  // From here on pybind11's own signatures are right.
  no_signatures.enable_function_signatures();
  cls.def("__copy__", [](const Struct& self) { return self; });
  cls.def("__deepcopy__", [](const Struct& self, const py::typing::Dict<py::object, py::object>&) { return self; },
          py::arg("memo"));
  cls.def(py::pickle([](const Struct& self) { return py::str(options_json::struct_to_json(self).dump()); },
                     [path](const py::str& text) {
                       Struct options;
                       options_json::assign_struct(options, Json::parse(std::string(text)), path);
                       return options;
                     }));
  return cls;
}

template <class Struct>
std::string property_doc(const char* name) {
  std::string doc;
  for_each_field<Struct>([&](const auto& f) {
    if (std::string(name) != f.name) return;
    doc = f.meaning;
    if (*f.unit != '\0') doc += std::string(" [") + f.unit + "]";
  });
  return doc;
}

/// The signatures of a property's functions, where the stubs find its type.
struct PropertyType {
  std::string getter;
  std::string setter;
};

template <class Struct>
PropertyType property_type(const char* name) {
  PropertyType type;
  for_each_field<Struct>([&](const auto& f) {
    if (std::string(name) != f.name) return;
    const std::string value = python_type<typename std::decay_t<decltype(f)>::value_type>();
    type = {"(self) -> " + value, "(self, value: " + value + ") -> None"};
  });
  return type;
}

/// An option struct whose properties are read-only.
template <class Struct>
void bind_frozen_options(py::module_& module, const char* name, const std::string& doc) {
  py::class_<Struct> cls = bind_option_struct<Struct>(module, name, doc);
  for_each_field<Struct>([&](const auto& f) {
    py::options no_signatures;
    no_signatures.disable_function_signatures();
    const auto member = f.member;
    const std::string option = f.name;
    const PropertyType type = property_type<Struct>(f.name);
    cls.def_property(
        f.name, py::cpp_function([member](const Struct& self) { return python_value(self.*member); }, type.getter.c_str()),
        py::cpp_function([option](Struct&, const py::object&) { refuse_assignment(option); },
                         "(self, value: typing.Never) -> None"),
        property_doc<Struct>(f.name).c_str());
  });
}

/// The same outside of a config, where no path says how else to change an option.
template <class Struct>
void bind_plain_options(py::module_& module, const char* name, const std::string& doc) {
  py::class_<Struct> cls = bind_option_struct<Struct>(module, name, doc);
  for_each_field<Struct>([&](const auto& f) {
    py::options no_signatures;
    no_signatures.disable_function_signatures();
    const auto member = f.member;
    cls.def_property_readonly(f.name,
                              py::cpp_function([member](const Struct& self) { return python_value(self.*member); },
                                               property_type<Struct>(f.name).getter.c_str()),
                              property_doc<Struct>(f.name).c_str());
  });
}

/// One alternative of a variant.
template <class Struct>
void bind_model_options(py::module_& module, const char* name) {
  bind_frozen_options<Struct>(module, name, Struct::meaning);
  module.attr(name).attr("model") = Struct::model;
}

}  // namespace survtrack::bindings
