// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "survtrack/core/errors.hpp"
#include "survtrack/core/fields.hpp"

/// Option structs to and from JSON by walking their fields(). TOML files pass through JSON too.
namespace survtrack::options_json {

using Json = nlohmann::ordered_json;

template <class T>
std::string quoted_choices(const T& names) {
  std::string text;
  for (const auto& name : names) text += (text.empty() ? "" : ", ") + std::string(name);
  return text;
}

[[noreturn]] inline void refuse(const std::string& path, const Json& value, const std::string& expected) {
  // JSON has no word for nan and inf, and no place for bytes that are no UTF-8.
  const bool not_finite = value.is_number_float() && !std::isfinite(value.get<double>());
  const std::string text = not_finite ? std::to_string(value.get<double>())
                                      : value.dump(-1, ' ', false, Json::error_handler_t::replace);
  throw ConfigError((path.empty() ? "config" : path) + ": " + text + " is not allowed; expected " + expected);
}

template <class Variant, std::size_t... I>
std::vector<std::string> model_names(std::index_sequence<I...>) {
  return {std::variant_alternative_t<I, Variant>::model...};
}
template <class Variant>
std::vector<std::string> model_names() {
  return model_names<Variant>(std::make_index_sequence<std::variant_size_v<Variant>>{});
}

template <class Struct>
Json struct_to_json(const Struct& options);

template <class Value>
Json value_to_json(const Value& value) {
  if constexpr (is_variant<Value>::value) {
    return std::visit(
        [](const auto& alternative) {
          Json object = {{"model", alternative.model}};
          object.update(struct_to_json(alternative));
          return object;
        },
        value);
  } else if constexpr (has_fields<Value>::value) {
    return struct_to_json(value);
  } else if constexpr (std::is_enum_v<Value>) {
    for (const auto& [name, choice] : enum_names(Value{})) {
      if (choice == value) return name;
    }
    return nullptr;
  } else {
    return value;
  }
}

template <class Struct>
Json struct_to_json(const Struct& options) {
  Json object = Json::object();
  for_each_field<Struct>([&](const auto& f) { object[f.name] = value_to_json(options.*(f.member)); });
  return object;
}

/// `may_choose`: the table may also name a model; for the list of choices.
template <class Struct>
void assign_struct(Struct& options, const Json& object, const std::string& path, bool may_choose = false);

template <class Variant, std::size_t I = 0>
bool choose_model(Variant& value, const std::string& model) {
  if constexpr (I < std::variant_size_v<Variant>) {
    using Alternative = std::variant_alternative_t<I, Variant>;
    if (model != Alternative::model) return choose_model<Variant, I + 1>(value, model);
    value = Alternative{};
    return true;
  } else {
    return false;
  }
}

/// Naming a model starts from that model's defaults; without one the current model's options are changed.
template <class Variant>
void assign_variant(Variant& value, Json object, const std::string& path) {
  if (!object.is_object()) refuse(path, object, "a table of options");
  if (const auto model = object.find("model"); model != object.end()) {
    const std::string choices = "one of: " + quoted_choices(model_names<Variant>());
    if (!model->is_string()) refuse(path + ".model", *model, choices);
    const std::string name = model->get<std::string>();
    if (!choose_model(value, name)) throw ConfigError(path + ".model: unknown \"" + name + "\"; " + choices);
    object.erase("model");
  }
  std::visit([&](auto& alternative) { assign_struct(alternative, object, path, true); }, value);
}

template <class Value>
void assign_value(Value& value, const Json& json, const Bounds& bounds, const std::string& path) {
  if constexpr (is_variant<Value>::value) {
    assign_variant(value, json, path);
  } else if constexpr (has_fields<Value>::value) {
    assign_struct(value, json, path);
  } else if constexpr (std::is_enum_v<Value>) {
    std::vector<std::string> names;
    for (const auto& [name, choice] : enum_names(Value{})) {
      if (json.is_string() && json.get<std::string>() == name) {
        value = choice;
        return;
      }
      names.emplace_back(name);
    }
    refuse(path, json, "one of: " + quoted_choices(names));
  } else if constexpr (std::is_same_v<Value, bool>) {
    if (!json.is_boolean()) refuse(path, json, "true or false");
    value = json.get<bool>();
  } else if constexpr (std::is_integral_v<Value>) {
    // Bounds of integers are well inside the type's range, so the check comes before the narrowing.
    if (!json.is_number_integer()) refuse(path, json, "an integer, " + describe(bounds));
    const double number = json.get<double>();
    if (!allows(bounds, number) || number < std::numeric_limits<Value>::min() ||
        number > std::numeric_limits<Value>::max()) {
      refuse_number(path, number, bounds);
    }
    value = json.get<Value>();
  } else if constexpr (is_number_list<Value>::value) {
    if (!json.is_array() || json.size() != value.size()) refuse(path, json, describe(bounds, value.size()));
    for (std::size_t i = 0; i < value.size(); ++i) assign_value(value[i], json[i], bounds, join_path(path, i));
  } else {
    static_assert(std::is_same_v<Value, double>, "options are bool, int, double, lists of these, enum, struct or variant");
    if (!json.is_number()) refuse(path, json, "a number, " + describe(bounds));
    const double number = json.get<double>();
    if (!std::isfinite(number) || !allows(bounds, number)) refuse_number(path, number, bounds);
    value = number;
  }
}

template <class Struct>
void assign_struct(Struct& options, const Json& object, const std::string& path, bool may_choose) {
  if (!object.is_object()) refuse(path, object, "a table of options");
  for (const auto& [key, json] : object.items()) {
    bool known = false;
    std::vector<std::string> names;
    if (may_choose) names.emplace_back("model");
    for_each_field<Struct>([&](const auto& f) {
      names.emplace_back(f.name);
      if (key != f.name) return;
      known = true;
      assign_value(options.*(f.member), json, f.bounds, join_path(path, f.name));
    });
    if (!known) {
      throw ConfigError(join_path(path, key.c_str()) + ": unknown option; " +
                        (names.empty() ? "there are none here" : "one of: " + quoted_choices(names)));
    }
  }
}

}  // namespace survtrack::options_json
