// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include "survtrack/segmentation/read_plan.hpp"

#include <gtest/gtest.h>

#include <opencv2/core.hpp>
#include <random>

namespace survtrack {
namespace {

/// 1: read, 2: refreshed; a pixel in two spans would be counted twice.
cv::Mat picture_of(const ReadPlan& plan) {
  cv::Mat picture = cv::Mat::zeros(plan.size(), CV_8UC1);
  for (const ReadPlan::Band& band : plan.bands()) {
    for (int y = band.top; y < band.bottom; ++y) {
      int read = 0;
      for (std::size_t i = band.first_span; i < band.last_span; ++i) {
        const ReadPlan::Span& span = plan.spans()[i];
        EXPECT_LT(span.begin, span.end);
        EXPECT_GE(span.begin, read) << "from left to right, none twice";
        read = span.end;
        picture(cv::Rect(span.begin, y, span.end - span.begin, 1)).setTo(span.refresh ? 2 : 1);
      }
    }
  }
  return picture;
}

std::int64_t pieces_of(const ReadPlan& plan) {
  std::int64_t pieces = 0;
  for (const ReadPlan::Band& band : plan.bands()) {
    pieces += static_cast<std::int64_t>(band.last_span - band.first_span) * (band.bottom - band.top);
  }
  return pieces;
}

TEST(ReadPlan, IsTheUnionOfItsParts) {
  std::minstd_rand random(3);
  const auto below = [&](int end) { return static_cast<int>(random() % static_cast<unsigned>(end)); };
  for (int trial = 0; trial < 300; ++trial) {
    const cv::Size size(1 + below(40), 1 + below(30));
    ReadPlan plan;
    plan.clear(size);
    cv::Mat expected = cv::Mat::zeros(size, CV_8UC1);
    const int top = below(size.height), bottom = top + below(size.height - top + 1);
    if (trial % 3 != 0) {
      plan.refresh(top, bottom, 1.5);
      expected.rowRange(top, bottom).setTo(2);
    }
    for (int i = below(6); i > 0; --i) {
      const cv::Rect rect(below(50) - 5, below(40) - 5, below(20), below(20));
      plan.add(rect);
      const cv::Rect seen = rect & cv::Rect(cv::Point(), size);
      if (!seen.empty()) expected(seen).setTo(1);
    }
    plan.finish();
    EXPECT_EQ(cv::norm(picture_of(plan), expected, cv::NORM_INF), 0.0) << trial;
    EXPECT_EQ(plan.pixels(), cv::countNonZero(expected)) << trial;
    EXPECT_EQ(plan.whole(), cv::countNonZero(expected) == size.area()) << trial;
    EXPECT_EQ(plan.cost_px(), plan.pixels() + 64 * pieces_of(plan)) << trial;
  }
}

TEST(ReadPlan, OfAWholeFrameHasOneSpan) {
  ReadPlan plan;
  plan.read_whole({64, 48});
  EXPECT_TRUE(plan.whole());
  EXPECT_EQ(plan.pixels(), 64 * 48);
  EXPECT_EQ(plan.cost_px(), ReadPlan::whole_cost_px({64, 48}));
  ASSERT_EQ(plan.bands().size(), 1U);
  ASSERT_EQ(plan.spans().size(), 1U);
  plan.clear({64, 48});
  plan.finish();
  EXPECT_FALSE(plan.whole());
  EXPECT_EQ(plan.pixels(), 0);
  EXPECT_TRUE(plan.bands().empty());
}

}  // namespace
}  // namespace survtrack
