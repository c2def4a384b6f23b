// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <sstream>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "survtrack/pipeline/config.hpp"

namespace survtrack {

enum class OptionType { boolean, integer, number, numbers, choice };

/// One option of a config, with what must be set before it exists: nothing, "filter.model=kalman_ca", or several of
/// these, one a line.
struct ListedOption {
  std::string model;
  std::string path;
  OptionType type = OptionType::number;
  Bounds bounds;
  std::vector<std::string> choices;
  std::string meaning;
  std::size_t count = 1;  ///< of numbers

  /// A list of them, each the same.
  std::string list_of(const std::string& number, std::size_t length) const {
    std::string text = "[";
    for (std::size_t i = 0; i < length; ++i) text += (i == 0 ? "" : ", ") + number;
    return text + "]";
  }
  std::string list_of(const std::string& number) const { return list_of(number, count); }
};

namespace option_list {

template <class Struct>
void add(const std::string& path, const std::string& model, std::vector<ListedOption>& list);

template <class Variant, std::size_t... I>
void add_models(const std::string& path, const std::string& outer, std::vector<ListedOption>& list,
                std::index_sequence<I...>) {
  (add<std::variant_alternative_t<I, Variant>>(
       path, outer + (outer.empty() ? "" : "\n") + path + ".model=" + std::variant_alternative_t<I, Variant>::model, list),
   ...);
}

template <class Value>
OptionType type_of() {
  if constexpr (std::is_same_v<Value, bool>) return OptionType::boolean;
  if constexpr (std::is_integral_v<Value>) return OptionType::integer;
  if constexpr (std::is_enum_v<Value>) return OptionType::choice;
  if constexpr (is_number_list<Value>::value) return OptionType::numbers;
  return OptionType::number;
}

template <class Struct>
void add(const std::string& path, const std::string& model, std::vector<ListedOption>& list) {
  for_each_field<Struct>([&](const auto& f) {
    using Value = typename std::decay_t<decltype(f)>::value_type;
    const std::string inner = join_path(path, f.name);
    if constexpr (is_variant<Value>::value) {
      add_models<Value>(inner, model, list, std::make_index_sequence<std::variant_size_v<Value>>{});
    } else if constexpr (has_fields<Value>::value) {
      add<Value>(inner, model, list);
    } else {
      ListedOption option{model, inner, type_of<Value>(), f.bounds, {}, f.meaning};
      if constexpr (is_number_list<Value>::value) option.count = std::tuple_size_v<Value>;
      if constexpr (std::is_enum_v<Value>) {
        for (const auto& choice : enum_names(Value{})) option.choices.emplace_back(choice.first);
      }
      list.push_back(option);
    }
  });
}

template <class Variant, std::size_t... I>
std::vector<std::string> models(const std::string& path, std::index_sequence<I...>) {
  return {path + ".model=" + std::variant_alternative_t<I, Variant>::model...};
}

template <class Struct>
void add_all_models(const std::string& path, std::vector<std::string>& all) {
  for_each_field<Struct>([&](const auto& f) {
    using Value = typename std::decay_t<decltype(f)>::value_type;
    const std::string inner = join_path(path, f.name);
    if constexpr (is_variant<Value>::value) {
      const auto some = models<Value>(inner, std::make_index_sequence<std::variant_size_v<Value>>{});
      all.insert(all.end(), some.begin(), some.end());
    } else if constexpr (has_fields<Value>::value) {
      add_all_models<Value>(inner, all);
    }
  });
}

}  // namespace option_list

/// Every option of a config, those of every model among them.
inline std::vector<ListedOption> all_options() {
  std::vector<ListedOption> list;
  option_list::add<Config>("", "", list);
  return list;
}

/// Every choice of a model, as `Config::set` takes it.
inline std::vector<std::string> all_models() {
  std::vector<std::string> all;
  option_list::add_all_models<Config>("", all);
  return all;
}

/// A config in which an option exists.
inline Config config_with(const ListedOption& option) {
  Config config;
  std::istringstream models(option.model);
  for (std::string model; std::getline(models, model);) config.set(model);
  return config;
}

}  // namespace survtrack
