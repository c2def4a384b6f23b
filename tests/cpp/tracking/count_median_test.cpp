// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <vector>

#include "box_run.hpp"
#include "monitor_config.hpp"

namespace survtrack {
namespace {

using Ids = std::vector<std::int64_t>;

Box at(double x, double y) { return Box::around({x, y}, 20.0, 20.0); }

BoxRun run_with(const Config& config) { return BoxRun(config, 0.1, 384, 288); }

/// Contact `k` of three that move to the right, in its frame.
Box mover(int k, int frame) { return at(60.0 + 2.0 * frame, 60.0 + 80.0 * k); }

const Track* find(const TrackingResult& result, std::int64_t id) {
  for (const Track& track : result.tracks) {
    if (track.id == id) return &track;
  }
  return nullptr;
}

TEST(CountMedian, TheFirstCountFillsTheMedian) {
  BoxRun run = run_with(monitor_config());
  EXPECT_TRUE(run.frame({}).tracks.empty());
  EXPECT_EQ(ids_of(run.frame({mover(1, 0), mover(0, 0), mover(2, 0)})), (Ids{1, 2, 3}));
  // Ids go from top to bottom.
  EXPECT_LT(find(run.result(), 1)->position.y, find(run.result(), 2)->position.y);
  EXPECT_LT(find(run.result(), 2)->position.y, find(run.result(), 3)->position.y);
}

TEST(CountMedian, AContactEndsInTheFrameInWhich13OfThe25CountsAreLower) {
  BoxRun run = run_with(monitor_config());
  for (int frame = 0; frame < 30; ++frame) {
    EXPECT_EQ(ids_of(run.frame({mover(0, frame), mover(1, frame), mover(2, frame)})), (Ids{1, 2, 3}));
  }
  for (int miss = 1; miss <= 13; ++miss) {
    const TrackingResult& result = run.frame({mover(0, 29 + miss), mover(2, 29 + miss)});
    EXPECT_EQ(events_of(result), miss == 1 ? "track_lost 2" : miss == 13 ? "track_ended 2" : "") << miss;
    EXPECT_EQ(find(result, 2)->lost_frames, miss);
  }
  EXPECT_EQ(ids_of(run.frame({mover(0, 43), mover(2, 43)})), (Ids{1, 3}));
}

TEST(CountMedian, TheEndTellsWhereTheContactWasMeasuredLast) {
  BoxRun run = run_with(monitor_config(5));
  for (int frame = 0; frame < 10; ++frame) run.frame({mover(0, frame), mover(1, frame)});
  for (int miss = 1; miss <= 3; ++miss) run.frame({mover(0, 9 + miss)});
  ASSERT_EQ(events_of(run.result()), "track_ended 2");
  const Event& event = run.result().events.front();
  EXPECT_EQ(event.box, mover(1, 9));
  EXPECT_EQ(event.position, mover(1, 9).center());
  EXPECT_EQ(event.place, LostPlace::open);
  EXPECT_GT(event.position_covariance_px2.xx, 1.0);
}

TEST(CountMedian, AMissingContactOnlyPredicts) {
  BoxRun run = run_with(monitor_config());
  for (int frame = 0; frame < 60; ++frame) run.frame({mover(0, frame), mover(1, frame)});
  const double before = find(run.result(), 2)->position_covariance_px2.xx;
  for (int frame = 60; frame < 72; ++frame) run.frame({mover(0, frame)});
  const Track& missing = *find(run.result(), 2);
  EXPECT_EQ(missing.status, TrackStatus::lost);
  EXPECT_TRUE(missing.reported);
  // Fed with its own estimate it would be 22 px behind after 12 frames (errata).
  EXPECT_NEAR(missing.position.x, mover(1, 71).center().x, 1.0);
  EXPECT_GT(missing.position_covariance_px2.xx, 10.0 * before);
}

TEST(CountMedian, ANewcomerWaitsUntilTheMedianRises) {
  BoxRun run = run_with(monitor_config(5));
  for (int frame = 0; frame < 10; ++frame) run.frame({mover(0, frame)});
  EXPECT_EQ(ids_of(run.frame({mover(0, 10), mover(1, 10)})), (Ids{1}));
  EXPECT_EQ(ids_of(run.frame({mover(0, 11), mover(1, 11)})), (Ids{1}));
  EXPECT_EQ(ids_of(run.frame({mover(0, 12), mover(1, 12)})), (Ids{1, 2}));
}

TEST(CountMedian, ASpuriousBlobStealsNoFilter) {
  BoxRun run = run_with(monitor_config());
  for (int frame = 0; frame < 30; ++frame) run.frame({mover(0, frame), mover(1, frame)});
  run.frame({at(300.0, 20.0), mover(0, 30), mover(1, 30)});
  EXPECT_EQ(ids_of(run.result()), (Ids{1, 2}));
  EXPECT_NEAR(find(run.result(), 1)->position.y, mover(0, 30).center().y, 1.0);
  EXPECT_NEAR(find(run.result(), 2)->position.y, mover(1, 30).center().y, 1.0);
}

TEST(CountMedian, SeveralAreLostAndGainedAtOnce) {
  BoxRun run = run_with(monitor_config(5));
  for (int frame = 0; frame < 10; ++frame) run.frame({mover(0, frame), mover(1, frame), mover(2, frame)});
  for (int frame = 10; frame < 13; ++frame) run.frame({mover(1, frame)});
  EXPECT_EQ(events_of(run.result()), "track_ended 1, track_ended 3");
  for (int frame = 13; frame < 16; ++frame) run.frame({mover(0, frame), mover(1, frame), mover(2, frame)});
  EXPECT_EQ(events_of(run.result()), "track_started 4, track_started 5");
  EXPECT_EQ(ids_of(run.result()), (Ids{2, 4, 5}));
}

TEST(CountMedian, NoMoreThanSoManyContacts) {
  Config config = monitor_config(1);
  std::get<CountMedianOptions>(config.lifecycle).max_contacts = 2;
  BoxRun run = run_with(config);
  // The largest ones count.
  run.frame({Box{10, 10, 5, 5}, Box{100, 10, 30, 30}, Box{200, 200, 20, 20}});
  EXPECT_EQ(ids_of(run.result()), (Ids{1, 2}));
  EXPECT_EQ(find(run.result(), 1)->box, (Box{100, 10, 30, 30}));
  EXPECT_EQ(find(run.result(), 2)->box, (Box{200, 200, 20, 20}));
}

TEST(CountMedian, RowOrderSwapsContactsThatCrossAndNearestDoesNot) {
  for (const bool row_order : {true, false}) {
    Config config = monitor_config(5);
    if (row_order) config.assignment = RowOrderOptions{};
    BoxRun run = run_with(config);
    for (int frame = 0; frame < 40; ++frame) {
      run.frame({at(100.0, 80.0 + 3.0 * frame), at(250.0, 200.0 - 3.0 * frame)});
    }
    // The first came from above; in the end it is below.
    const double x = find(run.result(), 1)->position.x;
    EXPECT_NEAR(x, row_order ? 250.0 : 100.0, 40.0) << row_order;
  }
}

TEST(CountMedian, AKeptContactIsTakenForTheNextNewcomer) {
  Config config = monitor_config(1);
  config.lifecycle =
      CountMedianOptions{.median_frames = 1, .max_contacts = 1, .keep_contacts = true, .restart_after_s = 0.5};
  BoxRun run = run_with(config);
  for (int frame = 0; frame < 20; ++frame) run.frame({mover(0, frame)});
  for (int frame = 0; frame < 30; ++frame) {
    EXPECT_EQ(ids_of(run.frame({})), (Ids{1}));
    EXPECT_EQ(find(run.result(), 1)->status, TrackStatus::lost);
  }
  run.frame({at(40.0, 250.0)});
  EXPECT_EQ(ids_of(run.result()), (Ids{1}));
  EXPECT_EQ(events_of(run.result()), "track_recovered 1");
  // Away for longer than half a second: the filter starts anew where the contact is.
  EXPECT_NEAR(find(run.result(), 1)->position.x, 40.0, 1e-9);
  EXPECT_NEAR(find(run.result(), 1)->velocity_px_per_s.x, 0.0, 1e-9);
}

TEST(CountMedian, ResetForgetsTheCounts) {
  BoxRun run = run_with(monitor_config());
  for (int frame = 0; frame < 30; ++frame) run.frame({mover(0, frame), mover(1, frame)});
  run.tracker().reset();
  run.frame({mover(0, 0), mover(1, 0), mover(2, 0)});
  EXPECT_EQ(ids_of(run.result()), (Ids{1, 2, 3}));
}

}  // namespace
}  // namespace survtrack
