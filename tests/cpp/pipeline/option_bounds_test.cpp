// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>
#include <string>

#include "../error_message.hpp"
#include "option_list.hpp"

namespace survtrack {
namespace {

std::string written(double value) {
  std::ostringstream text;
  text.precision(17);
  text << value;
  if (text.str().find_first_of(".e") == std::string::npos) text << ".0";
  return text.str();
}

std::string written(const ListedOption& option, double value) {
  return option.type == OptionType::integer ? std::to_string(static_cast<long long>(value)) : written(value);
}

void expect_refused(const ListedOption& option, const std::string& value, const std::string& expected) {
  Config config = config_with(option);
  const std::string before = config.to_json();
  const std::string message = message_of<ConfigError>([&] { config.set(option.path + "=" + value); });
  EXPECT_EQ(message.rfind(option.path + ": ", 0), 0U) << message;
  EXPECT_TRUE(contains(message, "is not allowed; expected ", expected));
  EXPECT_EQ(config.to_json(), before) << option.path;
}

void expect_taken(const ListedOption& option, const std::string& value) {
  Config config = config_with(option);
  EXPECT_NO_THROW(config.set(option.path + "=" + value)) << option.path << " = " << value;
}

bool is_numeric(const ListedOption& option) {
  return option.type == OptionType::integer || option.type == OptionType::number;
}

TEST(OptionBounds, AreKeptOnBothSides) {
  int low_ends = 0, high_ends = 0;
  for (const ListedOption& option : all_options()) {
    if (!is_numeric(option)) continue;
    const Bounds& bounds = option.bounds;
    const bool whole = option.type == OptionType::integer;
    const auto next = [&](double from, double direction) {
      return whole ? from + direction : std::nextafter(from, direction * HUGE_VAL);
    };
    if (std::isfinite(bounds.low)) {
      ++low_ends;
      if (bounds.above_low) {
        expect_refused(option, written(option, bounds.low), describe(bounds));
        expect_taken(option, written(option, next(bounds.low, 1.0)));
      } else {
        expect_taken(option, written(option, bounds.low));
        expect_refused(option, written(option, next(bounds.low, -1.0)), describe(bounds));
      }
    }
    if (std::isfinite(bounds.high)) {
      ++high_ends;
      expect_taken(option, written(option, bounds.high));
      expect_refused(option, written(option, next(bounds.high, bounds.odd_or_zero ? 2.0 : 1.0)), describe(bounds));
    }
    if (bounds.odd_or_zero) expect_refused(option, "2", describe(bounds));
  }
  EXPECT_GT(low_ends, 20);
  EXPECT_GT(high_ends, 10);
}

TEST(OptionBounds, RefuseWhatIsNotFinite) {
  for (const ListedOption& option : all_options()) {
    if (!is_numeric(option)) continue;
    for (const char* value : {"nan", "inf", "-inf"}) {
      Config config = config_with(option);
      const std::string message = message_of<ConfigError>([&] { config.set(option.path + "=" + value); });
      EXPECT_TRUE(contains(message, option.path + ": ", value, describe(option.bounds)));
    }
  }
}

TEST(OptionBounds, RefuseWrongTypes) {
  for (const ListedOption& option : all_options()) {
    switch (option.type) {
      case OptionType::boolean:
        for (const char* value : {"1", "0.0", "\"true\"", "yes", "[true]", "{}"}) {
          expect_refused(option, value, "true or false");
        }
        break;
      case OptionType::integer:
        for (const char* value : {"1.0", "1.5", "true", "\"3\"", "three", "[3]", "{a = 3}", "nan"}) {
          expect_refused(option, value, "an integer");
        }
        break;
      case OptionType::number:
        for (const char* value : {"true", "\"0.5\"", "half", "[0.5]", "1979-05-27", "1e", "0x"}) {
          expect_refused(option, value, "a number");
        }
        break;
      case OptionType::numbers:
        for (const std::string& value :
             {std::string("3.5"), std::string("\"[1]\""), std::string("[]"), std::string("{a = 1}"), std::string("[1"),
              option.list_of("1.0", option.count - 1), option.list_of("1.0", option.count + 1)}) {
          expect_refused(option, value, std::to_string(option.count) + " numbers, each " + describe(option.bounds));
        }
        break;
      case OptionType::choice:
        for (const char* value : {"1", "true", "nothing_like_it", "[]", ""}) {
          for (const std::string& choice : option.choices) expect_refused(option, value, choice);
        }
        break;
    }
  }
}

TEST(OptionBounds, HoldForEachNumberOfAListAndNameIt) {
  int lists = 0;
  for (const ListedOption& option : all_options()) {
    if (option.type != OptionType::numbers) continue;
    ++lists;
    const std::string ones = option.list_of("1.0");
    expect_taken(option, ones);
    for (std::size_t i = 0; i < option.count; ++i) {
      const auto with = [&](const std::string& value) {
        std::string list = ones;
        return option.path + "=" + list.replace(1 + 5 * i, 3, value);
      };
      const std::string entry = option.path + "[" + std::to_string(i) + "]: ";
      const auto message = [&](const std::string& value) {
        Config config = config_with(option);
        const std::string before = config.to_json();
        const std::string text = message_of<ConfigError>([&] { config.set(with(value)); });
        EXPECT_EQ(config.to_json(), before) << option.path;
        return text;
      };
      const double above = std::nextafter(option.bounds.high, HUGE_VAL);
      EXPECT_EQ(message(written(above)).rfind(entry, 0), 0U) << message(written(above));
      EXPECT_TRUE(contains(message("nan"), entry + "nan is not allowed; expected " + describe(option.bounds)));
      EXPECT_TRUE(contains(message("\"a\""), entry + "\"a\" is not allowed; expected a number"));
      EXPECT_TRUE(contains(message("true"), entry + "true is not allowed; expected a number"));
      EXPECT_TRUE(contains(message("[1.0]"), entry + "[1.0] is not allowed; expected a number"));
      expect_taken(option, with("2").substr(option.path.size() + 1));
    }
  }
  EXPECT_GT(lists, 5);
}

TEST(OptionBounds, OfAListInTheStructNameTheEntry) {
  Config config;
  config.filter = KalmanDiscreteOptions{.process_variances = {1.0, 1.0, -2.0, 1.0}};
  EXPECT_EQ(message_of<ConfigError>([&] { check_fields(config); }),
            "filter.process_variances[2]: -2 is not allowed; expected between 0 and 1000000000000");
}

TEST(OptionBounds, RefuseIntegersOutOfTheTypesRange) {
  for (const ListedOption& option : all_options()) {
    if (option.type != OptionType::integer) continue;
    for (const char* value : {"2147483648", "4294967297", "-2147483649", "9223372036854775807", "-9223372036854775808"}) {
      expect_refused(option, value, describe(option.bounds));
    }
    Config config = config_with(option);
    EXPECT_THROW(config.set(option.path + "=18446744073709551617"), ConfigError);
  }
}

TEST(OptionBounds, AlsoHoldForValuesSetInTheStructs) {
  Config config;
  config.time_unit_s = 0.0;
  EXPECT_TRUE(contains(message_of<ConfigError>([&] { check_fields(config); }), "time_unit_s: 0 is not allowed"));
  config = {};
  config.filter = KalmanCaOptions{.position_noise = -1.0};
  EXPECT_TRUE(contains(message_of<ConfigError>([&] { check_fields(config); }), "filter.position_noise: -1"));
  config = {};
  config.blobs.min_area_px = std::nan("");
  EXPECT_TRUE(contains(message_of<ConfigError>([&] { check_fields(config); }), "blobs.min_area_px: nan"));
}

TEST(OptionBounds, EveryDefaultIsAllowed) {
  EXPECT_NO_THROW(check_fields(Config{}));
  for (const std::string& model : all_models()) {
    Config config;
    EXPECT_NO_THROW(config.set(model)) << model;
    EXPECT_NO_THROW(check_fields(config)) << model;
  }
}

}  // namespace
}  // namespace survtrack
