// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "survtrack/core/fields.hpp"

#include <sstream>

namespace survtrack {

std::string describe(const Bounds& bounds) {
  std::ostringstream text;
  text.precision(15);
  const bool has_low = std::isfinite(bounds.low);
  const bool has_high = std::isfinite(bounds.high);
  if (has_low && has_high && !bounds.above_low) {
    text << "between " << bounds.low << " and " << bounds.high;
  } else if (has_low) {
    text << (bounds.above_low ? "above " : "at least ") << bounds.low;
    if (has_high) text << " and at most " << bounds.high;
  } else if (has_high) {
    text << "at most " << bounds.high;
  } else {
    text << "a finite number";
  }
  if (bounds.odd_or_zero) text << ", 0 or odd";
  return text.str();
}

std::string describe(const Bounds& bounds, std::size_t count) {
  return std::to_string(count) + " numbers, each " + describe(bounds);
}

bool allows(const Bounds& bounds, double value) {
  if (value < bounds.low || value > bounds.high || (bounds.above_low && value == bounds.low)) return false;
  return !bounds.odd_or_zero || value == 0.0 || std::fmod(value, 2.0) == 1.0;
}

void refuse_number(const std::string& path, double value, const Bounds& bounds) {
  std::ostringstream text;
  text.precision(15);
  text << path << ": " << value << " is not allowed; expected " << describe(bounds);
  throw ConfigError(text.str());
}

}  // namespace survtrack
