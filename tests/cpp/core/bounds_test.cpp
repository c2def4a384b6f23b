// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "../error_message.hpp"
#include "survtrack/core/fields.hpp"

namespace survtrack {
namespace {

struct Inner {
  int count = 3;
  static constexpr auto fields() {
    return std::make_tuple(field("count", &Inner::count, "", "a count", between(1, 5)));
  }
};

struct Outer {
  double share = 0.5;
  Inner inner;
  static constexpr auto fields() {
    return std::make_tuple(field("share", &Outer::share, "", "a share", above_up_to(0, 1)),
                           field("inner", &Outer::inner, "", "inside"));
  }
};

TEST(Bounds, AllowTheirEndsAsTheySay) {
  EXPECT_TRUE(allows(Bounds{2}, 2.0));
  EXPECT_FALSE(allows(Bounds{2}, std::nextafter(2.0, 0.0)));
  EXPECT_FALSE(allows(Bounds{2, std::numeric_limits<double>::infinity(), true}, 2.0));
  EXPECT_TRUE(allows(Bounds{2, std::numeric_limits<double>::infinity(), true}, std::nextafter(2.0, 3.0)));
  EXPECT_TRUE(allows(between(0, 1), 0.0));
  EXPECT_TRUE(allows(between(0, 1), 1.0));
  EXPECT_FALSE(allows(between(0, 1), 1.0000001));
  EXPECT_FALSE(allows(above_up_to(0, 1), 0.0));
  EXPECT_TRUE(allows(above_up_to(0, 1), 1.0));
}

TEST(Bounds, OddNumbersAndZero) {
  const Bounds bounds = odd_up_to(7);
  for (const double good : {0.0, 1.0, 3.0, 7.0}) EXPECT_TRUE(allows(bounds, good)) << good;
  for (const double bad : {-1.0, 2.0, 6.0, 9.0}) EXPECT_FALSE(allows(bounds, bad)) << bad;
}

TEST(Bounds, DescribeThemselves) {
  EXPECT_EQ(describe({}), "a finite number");
  EXPECT_EQ(describe(Bounds{2}), "at least 2");
  EXPECT_EQ(describe(Bounds{0, std::numeric_limits<double>::infinity(), true}), "above 0");
  EXPECT_EQ(describe(between(0, 1e6)), "between 0 and 1000000");
  EXPECT_EQ(describe(above_up_to(0, 0.5)), "above 0 and at most 0.5");
  EXPECT_EQ(describe(odd_up_to(31)), "between 0 and 31, 0 or odd");
  EXPECT_EQ(describe(Bounds{-std::numeric_limits<double>::infinity(), 4.0}), "at most 4");
}

TEST(CheckFields, NamesTheFullPathTheValueAndWhatIsAllowed) {
  Outer options;
  EXPECT_NO_THROW(check_fields(options));
  options.inner.count = 6;
  EXPECT_EQ(message_of<ConfigError>([&] { check_fields(options); }),
            "inner.count: 6 is not allowed; expected between 1 and 5");
  EXPECT_EQ(message_of<ConfigError>([&] { check_fields(options, "outer"); }),
            "outer.inner.count: 6 is not allowed; expected between 1 and 5");
}

TEST(CheckFields, RefusesWhatIsNotFinite) {
  Outer options;
  for (const double bad : {std::nan(""), HUGE_VAL, -HUGE_VAL}) {
    options.share = bad;
    EXPECT_TRUE(contains(message_of<ConfigError>([&] { check_fields(options); }), "share: ", "above 0 and at most 1"));
  }
}

}  // namespace
}  // namespace survtrack
