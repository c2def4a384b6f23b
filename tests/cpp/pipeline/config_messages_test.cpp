// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include <gtest/gtest.h>

#include <string>

#include "../error_message.hpp"
#include "option_list.hpp"
#include "survtrack/pipeline/tracker.hpp"

namespace survtrack {
namespace {

std::string refusal(const std::string& option_and_value) {
  Config config;
  return message_of<ConfigError>([&] { config.set(option_and_value); });
}

TEST(ConfigMessages, UnknownModelNamesPathAndChoices) {
  EXPECT_EQ(refusal("filter.model=kalmann"),
            "filter.model: unknown \"kalmann\"; one of: kalman_cv, kalman_ca, mean_velocity, kalman_discrete, "
            "kalman_box, kalman_path, extended, unscented, particle");
  for (const std::string& model : all_models()) {
    const std::string path = model.substr(0, model.find('='));
    EXPECT_TRUE(contains(refusal(path + "=nothing"), path + ": unknown \"nothing\"; one of: ",
                         model.substr(model.find('=') + 1)));
    EXPECT_TRUE(contains(refusal(path + "=3"), path + ": 3 is not allowed; expected one of: "));
    EXPECT_TRUE(contains(refusal(path + "="), path + ": unknown \"\""));
  }
}

TEST(ConfigMessages, UnknownOptionNamesPathAndChoices) {
  EXPECT_TRUE(contains(refusal("no_such=1"), "no_such: unknown option; one of: time_unit_s, scene_change, segmenter, "));
  EXPECT_TRUE(contains(refusal("cleanup.no_such=1"), "cleanup.no_such: unknown option; one of: median_px, open_px"));
  EXPECT_TRUE(contains(refusal("filter.no_such=1"), "filter.no_such: unknown option; one of: model, noise_unit"));
  Config config;
  config.set("assignment.model=oldest_first");
  EXPECT_TRUE(contains(message_of<ConfigError>([&] { config.set("assignment.confirmed_first=true"); }),
                       "assignment.confirmed_first: unknown option; one of: model"));
}

TEST(ConfigMessages, APathTooDeepOrTooShort) {
  EXPECT_TRUE(contains(refusal("time_unit_s.deeper=1"), "time_unit_s: {\"deeper\":1} is not allowed; expected a number"));
  EXPECT_TRUE(contains(refusal("filter=kalman_ca"), "filter: \"kalman_ca\" is not allowed; expected a table"));
  EXPECT_TRUE(contains(refusal("cleanup=5"), "cleanup: 5 is not allowed; expected a table"));
}

TEST(ConfigMessages, WhatIsNoSetting) {
  for (const char* text : {"", "filter.model", "=3", "  =3", ".time_unit_s=1", ". =1"}) {
    EXPECT_TRUE(contains(refusal(text), "expected option=value"));
  }
  EXPECT_TRUE(contains(refusal("filter.=3"), "unknown option"));
  EXPECT_TRUE(contains(refusal("filter..model=kalman_cv"), "unknown option"));
  EXPECT_TRUE(contains(refusal("time_unit_s="), "time_unit_s: \"\" is not allowed"));
  EXPECT_TRUE(contains(refusal("time_unit_s=1\ncleanup.open_px=3"), "time_unit_s: ", "is not allowed"));
}

TEST(ConfigMessages, BytesThatAreNoTextAreStillAConfigError) {
  EXPECT_TRUE(contains(refusal("filter.noise_unit=\xff\xfe"), "filter.noise_unit: ", "one of: object_size, px"));
}

TEST(ConfigMessages, BadTomlNamesTheFileAndTheLine) {
  const std::string text = "time_unit_s = 1.0\n[filter]\nmodel = \n";
  EXPECT_TRUE(contains(message_of<ConfigError>([&] { Config::from_toml(text, "camera.toml"); }), "camera.toml:3:"));
  EXPECT_TRUE(contains(message_of<ConfigError>([] { Config::from_toml("time_unit_s = 1.0\ntime_unit_s = 2.0\n"); }),
                       "config:2:"));
}

TEST(ConfigMessages, AWrongOptionInAFileNamesTheFile) {
  EXPECT_EQ(message_of<ConfigError>([] { Config::from_toml("[cleanup]\nmedian_px = 4\n", "camera.toml"); }),
            "camera.toml: cleanup.median_px: 4 is not allowed; expected between 0 and 31, 0 or odd");
  EXPECT_TRUE(contains(message_of<ConfigError>([] { Config::from_json(R"({"cleanup": {"median_px": "5"}})", "c.json"); }),
                       "c.json: cleanup.median_px: \"5\" is not allowed; expected an integer"));
}

TEST(ConfigMessages, BadJson) {
  for (const char* text : {"", "{", "{\"time_unit_s\": }", "{\"time_unit_s\": nan}", "\xff"}) {
    EXPECT_TRUE(contains(message_of<ConfigError>([&] { Config::from_json(text, "c.json"); }), "c.json: is not JSON"));
  }
  for (const char* text : {"[]", "3", "null", "\"text\""}) {
    EXPECT_TRUE(contains(message_of<ConfigError>([&] { Config::from_json(text); }), "config: ", "expected a table"));
  }
  EXPECT_TRUE(contains(message_of<ConfigError>([] { Config::from_json(R"({"time_unit_s": 1e999})"); }), "too large"));
}

TEST(ConfigMessages, AnErrorLeavesTheConfigAsItWas) {
  Config config;
  config.set("filter.model=kalman_ca");
  const std::string before = config.to_json();
  EXPECT_THROW(config.update_from_toml("time_unit_s = 2.0\n[filter]\nmodel = \"kalman_cv\"\n[cleanup]\nopen_px = 2\n"),
               ConfigError);
  EXPECT_EQ(config.to_json(), before);
  EXPECT_THROW(config.update_from_json(R"({"time_unit_s": 2.0, "no_such": 1})"), ConfigError);
  EXPECT_EQ(config.to_json(), before);
  EXPECT_THROW(config.set("filter={model = \"kalman_cv\", position_noise = -1.0}"), ConfigError);
  EXPECT_EQ(config.to_json(), before);
}

TEST(ConfigMessages, AFilterWithoutCovarianceHasNoGaussianCost) {
  Config config;
  config.filter = MeanVelocityOptions{};
  config.cost = GaussianCostOptions{};
  EXPECT_EQ(message_of<ConfigError>([&] { Tracker{config}; }),
            "cost.model: \"gaussian\" needs a filter with a covariance, and filter.model is \"mean_velocity\"; "
            "expected cost.model match_matrix, belief or distance, or another filter.model");
  EXPECT_THROW(Detector{config}, ConfigError);
  EXPECT_THROW(config.check(), ConfigError);
  const std::vector<CostOptions> allowed = {MatchMatrixOptions{}, BeliefOptions{}, DistanceOptions{}};
  for (const CostOptions& other : allowed) {
    config.cost = other;
    EXPECT_NO_THROW(Tracker{config});
  }
  config.cost = GaussianCostOptions{};
  for (const FilterOptions& other : std::vector<FilterOptions>{KalmanCvOptions{}, KalmanCaOptions{}}) {
    config.filter = other;
    EXPECT_NO_THROW(Tracker{config});
  }
}

TEST(ConfigMessages, ContactsThatAreNotKeptDoNotStartAnew) {
  Config config;
  config.lifecycle = CountMedianOptions{.keep_contacts = false, .restart_after_s = 1.5};
  EXPECT_EQ(message_of<ConfigError>([&] { config.check(); }),
            "lifecycle.restart_after_s: 1.5 needs contacts that are kept, and lifecycle.keep_contacts is false; "
            "expected lifecycle.keep_contacts true, or 0");
  std::get<CountMedianOptions>(config.lifecycle).keep_contacts = true;
  EXPECT_NO_THROW(config.check());
}

TEST(ConfigMessages, HistogramsThatCountForNothingAreRefused) {
  Config config;
  config.appearance = ColorHistogramOptions{.weight = 0.0, .min_intersection = 0.0};
  EXPECT_EQ(message_of<ConfigError>([&] { config.check(); }).find("appearance.weight: 0 changes nothing"), 0U);
  config.appearance = ColorHistogramOptions{.weight = 0.0, .min_intersection = 0.5};
  EXPECT_NO_THROW(config.check());
}

TEST(ConfigMessages, ContactsThatAreKeptDoNotComeBack) {
  Config config;
  config.lifecycle = CountMedianOptions{.keep_contacts = true};
  config.reentry = RememberOptions{};
  EXPECT_EQ(message_of<ConfigError>([&] { config.check(); }),
            "reentry.model: \"remember\" needs tracks that end, and lifecycle.keep_contacts is true; "
            "expected lifecycle.keep_contacts false, or reentry.model none");
  config.lifecycle = CountMedianOptions{};
  EXPECT_NO_THROW(config.check());
}

TEST(ConfigMessages, AMeasurementCovarianceThatIsNoneIsRefusedWithItsEigenvalue) {
  Config config;
  config.set("filter={model = \"kalman_discrete\", measurement_covariance = [0.2877, 1.1909, 1.1465]}");
  EXPECT_EQ(message_of<ConfigError>([&] { Tracker{config}; }),
            "filter.measurement_covariance: [[0.2877, 1.1909], [1.1909, 1.1465]] is not allowed, its smallest eigenvalue is "
            "-0.548849; expected a covariance with both above 0, or filter.covariances as_published");
  EXPECT_THROW(Detector{config}, ConfigError);
  EXPECT_THROW(make_filter_bank(config.filter), ConfigError);
  config.set("filter.covariances=as_published");
  EXPECT_TRUE(contains(message_of<ConfigError>([&] { config.check(); }),
                       "cost.model: \"gaussian\" needs a filter with a covariance, and filter.covariances is \"as_published\""));
  config.set("cost.model=distance");
  EXPECT_NO_THROW(Tracker{config});
  // One axis measured exactly, or two that say the same.
  for (const char* R : {"[0, 0, 1]", "[1, 1, 1]", "[4, -2, 1]"}) {
    config.set("filter={model = \"kalman_discrete\", measurement_covariance = " + std::string(R) + "}");
    EXPECT_TRUE(contains(message_of<ConfigError>([&] { config.check(); }), "its smallest eigenvalue is 0; expected"));
  }
}

TEST(ConfigMessages, AFilterOverBoxesNeedsTheirCentre) {
  Config config;
  config.set("filter.model=kalman_box");
  EXPECT_NO_THROW(Tracker{config});
  config.set("measurement.model=centroid");
  EXPECT_EQ(message_of<ConfigError>([&] { Tracker{config}; }),
            "measurement.model: \"centroid\" measures no box, and filter.model is \"kalman_box\"; expected "
            "measurement.model box_center, or another filter.model");
}

}  // namespace
}  // namespace survtrack
