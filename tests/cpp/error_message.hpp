// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <gtest/gtest.h>

#include <string>
#include <utility>

namespace survtrack {

/// The message of the `Error` that `work` throws; a test in which nothing is thrown fails.
template <class Error, class Work>
std::string message_of(Work&& work) {
  try {
    std::forward<Work>(work)();
  } catch (const Error& error) {
    return error.what();
  }
  ADD_FAILURE() << "nothing was thrown";
  return {};
}

/// Whether each of `parts` stands in `text`.
template <class... Parts>
testing::AssertionResult contains(const std::string& text, const Parts&... parts) {
  std::string missing;
  const auto look_for = [&](const std::string& part) {
    if (text.find(part) == std::string::npos) missing += "\n  \"" + part + "\"";
  };
  (look_for(parts), ...);
  if (missing.empty()) return testing::AssertionSuccess();
  return testing::AssertionFailure() << "\"" << text << "\" lacks" << missing;
}

}  // namespace survtrack
