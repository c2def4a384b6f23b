// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <tuple>
#include <type_traits>
#include <variant>

#include "survtrack/core/errors.hpp"

namespace survtrack {

/// What a number may be. The default allows every finite number.
struct Bounds {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool above_low = false;  ///< low itself is refused
  bool odd_or_zero = false;
};

constexpr Bounds between(double low, double high) { return {low, high}; }
constexpr Bounds above_up_to(double low, double high) { return {low, high, true}; }
constexpr Bounds odd_up_to(double high) { return {0.0, high, false, true}; }

/// "between 0 and 1", "at least 0, odd", ... for messages and the reference page.
std::string describe(const Bounds& bounds);
bool allows(const Bounds& bounds, double value);
/// The same of a list of so many numbers: "4 numbers, each at least 0".
std::string describe(const Bounds& bounds, std::size_t count);

/// One option of an option struct: the only place where its name, unit, meaning and range stand.
/// Every option struct has a `static constexpr auto fields()` that returns a tuple of these.
template <class Struct, class Value>
struct Field {
  using value_type = Value;
  const char* name;
  Value Struct::*member;
  const char* unit;  ///< "" for plain numbers
  const char* meaning;
  Bounds bounds{};
};

template <class Struct, class Value>
constexpr Field<Struct, Value> field(const char* name, Value Struct::*member, const char* unit,
                                     const char* meaning, Bounds bounds = {}) {
  return {name, member, unit, meaning, bounds};
}

template <class T, class = void>
struct has_fields : std::false_type {};
template <class T>
struct has_fields<T, std::void_t<decltype(T::fields())>> : std::true_type {};

template <class T>
struct is_variant : std::false_type {};
template <class... T>
struct is_variant<std::variant<T...>> : std::true_type {};

/// A list of so many numbers.
template <class T>
struct is_number_list : std::false_type {};
template <std::size_t N>
struct is_number_list<std::array<double, N>> : std::true_type {};

/// Calls `visit(field)` for each field of `Struct`, in order.
template <class Struct, class Visit>
void for_each_field(Visit&& visit) {
  std::apply([&](const auto&... f) { (visit(f), ...); }, Struct::fields());
}

inline std::string join_path(const std::string& path, const char* name) {
  return path.empty() ? name : path + "." + name;
}

inline std::string join_path(const std::string& path, std::size_t entry) {
  return path + "[" + std::to_string(entry) + "]";
}

[[noreturn]] void refuse_number(const std::string& path, double value, const Bounds& bounds);

/// Checks every number of an option struct, and of those inside it, against its bounds. Throws `ConfigError`
/// with the full path.
template <class Struct>
void check_fields(const Struct& options, const std::string& path = {});

template <class Value>
void check_value(const Value& value, const Bounds& bounds, const std::string& path) {
  if constexpr (is_variant<Value>::value) {
    std::visit([&](const auto& alternative) { check_fields(alternative, path); }, value);
  } else if constexpr (has_fields<Value>::value) {
    check_fields(value, path);
  } else if constexpr (is_number_list<Value>::value) {
    for (std::size_t i = 0; i < value.size(); ++i) check_value(value[i], bounds, join_path(path, i));
  } else if constexpr (std::is_arithmetic_v<Value> && !std::is_same_v<Value, bool>) {
    const auto number = static_cast<double>(value);
    if (!std::isfinite(number) || !allows(bounds, number)) refuse_number(path, number, bounds);
  }
}

template <class Struct>
void check_fields(const Struct& options, const std::string& path) {
  for_each_field<Struct>([&](const auto& f) { check_value(options.*(f.member), f.bounds, join_path(path, f.name)); });
}

}  // namespace survtrack
