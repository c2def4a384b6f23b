// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace survtrack {

/// Parses TOML into JSON; throws `ConfigError` naming `source`, line and column.
nlohmann::ordered_json json_from_toml(const std::string& text, const std::string& source);

/// Parses the value of `a.b=value` as TOML does; what is no TOML value is taken as a string, so that
/// `filter.model=kalman_cv` needs no quotes.
nlohmann::ordered_json json_from_toml_value(const std::string& text);

}  // namespace survtrack
