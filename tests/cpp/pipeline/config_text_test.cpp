// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "option_list.hpp"

namespace survtrack {
namespace {

void expect_round_trips(const Config& config, const std::string& what) {
  EXPECT_EQ(Config::from_toml(config.to_toml()).to_json(), config.to_json()) << what;
  EXPECT_EQ(Config::from_json(config.to_json()).to_json(), config.to_json()) << what;
  EXPECT_TRUE(Config::from_toml(config.to_toml()) == config) << what;
}

TEST(ConfigText, DefaultsRoundTrip) { expect_round_trips({}, "defaults"); }

TEST(ConfigText, EveryModelRoundTrips) {
  for (const std::string& model : all_models()) {
    Config config;
    config.set(model);
    expect_round_trips(config, model);
  }
}

TEST(ConfigText, EveryOptionRoundTripsWithAnotherValue) {
  for (const ListedOption& option : all_options()) {
    Config config = config_with(option);
    const std::string before = config.to_json();
    switch (option.type) {
      case OptionType::boolean:
        config.set(option.path + "=true");
        if (config.to_json() == before) config.set(option.path + "=false");
        break;
      case OptionType::integer: {
        const int other = option.bounds.odd_or_zero ? 13 : static_cast<int>(std::min(option.bounds.high, 37.0));
        config.set(option.path + "=" + std::to_string(other));
        break;
      }
      case OptionType::number:
        config.set(option.path + (option.bounds.low < 1.0 ? "=0.12345678901234567" : "=1.2345678901234567"));
        break;
      case OptionType::numbers: config.set(option.path + "=" + option.list_of("0.12345678901234567")); break;
      case OptionType::choice:
        for (const std::string& choice : option.choices) {
          if (config.to_json() == before) config.set(option.path + "=" + choice);
        }
        break;
    }
    EXPECT_NE(config.to_json(), before) << option.path << " changes nothing";
    expect_round_trips(config, option.path);
  }
}

TEST(ConfigText, NumbersKeepEveryBit) {
  const auto max_match = [](const Config& config) { return std::get<MatchMatrixOptions>(config.cost).max_match; };
  for (const double value : {1.0 / 3.0, std::nextafter(0.1, 1.0), 1e-300, 5e-324, 123456.78901234567}) {
    Config config;
    config.cost = MatchMatrixOptions{.max_match = value};
    EXPECT_EQ(max_match(Config::from_toml(config.to_toml())), value);
    EXPECT_EQ(max_match(Config::from_json(config.to_json())), value);
  }
}

TEST(ConfigText, TomlExplainsEveryOption) {
  for (const ListedOption& option : all_options()) {
    const std::string text = "\n" + config_with(option).to_toml();
    const std::size_t line = text.find("\n" + option.path.substr(option.path.rfind('.') + 1) + " = ");
    ASSERT_NE(line, std::string::npos) << option.path;
    EXPECT_NE(text.find(option.meaning), std::string::npos) << option.path;
  }
}

TEST(ConfigText, EmptyTextIsTheDefaults) {
  EXPECT_TRUE(Config::from_toml("") == Config{});
  EXPECT_TRUE(Config::from_toml("# nothing but this\n") == Config{});
  EXPECT_TRUE(Config::from_json("{}") == Config{});
}

TEST(ConfigText, UpdatesAddToWhatIsThere) {
  Config config;
  config.update_from_toml("time_unit_s = 2.0\n");
  config.update_from_json(R"({"cleanup": {"open_px": 7}})");
  EXPECT_EQ(config.time_unit_s, 2.0);
  EXPECT_EQ(config.cleanup.open_px, 7);
}

TEST(ConfigText, AWholeNumberIsANumberToo) { EXPECT_EQ(Config::from_toml("time_unit_s = 2\n").time_unit_s, 2.0); }

TEST(ConfigText, OrderInATableDoesNotMatter) {
  const Config config = Config::from_toml("[filter]\nposition_noise = 0.25\nmodel = \"kalman_ca\"\n");
  EXPECT_EQ(std::get<KalmanCaOptions>(config.filter).position_noise, 0.25);
}

}  // namespace
}  // namespace survtrack
