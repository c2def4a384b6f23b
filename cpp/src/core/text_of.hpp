// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <array>
#include <charconv>
#include <initializer_list>
#include <string>

namespace survtrack {

/// With up to 15 digits, so that 0.1 + 0.2 is 0.3: 0.1, 1e+300, nan.
inline std::string text_of(double number) {
  std::array<char, 32> text{};
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), number, std::chars_format::general, 15).ptr};
}

/// (1, 2.5, nan)
inline std::string text_of(std::initializer_list<double> numbers) {
  std::string text;
  for (const double number : numbers) text += (text.empty() ? "(" : ", ") + text_of(number);
  return text + ")";
}

}  // namespace survtrack
