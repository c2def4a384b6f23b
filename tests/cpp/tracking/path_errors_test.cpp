// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

// What no path is, and files of paths.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "../error_message.hpp"
#include "some_paths.hpp"
#include "survtrack/core/errors.hpp"
#include "survtrack/tracking/paths.hpp"

namespace survtrack {
namespace {

constexpr double inf = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();

std::string refusal(const std::vector<Point>& points, bool closed = false, PathKind kind = PathKind::line, double most_px = inf) {
  return message_of<InputError>([&] { Path(points, closed, kind, most_px); });
}

TEST(PathErrors, ThePointsAreNamed) {
  EXPECT_TRUE(contains(refusal({}), "points: has 0; expected 2 to 2000"));
  EXPECT_TRUE(contains(refusal({{1, 2}}), "points: has 1; expected 2 to 2000"));
  EXPECT_TRUE(contains(refusal({{1, 2}, {3, 4}}, true), "points: has 2; expected 3 to 2000 of a closed path"));
  EXPECT_TRUE(contains(refusal(std::vector<Point>(2001)), "points: has 2001"));
  EXPECT_TRUE(contains(refusal({{0, 0}, {nan, 4}}), "points[1]: is (nan, 4); expected finite px within +-1e6"));
  EXPECT_TRUE(contains(refusal({{0, -inf}, {3, 4}}), "points[0]: is (0, -inf)"));
  EXPECT_TRUE(contains(refusal({{0, 0}, {2e6, 4}}), "points[1]: is (2000000, 4)"));
  EXPECT_TRUE(contains(refusal({{0, 0}, {5, 4}, {5, 4}}), "points[2]: (5, 4) is the same as points[1]"));
  EXPECT_TRUE(contains(refusal({{0, 0}, {5, 4}, {0, 9}, {0, 0}}, true), "points[3]: (0, 0) is the first point again"));
  EXPECT_TRUE(contains(refusal({{0, 0}, {9, 0}}, false, PathKind::line, 0.0), "max_distance_px: is 0; expected px above 0"));
  EXPECT_TRUE(contains(refusal({{0, 0}, {9, 0}}, false, PathKind::line, nan), "max_distance_px: is nan"));
}

TEST(PathErrors, APathThatMeetsItselfIsRefused) {
  EXPECT_TRUE(contains(refusal({{0, 0}, {100, 0}, {100, 50}, {40, -30}}),
                       "points: the path meets itself near (62.5, 0), between points[0] and points[1] and between points[2] "
                       "and points[3]"));
  EXPECT_TRUE(contains(refusal({{0, 0}, {100, 100}, {100, 0}, {0, 100}}, true), "near (50, 50)"));
  EXPECT_TRUE(contains(refusal({{0, 0}, {100, 0}, {100, 50}, {50, 0}}), "near (50, 0)"));  // touches
  EXPECT_TRUE(contains(refusal({{0, 0}, {100, 0}, {100, 50}, {0, 0}}), "near (0, 0)"));    // open, and comes back
  EXPECT_TRUE(contains(refusal({{0, 0}, {100, 0}, {40, 0}}), "points[1]: the path turns straight back at (100, 0)"));
  EXPECT_TRUE(contains(refusal({{0, 0}, {100, 0}, {40, 0}}, true), "turns straight back"));
  EXPECT_TRUE(contains(refusal({{0, 0}, {100, 0}, {100, 50}, {70, 50}, {70, 0}, {30, 0}}), "meets itself near (70, 0)"));
  std::vector<Point> twice = circle(40, 100.0);
  for (int i = 0; i < 20; ++i) twice.push_back((1.0 + 0.01 * std::cos(i)) * twice[static_cast<std::size_t>(i)]);
  EXPECT_TRUE(contains(refusal(twice, false, PathKind::curve), "meets itself near ("));
  EXPECT_NO_THROW(Path({{0, 0}, {100, 0}, {1, 1}}, true));
}

TEST(PathErrors, PositionsAreNamed) {
  const Path path(square_points, true);
  const std::vector<Point> points{{1, 2}, {nan, 3}};
  std::vector<PathPosition> places(2);
  EXPECT_TRUE(contains(message_of<InputError>([&] { path.to_path(points.data(), 2, places.data()); }),
                       "points[1]: is (nan, 3); expected finite numbers within +-1e9"));
  EXPECT_TRUE(contains(message_of<InputError>([&] { path.to_image({inf, 0}); }), "places[0]: is (inf, 0)"));
  EXPECT_THROW(path.residual(nan, 0), InputError);
  EXPECT_THROW(path.tangent(2e9), InputError);
  EXPECT_THROW(path.wrap(-inf), InputError);
  EXPECT_THROW(path.velocity({0, 0}, {0, nan}), InputError);
  EXPECT_TRUE(std::isfinite(path.to_path({-1e9, 1e9}).t_px));
}

const std::string good = R"({"frame_size": [640, 480], "paths": [
  {"name": "lane", "points": [[0, 200], [300, 210.5], [639, 220]]},
  {"name": "track", "closed": true, "kind": "curve", "max_distance_px": 40, "points": [[0, 0], [90, 0], [90, 90], [0, 90]]}]})";

