// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <stdexcept>
#include <string>

namespace survtrack {

/// An option, preset or option file that cannot be used; the message names its full path, the value
/// and what is allowed. Python: `survtrack.ConfigError`.
class ConfigError : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

/// An image, array or time that cannot be processed; the message names it and what is allowed.
/// Python: `survtrack.InputError`.
class InputError : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

}  // namespace survtrack
