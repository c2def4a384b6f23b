// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#include <gtest/gtest.h>

#include <algorithm>
#include <opencv2/imgproc.hpp>

#include "../simd_levels.hpp"
#include "random_masks.hpp"
#include "survtrack/core/errors.hpp"
#include "survtrack/segmentation/cleanup.hpp"

namespace survtrack {
namespace {

constexpr MorphologyShape all_shapes[] = {MorphologyShape::square, MorphologyShape::cross, MorphologyShape::ellipse};

TileGrid equal_grid(int rows, int columns, const TileEdges& edges, MorphologyShape shape = MorphologyShape::square) {
  const int reach = edges.erode_px / 2 + edges.dilate_px / 2;
  return {rows, columns, reach, shape, std::vector<TileEdges>(static_cast<std::size_t>(rows * columns), edges)};
}

TileGrid published() { return {2, 2, 10, MorphologyShape::square, {{4, 11}, {4, 14}, {4, 14}, {4, 15}}}; }

bool same(const cv::Mat& a, const cv::Mat& b) { return a.size() == b.size() && cv::norm(a, b, cv::NORM_INF) == 0; }

cv::Mat tiled(const cv::Mat& mask, const TileGrid& grid) {
  cv::Mat result = mask.clone();
  tiled_morphology(result, grid);
  return result;
}

cv::Mat element(MorphologyShape shape, int edge) {
  const int kind = shape == MorphologyShape::square  ? cv::MORPH_RECT
                   : shape == MorphologyShape::cross ? cv::MORPH_CROSS
                                                     : cv::MORPH_ELLIPSE;
  return cv::getStructuringElement(kind, {edge, edge});
}

/// OpenCV's on the whole frame: its dilation does not reflect the element, so the element is reflected here.
cv::Mat reference(const cv::Mat& mask, const TileEdges& edges, MorphologyShape shape) {
  cv::Mat result = mask.clone();
  if (edges.erode_px > 1) cv::erode(result, result, element(shape, edges.erode_px));
  if (edges.dilate_px > 1) {
    cv::Mat reflected;
    cv::flip(element(shape, edges.dilate_px), reflected, -1);
    const int anchor = edges.dilate_px - 1 - edges.dilate_px / 2;
    cv::dilate(result, result, reflected, {anchor, anchor});
  }
  return result;
}

/// Cut out with the overlap, worked on alone, cut to its own part: the published way.
cv::Mat reference(const cv::Mat& mask, const TileGrid& grid) {
  cv::Mat result(mask.size(), CV_8UC1, cv::Scalar(77));
  for (int i = 0; i < grid.rows * grid.columns; ++i) {
    const int row = i / grid.columns, column = i % grid.columns;
    const cv::Point from(column * mask.cols / grid.columns, row * mask.rows / grid.rows);
    const cv::Point to((column + 1) * mask.cols / grid.columns, (row + 1) * mask.rows / grid.rows);
    const cv::Rect own(from, to);
    const cv::Point more(grid.overlap_px, grid.overlap_px);
    const cv::Rect read = cv::Rect(from - more, to + more) & cv::Rect({0, 0}, mask.size());
    const cv::Mat tile = reference(mask(read).clone(), grid.edges[static_cast<std::size_t>(i)], grid.shape);
    tile(own - read.tl()).copyTo(result(own));
  }
  return result;
}

class TiledMorphologyLevels : public AtEverySimdLevel {};

TEST_P(TiledMorphologyLevels, OneTileIsOpenCvs) {
  cv::RNG random(3);
  for (const MorphologyShape shape : all_shapes) {
    for (const TileEdges& edges : std::vector<TileEdges>{{0, 0}, {1, 1}, {2, 2}, {3, 3}, {4, 11}, {4, 14}, {4, 15}, {5, 0},
                                                         {0, 6}, {16, 21}, {7, 64}, {65, 66}, {2, 99}}) {
      TiledMorphology morphology(equal_grid(1, 1, edges, shape));  // one for all sizes
      for (const cv::Size size : {cv::Size(99, 99), {200, 130}, {128, 101}, {321, 100}}) {
        for (const int percent : {2, 50, 90, 99}) {
          const cv::Mat mask = random_mask(random, size, percent);
          cv::Mat larger(size.height + 5, size.width + 9, CV_8UC1, cv::Scalar(77));
          cv::Mat view = larger(cv::Rect({4, 2}, size));
          mask.copyTo(view);
          morphology.apply(view);
          ASSERT_TRUE(same(view, reference(mask, edges, shape)))
              << static_cast<int>(shape) << ", " << edges.erode_px << ", " << edges.dilate_px << ", " << size << ", " << percent;
          view.setTo(77);
          ASSERT_EQ(cv::countNonZero(larger != 77), 0) << "wrote beyond the mask";
        }
      }
    }
  }
}

TEST_P(TiledMorphologyLevels, TilesAreThePublishedWay) {
  cv::RNG random(5);
  for (int trial = 0; trial < 150; ++trial) {
    TileGrid grid{random.uniform(1, 6), random.uniform(1, 6), random.uniform(12, 20), all_shapes[trial % 3], {}};
    for (int i = 0; i < grid.rows * grid.columns; ++i) grid.edges.push_back({random.uniform(0, 10), random.uniform(0, 17)});
    const cv::Size size(random.uniform(16 * grid.columns, 300), random.uniform(16 * grid.rows, 200));
    const cv::Mat mask = random_mask(random, size, random.uniform(20, 95));
    ASSERT_TRUE(same(tiled(mask, grid), reference(mask, grid))) << trial << ": " << size;
  }
}

INSTANTIATE_TEST_SUITE_P(Levels, TiledMorphologyLevels, testing::ValuesIn(simd_levels()), simd_level_name);

TEST(TiledMorphology, EqualEdgesLeaveNoTraceOfTheCuts) {
  cv::RNG random(7);
  for (const MorphologyShape shape : all_shapes) {
    for (const cv::Size grid : {cv::Size(2, 2), {3, 1}, {1, 4}, {5, 3}, {7, 7}}) {
      for (const TileEdges& edges : std::vector<TileEdges>{{3, 3}, {4, 4}, {4, 14}, {5, 10}, {2, 1}}) {
        const cv::Mat mask = random_mask(random, {193, 131}, 70);
        const cv::Mat whole = tiled(mask, equal_grid(1, 1, edges, shape));
        EXPECT_TRUE(same(tiled(mask, equal_grid(grid.height, grid.width, edges, shape)), whole));
        // The same edges again, of tiles that are worked on one by one.
        TileGrid cut = equal_grid(grid.height, grid.width, edges, shape);
        cut.edges.back().erode_px = edges.erode_px + 1;
        cut.overlap_px += 1;
        cv::Mat difference = tiled(mask, cut) != whole;
        difference(cv::Rect((grid.width - 1) * 193 / grid.width, (grid.height - 1) * 131 / grid.height, 193, 131) &
                   cv::Rect(0, 0, 193, 131)).setTo(0);
        EXPECT_EQ(cv::countNonZero(difference), 0);
      }
    }
  }
}

TEST(TiledMorphology, EqualEdgesAreAnOpening) {
  cv::RNG random(9);
  for (const MorphologyShape shape : all_shapes) {
    for (const int edge : {2, 3, 4, 6, 11, 14}) {
      const cv::Mat mask = random_mask(random, {150, 90}, 75);
      const cv::Mat opened = tiled(mask, equal_grid(1, 1, {edge, edge}, shape));
      EXPECT_EQ(cv::countNonZero(opened & ~mask), 0) << "grew";
      EXPECT_TRUE(same(tiled(opened, equal_grid(1, 1, {edge, edge}, shape)), opened)) << "not idempotent";
    }
  }
}

/// The box after erosion by 4 and dilation as given.
cv::Rect box_after(int dilate_px) {
  cv::Mat mask = cv::Mat::zeros(100, 100, CV_8UC1);
  mask(cv::Rect(40, 30, 20, 30)).setTo(255);
  return cv::boundingRect(tiled(mask, equal_grid(1, 1, {4, dilate_px})));
}

TEST(TiledMorphology, EdgesOfUnlikeParityMoveByHalfAPixel) {
  EXPECT_EQ(box_after(14), cv::Rect(35, 25, 30, 40));  // 5 px to each side
  EXPECT_EQ(box_after(11), cv::Rect(37, 27, 27, 37));  // 3 px to the upper left, 4 px to the lower right
  EXPECT_EQ(box_after(15), cv::Rect(35, 25, 31, 41));  // 5 px and 6 px
}

TEST(TiledMorphology, ABlobOnAllQuadrantsStaysOne) {
  cv::RNG random(13);
  std::vector<cv::Rect> boxes = {{100, 80, 184, 128}, {186, 138, 12, 12}, {190, 20, 5, 248}, {0, 0, 384, 288}};
  for (int i = 0; i < 40; ++i) {
    const cv::Point from(random.uniform(2, 186), random.uniform(2, 138));
    boxes.emplace_back(from, cv::Point(random.uniform(198, 380), random.uniform(150, 286)));
  }
  for (const cv::Rect& box : boxes) {
    cv::Mat mask = cv::Mat::zeros(288, 384, CV_8UC1);
    mask(box).setTo(255);
    const cv::Mat result = tiled(mask, published());
    cv::Mat labels;
    EXPECT_EQ(cv::connectedComponents(result, labels, 8), 2) << box;
    // The outline of a box steps where a cut crosses it only.
    int step = 0;
    for (int y = box.y + 1; y < box.y + box.height; ++y) {
      const cv::Rect now = cv::boundingRect(result.row(y)), before = cv::boundingRect(result.row(y - 1));
      step = std::max({step, std::abs(now.x - before.x), std::abs(now.br().x - before.br().x)});
    }
    for (int x = box.x + 1; x < box.x + box.width; ++x) {
      const cv::Rect now = cv::boundingRect(result.col(x)), before = cv::boundingRect(result.col(x - 1));
      step = std::max({step, std::abs(now.y - before.y), std::abs(now.br().y - before.br().y)});
    }
    EXPECT_LE(step, 2) << box;
  }
}

TEST(TiledMorphology, BeyondTheFrameIsNeutral) {
  cv::Mat full(50, 70, CV_8UC1, cv::Scalar(255));
  EXPECT_TRUE(same(tiled(full, {2, 2, 20, MorphologyShape::square, {{20, 1}, {3, 1}, {4, 0}, {15, 0}}}), full));
  const cv::Mat empty = cv::Mat::zeros(50, 70, CV_8UC1);
  EXPECT_TRUE(same(tiled(empty, {2, 2, 20, MorphologyShape::cross, {{0, 20}, {0, 3}, {1, 4}, {1, 15}}}), empty));
}

template <class Error, class Work>
std::string message_of(const Work& work) {
  try {
    work();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(TiledMorphology, RefusesGridsThatCannotBe) {
  const auto refusal = [](const TileGrid& grid) { return message_of<ConfigError>([&] { TiledMorphology{grid}; }); };
  TileGrid grid = published();
  grid.overlap_px = 8;
  EXPECT_EQ(refusal(grid),
            "overlap_px: 8 is not allowed; expected at least 9, the reach of tile (row 1, column 2) with the edges 4 and "
            "14 px: floor(4 / 2) + floor(14 / 2)");
  grid = published();
  grid.edges.pop_back();
  EXPECT_EQ(refusal(grid), "edges: are 3; expected one pair a tile, 2x2");
  grid.rows = 0;
  EXPECT_EQ(refusal(grid), "rows: 0 is not allowed; expected between 1 and 1000");
  grid.rows = 1;
  grid.columns = 1001;
  EXPECT_EQ(refusal(grid), "columns: 1001 is not allowed; expected between 1 and 1000");
  grid = equal_grid(1, 2, {3, 3});
  grid.edges[1].dilate_px = -1;
  EXPECT_EQ(refusal(grid), "dilate_px of tile (row 1, column 2): -1 is not allowed; expected between 0 and 255");
  grid.overlap_px = -1;
  EXPECT_EQ(refusal(grid), "overlap_px: -1 is not allowed; expected between 0 and 510");
}

TEST(TiledMorphology, RefusesMasksTooSmallForTheGrid) {
  const auto refusal = [](const cv::Size& size, const TileGrid& grid) {
    return message_of<InputError>([&] {
      cv::Mat mask(size, CV_8UC1, cv::Scalar(9));
      try {
        tiled_morphology(mask, grid);
      } catch (...) {  // passed on: only the mask is looked at first
        EXPECT_EQ(cv::countNonZero(mask != 9), 0);
        throw;
      }
    });
  };
  EXPECT_EQ(refusal({40, 2}, equal_grid(3, 2, {0, 0})),
            "mask: is 2x40, smaller than the grid of 3x2 tiles; expected a pixel a tile at least");
  EXPECT_EQ(refusal({40, 27}, published()),
            "mask: is 27x40, which makes tile (row 1, column 2) 13x20 px; expected at least its edge of 14 px");
  EXPECT_EQ(refusal({40, 30}, published()), "");
  cv::Mat colour(40, 40, CV_8UC3, cv::Scalar::all(0));
  EXPECT_THROW(tiled_morphology(colour, published()), InputError);
}

TEST(Cleanup, QuadrantsAreThePublishedTiles) {
  cv::RNG random(17);
  const cv::Mat mask = random_mask(random, {385, 289}, 60);
  cv::Mat result = mask.clone();
  CleanupOptions options{.median_px = 0, .tiling = QuadrantsOptions{}};
  Cleanup(options).apply(result);
  EXPECT_TRUE(same(result, tiled(mask, published())));
  options.tiling = WholeFrameOptions{.erode_px = 4, .dilate_px = 14, .shape = MorphologyShape::ellipse};
  result = mask.clone();
  Cleanup(options).apply(result);
  EXPECT_TRUE(same(result, reference(mask, {4, 14}, MorphologyShape::ellipse)));
  options = {.median_px = 5, .open_px = 3, .close_px = 7, .tiling = QuadrantsOptions{}};
  cv::Mat steps = mask.clone();
  Cleanup({.median_px = 5, .open_px = 3, .close_px = 7}).apply(steps);
  result = mask.clone();
  Cleanup(options).apply(result);
  EXPECT_TRUE(same(result, tiled(steps, published()))) << "tiles come last";
  options.tiling = QuadrantsOptions{.overlap_px = 8};
  EXPECT_THROW(Cleanup{options}, ConfigError);
}

}  // namespace
}  // namespace survtrack
