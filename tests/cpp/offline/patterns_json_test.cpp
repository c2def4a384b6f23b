// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "../error_message.hpp"
#include "streets.hpp"
#include "survtrack/core/errors.hpp"
#include "survtrack/offline/patterns.hpp"

namespace survtrack {
namespace {

const std::string good = R"({"frame_size": [768, 576], "options": {"points": 8}, "patterns": [{"id": 1, "count": 4,
  "size_px": 40, "speed_px_per_s": 50, "speed_deviation_px_per_s": 5, "duration_s": 8, "duration_deviation_s": 1,
  "way": [[0, 200], [200, 200], [400, 100]], "spread_px": [1, 2, 3], "time_s": [0, 4, 8]}]})";

std::string with(const std::string& old, const std::string& replacement) {
  std::string text = good;
  const auto place = text.find(old);
  EXPECT_NE(place, std::string::npos) << old;
  return text.replace(place, old.size(), replacement);
}

std::string refusal(const std::string& text) {
  return message_of<InputError>([&] { Patterns::from_json(text, "p.json"); });
}

TEST(PatternsJson, SavedAndLoadedAreEqual) {
  Patterns learned = learn_patterns(two_streets());
  learned.options.max_distance = 1.0 / 3.0;
  learned.frame_width = 640;
  learned.frame_height = 480;
  const Patterns loaded = Patterns::from_json(learned.to_json(), "p.json");
  EXPECT_EQ(loaded.to_json(), learned.to_json());
  EXPECT_EQ(loaded.frame_height, 480);
  EXPECT_EQ(loaded.options.max_distance, 1.0 / 3.0);
  ASSERT_EQ(loaded.patterns.size(), 4U);
  EXPECT_EQ(loaded.patterns[2].way, learned.patterns[2].way);
  EXPECT_EQ(loaded.patterns[2].spread_px, learned.patterns[2].spread_px);
  EXPECT_EQ(loaded.patterns[2].time_s, learned.patterns[2].time_s);
}

TEST(PatternsJson, LoadedPatternsJudgeAlike) {
  const Patterns learned = learn_patterns(two_streets());
  const Patterns loaded = Patterns::from_json(learned.to_json(), "p.json");
  const History history = two_streets();
  const auto before = learned.classify(history), after = loaded.classify(history);
  for (std::size_t i = 0; i < before.size(); ++i) {
    EXPECT_EQ(after[i].pattern, before[i].pattern);
    EXPECT_EQ(after[i].distance, before[i].distance);
    EXPECT_EQ(after[i].speed_ratio, before[i].speed_ratio);
  }
}

TEST(PatternsJson, ReadsWhatIsThere) {
  const Patterns read = Patterns::from_json(good, "p.json");
  EXPECT_EQ(read.options.points, 8);
  EXPECT_EQ(read.frame_width, 768);
  ASSERT_EQ(read.patterns.size(), 1U);
  EXPECT_EQ(read.patterns[0].count, 4);
  EXPECT_EQ(read.patterns[0].speed_deviation_px_per_s, 5.0);
  EXPECT_EQ(read.patterns[0].leaves(), (Point{400, 100}));
  EXPECT_EQ(Patterns::from_json(with("[768, 576]", "null"), "p.json").frame_width, 0);
}

TEST(PatternsJson, WhatIsWrongIsNamed) {
  EXPECT_TRUE(contains(refusal(""), "p.json: is not JSON, at byte ", "expected learned patterns"));
  EXPECT_TRUE(contains(refusal("[1, 2"), "p.json: is not JSON"));
  EXPECT_TRUE(contains(refusal(with("4,", "1e999,")), "p.json: holds a number that is too large"));
  EXPECT_TRUE(contains(refusal("[]"), "p.json: has no \"options\""));
  EXPECT_TRUE(contains(refusal("{}"), "p.json: has no \"options\""));
  EXPECT_TRUE(contains(refusal(with("patterns", "ways")), "p.json: has no \"patterns\""));
  EXPECT_TRUE(contains(refusal(with("{\"points\": 8}", "8")), "p.json.options: 8 is not allowed"));
  EXPECT_TRUE(contains(refusal(with("\"points\": 8", "\"points\": 1")), "p.json.options.points: 1 is not allowed"));
  EXPECT_TRUE(contains(refusal(with("points", "dots")), "p.json.options.dots: unknown option"));
  EXPECT_TRUE(contains(refusal(with("768", "0")), "p.json.frame_size[0]: is 0; expected 1"));
  EXPECT_TRUE(contains(refusal(with("[768, 576]", "[768]")), "p.json.frame_size: has 1 entries; expected 2"));
  EXPECT_TRUE(contains(refusal(with("\"id\": 1", "\"id\": 2")), "p.json.patterns[0].id: is 2; expected 1"));
  EXPECT_TRUE(contains(refusal(with("\"count\": 4", "\"count\": 0")), "p.json.patterns[0].count: is 0"));
  EXPECT_TRUE(contains(refusal(with("\"size_px\": 40", "\"size_px\": 0")), "p.json.patterns[0].size_px: is 0"));
  EXPECT_TRUE(contains(refusal(with("\"speed_px_per_s\": 50", "\"speed_px_per_s\": -50")), "patterns[0].speed_px_per_s: is -50"));
  EXPECT_TRUE(contains(refusal(with("\"duration_s\": 8", "\"duration_s\": \"8\"")), "patterns[0].duration_s: is not a number"));
  EXPECT_TRUE(contains(refusal(with("[400, 100]", "[400, 1e10]")), "patterns[0].way[2][1]: is 10000000000.0"));
  EXPECT_TRUE(contains(refusal(with("[400, 100]", "[400]")), "patterns[0].way[2]: has 1 entries; expected 2"));
  EXPECT_TRUE(contains(refusal(with("[0, 200], [200, 200], ", "")), "patterns[0].way: has 1 points; expected at least 2"));
  EXPECT_TRUE(contains(refusal(with("[1, 2, 3]", "[1, 2]")), "patterns[0].spread_px: has 2 entries; expected 3"));
  EXPECT_TRUE(contains(refusal(with("[0, 4, 8]", "[0, 8, 4]")), "patterns[0].time_s[2]: is 4; expected 8.0 to"));
  EXPECT_TRUE(contains(refusal(with("[1, 2, 3]", "[1, -2, 3]")), "patterns[0].spread_px[1]: is -2"));
}

}  // namespace
}  // namespace survtrack
