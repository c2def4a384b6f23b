// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "core/toml.hpp"

#include <toml++/toml.h>

#include <sstream>

#include "survtrack/core/errors.hpp"

namespace survtrack {
namespace {

using Json = nlohmann::ordered_json;

Json to_json(const toml::node& node) {
  if (const auto* table = node.as_table()) {
    Json object = Json::object();
    for (const auto& [key, value] : *table) object[std::string(key.str())] = to_json(value);
    return object;
  }
  if (const auto* array = node.as_array()) {
    Json list = Json::array();
    for (const toml::node& value : *array) list.push_back(to_json(value));
    return list;
  }
  if (const auto* value = node.as_boolean()) return value->get();
  if (const auto* value = node.as_integer()) return value->get();
  if (const auto* value = node.as_floating_point()) return value->get();
  if (const auto* value = node.as_string()) return value->get();
  std::ostringstream text;  // dates and times: no option takes one, the walk over the fields refuses it
  text << toml::node_view<const toml::node>(node);
  return text.str();
}

}  // namespace

Json json_from_toml(const std::string& text, const std::string& source) {
  try {
    return to_json(toml::parse(text, source));
  } catch (const toml::parse_error& error) {
    std::ostringstream message;
    message << source << ":" << error.source().begin.line << ":" << error.source().begin.column << ": "
            << error.description();
    throw ConfigError(message.str());
  }
}

Json json_from_toml_value(const std::string& text) {
  try {
    const toml::table table = toml::parse("value = " + text);
    if (table.size() == 1) return to_json(*table.get("value"));
  } catch (const toml::parse_error&) {
    // Not a TOML value: a bare word.
  }
  return text;
}

}  // namespace survtrack
