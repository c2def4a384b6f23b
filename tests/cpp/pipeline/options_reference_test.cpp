// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include <gtest/gtest.h>

#include <string>

#include "option_list.hpp"

namespace survtrack {
namespace {

TEST(OptionsReference, HasARowForEveryOption) {
  const std::string page = options_reference();
  std::size_t rows = 0;
  for (const ListedOption& option : all_options()) {
    const std::size_t row = page.find("| `" + option.path + "` | `");
    ASSERT_NE(row, std::string::npos) << option.path;
    ++rows;
    EXPECT_NE(page.find(option.meaning), std::string::npos) << option.path;
  }
  std::size_t found = 0;
  for (std::size_t at = page.find("\n| `"); at != std::string::npos; at = page.find("\n| `", at + 1)) ++found;
  EXPECT_EQ(found, rows);
}

TEST(OptionsReference, HasASectionForEveryModel) {
  const std::string page = options_reference();
  for (const std::string& model : all_models()) {
    const std::size_t equals = model.find('=');
    const std::string heading = model.substr(0, equals) + " = \"" + model.substr(equals + 1) + "\"";
    EXPECT_NE(page.find(heading), std::string::npos) << heading;
  }
}

TEST(OptionsReference, SaysWhatIsAllowed) {
  const std::string page = options_reference();
  for (const ListedOption& option : all_options()) {
    const std::string allowed = option.type == OptionType::boolean  ? "true, false"
                                : option.type == OptionType::choice ? option.choices.front()
                                : option.type == OptionType::numbers ? describe(option.bounds, option.count)
                                                                     : describe(option.bounds);
    // Options of several models may share a path: the row is known by its meaning and what it allows.
    const std::string start = "| `" + option.path + "` | `";
    std::string line;
    bool found = false;
    for (std::size_t row = page.find(start); row != std::string::npos && !found; row = page.find(start, row + 1)) {
      line = page.substr(row, page.find('\n', row) - row);
      found = line.find(option.meaning) != std::string::npos && line.find(allowed) != std::string::npos;
    }
    EXPECT_TRUE(found) << option.path << ": " << allowed;
    for (const std::string& choice : option.choices) EXPECT_NE(line.find(choice), std::string::npos) << line;
  }
}

}  // namespace
}  // namespace survtrack