std::string file_refusal(const std::string& old, const std::string& replacement) {
  std::string text = good;
  const auto place = text.find(old);
  EXPECT_NE(place, std::string::npos) << old;
  text.replace(place, old.size(), replacement);
  return message_of<InputError>([&] { Paths::from_json(text, "p.json"); });
}

TEST(PathsJson, ReadsWhatIsThere) {
  const Paths paths = Paths::from_json(good, "p.json");
  EXPECT_EQ(paths.frame_width, 640);
  EXPECT_EQ(paths.frame_height, 480);
  ASSERT_EQ(paths.items().size(), 2U);
  EXPECT_EQ(paths.items()[0], (NamedPath{"lane", Path({{0, 200}, {300, 210.5}, {639, 220}})}));
  EXPECT_EQ(paths.items()[1], (NamedPath{"track", Path({{0, 0}, {90, 0}, {90, 90}, {0, 90}}, true, PathKind::curve, 40.0)}));
}

TEST(PathsJson, SavedAndLoadedAreEqual) {
  Paths paths;
  paths.add("a \"b\", ü", Path({{1.0 / 3.0, 0}, {1e-5, 1e6}}));
  paths.add("c", Path(circle(7, 90.0), true, PathKind::curve, 12.5));
  const Paths loaded = Paths::from_json(paths.to_json(), "p.json");
  EXPECT_EQ(loaded.items(), paths.items());
  EXPECT_EQ(loaded.frame_width, 0);
  const Path& path = paths.items()[1].path;
  EXPECT_EQ(Path::from_json(path.to_json(), "path"), path);
}

TEST(PathsJson, WhatIsWrongIsNamed) {
  EXPECT_TRUE(contains(file_refusal("[640", "640"), "p.json: is not JSON, at byte ", "expected paths"));
  EXPECT_TRUE(contains(file_refusal("[640, 480]", "[640]"), "p.json.frame_size: has 1 entries; expected 2"));
  EXPECT_TRUE(contains(file_refusal("640", "0"), "p.json.frame_size[0]: is 0"));
  EXPECT_TRUE(contains(file_refusal("\"paths\"", "\"path\""), "p.json: has an unknown entry \"path\"; expected: survtrack, frame_size, paths"));
  EXPECT_TRUE(contains(file_refusal("\"closed\"", "\"close\""), "p.json.paths[1]: has an unknown entry \"close\""));
  EXPECT_TRUE(contains(file_refusal("true", "1"), "p.json.paths[1].closed: is not true or false"));
  EXPECT_TRUE(contains(file_refusal("curve", "bow"), "p.json.paths[1].kind: is \"bow\"; expected line or curve"));
  EXPECT_TRUE(contains(file_refusal("_px\": 40", "_px\": -40"), "p.json.paths[1].max_distance_px: is -40; expected px above 0"));
  EXPECT_TRUE(contains(file_refusal("[639, 220]", "[639]"), "p.json.paths[0].points[2]: has 1 entries; expected 2"));
  EXPECT_TRUE(contains(file_refusal("[639, 220]", "[300, 210.5]"), "p.json.paths[0].points[2]: (300, 210.5) is the same as points[1]"));
  EXPECT_TRUE(contains(file_refusal("[0, 90]]", "[45, -9]]"), "p.json.paths[1].points: the path meets itself near"));
  EXPECT_TRUE(contains(file_refusal("\"lane\"", "\"track\""), "p.json.paths[1].name: \"track\" is the name of two paths"));
  EXPECT_TRUE(contains(file_refusal("\"lane\"", "\"\""), "p.json.paths[0].name: \"\" is not allowed"));
  EXPECT_TRUE(contains(file_refusal("\"lane\"", "\"a\\nb\""), "p.json.paths[0].name: \"a\\nb\" is not allowed"));
  EXPECT_TRUE(contains(file_refusal("\"lane\"", "7"), "p.json.paths[0].name: is not a text"));
  EXPECT_TRUE(contains(file_refusal("\"name\": \"lane\", ", ""), "p.json.paths[0]: has no \"name\""));
  EXPECT_TRUE(contains(message_of<InputError>([] { Path::from_json("[]", "x"); }), "x: is not an object"));
  EXPECT_TRUE(contains(message_of<InputError>([] { Paths().add("\xff", Path({{0, 0}, {1, 0}})); }), "name: is not UTF-8"));
}

}  // namespace
}  // namespace survtrack
