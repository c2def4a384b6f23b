// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "survtrack/core/errors.hpp"

namespace survtrack {

/// The values of a JSON text; `what` says what it should hold. Throws `InputError` naming `source`.
inline nlohmann::ordered_json parse_json(const std::string& text, const std::string& source, const std::string& what) {
  using Json = nlohmann::ordered_json;
  try {
    return Json::parse(text);
  } catch (const Json::parse_error& error) {
    throw InputError(source + ": is not JSON, at byte " + std::to_string(error.byte) + "; expected " + what);
  } catch (const Json::exception&) {
    throw InputError(source + ": holds a number that is too large; expected " + what);
  }
}

/// An entry of a JSON file that knows its path; every error names it.
class JsonReader {
 public:
  using Json = nlohmann::ordered_json;

  JsonReader(const Json& json, std::string path) : json_(&json), path_(std::move(path)) {}

  const std::string& path() const { return path_; }
  bool has(const char* key) const { return json_->is_object() && json_->contains(key) && !json_->at(key).is_null(); }

  JsonReader operator[](const char* key) const {
    if (!has(key)) refuse("has no \"" + std::string(key) + "\"");
    return {json_->at(key), path_ + "." + key};
  }

  std::vector<JsonReader> items() const {
    if (!json_->is_array()) refuse("is not a list");
    std::vector<JsonReader> list;
    for (std::size_t i = 0; i < json_->size(); ++i) list.emplace_back((*json_)[i], path_ + "[" + std::to_string(i) + "]");
    return list;
  }

  std::vector<JsonReader> items(std::size_t count) const {
    std::vector<JsonReader> list = items();
    if (list.size() != count) {
      refuse("has " + std::to_string(list.size()) + " entries; expected " + std::to_string(count));
    }
    return list;
  }

  double number(double low = -1e300, double high = 1e300) const {
    if (!json_->is_number()) refuse("is not a number");
    const double value = json_->get<double>();
    if (!(value >= low && value <= high)) {
      refuse("is " + json_->dump() + "; expected " + Json(low).dump() + " to " + Json(high).dump());
    }
    return value;
  }

  std::int64_t integer(std::int64_t low, std::int64_t high) const {
    if (!json_->is_number_integer()) refuse("is not an integer");
    const double value = number(static_cast<double>(low), static_cast<double>(high));
    return static_cast<std::int64_t>(value);
  }

  std::string text() const {
    if (!json_->is_string()) refuse("is not a text");
    return json_->get<std::string>();
  }

  bool boolean() const {
    if (!json_->is_boolean()) refuse("is not true or false");
    return json_->get<bool>();
  }

  /// Refuses an object with an entry that is none of `keys`: in a file written by hand it is a slip.
  void allow_only(std::initializer_list<std::string_view> keys) const {
    if (!json_->is_object()) refuse("is not an object");
    for (const auto& entry : json_->items()) {
      if (std::find(keys.begin(), keys.end(), entry.key()) != keys.end()) continue;
      std::string list;
      for (const std::string_view key : keys) list += (list.empty() ? "" : ", ") + std::string(key);
      refuse("has an unknown entry " + Json(entry.key()).dump() + "; expected: " + list);
    }
  }

  [[noreturn]] void refuse(const std::string& reason) const { throw InputError(path_ + ": " + reason); }

 private:
  const Json* json_;
  std::string path_;
};

}  // namespace survtrack
