#include "hydrology/lakes.h"

#include <gtest/gtest.h>

#include "hydrology/depressions.h"
#include "hydrology/random_terrains.h"
#include "hydrology/sea.h"

namespace orogen {
namespace {

const LakeParameters kAll{.least_lake_area = 0.0, .least_lake_depth = 0.0};

/// A plain of 100 m with a hollow of `depth`, 5 x 5 cells, whose way out is 2 m below the plain.
Raster<float> hollow(float depth) {
  Raster<float> ground(Grid{20, 20, 100.0}, 100.0f);
  for (int r = 8; r < 13; ++r)
    for (int c = 8; c < 13; ++c) ground(r, c) = 100.0f - depth;
  for (int c = 13; c < 20; ++c) ground(10, c) = 98.0f;
  return ground;
}

TEST(Lakes, StandAtTheirWayOut) {
  const Raster<float> ground = hollow(30.0f);
  const auto depth =
      lake_depth(ground, Raster<std::uint8_t>(ground.grid()), nullptr, {}, Context());
  EXPECT_EQ(depth(10, 10), 28.0f);
  EXPECT_EQ(depth(8, 12), 28.0f);
  EXPECT_EQ(depth(10, 13), 0.0f);
  EXPECT_EQ(depth(5, 5), 0.0f);
}

TEST(Lakes, AreLeftOutWhereSmallOrShallow) {
  const Raster<float> ground = hollow(5.0f);
  const Raster<std::uint8_t> none(ground.grid());
  EXPECT_EQ(lake_depth(ground, none, nullptr, {.least_lake_area = 0.24}, Context())(10, 10), 3.0f);
  EXPECT_EQ(lake_depth(ground, none, nullptr, {.least_lake_area = 0.26}, Context())(10, 10), 0.0f);
  EXPECT_EQ(lake_depth(ground, none, nullptr, {.least_lake_depth = 2.9}, Context())(10, 10), 3.0f);
  EXPECT_EQ(lake_depth(ground, none, nullptr, {.least_lake_depth = 3.1}, Context())(10, 10), 0.0f);
}

TEST(Lakes, StayWhereTheyWere) {
  const Raster<float> ground = hollow(30.0f);
  const Raster<std::uint8_t> none(ground.grid());
  Raster<float> before(ground.grid());
  EXPECT_EQ(lake_depth(ground, none, &before, {}, Context())(10, 10), 0.0f);
  EXPECT_EQ(lake_depth(ground, none, &before, {.new_lakes = true}, Context())(10, 10), 28.0f);
  before(9, 9) = 1.0f;
  EXPECT_EQ(lake_depth(ground, none, &before, {}, Context())(10, 10), 28.0f);
}

TEST(Lakes, TheSeaIsAWayOutAtItsLevel) {
  Raster<float> ground(Grid{12, 12, 100.0}, 20.0f);
  ground(6, 6) = -300.0f;  // sea floor
  ground(6, 7) = 4.0f;
  ground(6, 8) = 1.0f;
  Raster<std::uint8_t> sea(ground.grid());
  sea(6, 6) = 1;
  const auto depth = lake_depth(ground, sea, nullptr, kAll, Context());
  EXPECT_EQ(depth(6, 6), 0.0f);
  EXPECT_EQ(depth(6, 8), 3.0f);
}

/// On any ground: the level is that of another way of filling (priority flood), and each lake's
/// water is level with its neighbours'.
TEST(Lakes, FillHollowsAsPriorityFloodDoes) {
  for (int seed = 0; seed < 100; ++seed) {
    const Raster<float> ground = random_terrain(seed).elevation;
    const Grid& grid = ground.grid();
    const Raster<std::uint8_t> none(grid);
    Raster<std::uint8_t> sides(grid);
    for (int r = 0; r < grid.ny; ++r)
      for (int c = 0; c < grid.nx; ++c)
        sides(r, c) = r == 0 || c == 0 || r == grid.ny - 1 || c == grid.nx - 1;
    Raster<float> filled = ground;
    fill_depressions(filled, sides, 0.0, Context());
    const Raster<float> depth = lake_depth(ground, none, nullptr, kAll, Context());
    for (std::size_t i = 0; i < ground.size(); ++i)
      ASSERT_EQ(depth[i], filled[i] - ground[i]) << "seed " << seed << " cell " << i;
  }
}

TEST(Sea, HangsTogetherWithItsSeed) {
  Raster<float> ground(Grid{6, 4, 10.0}, 5.0f);
  for (const int c : {0, 1, 3, 5}) ground(1, c) = -1.0f;
  ground(2, 1) = 0.0f;
  Raster<std::uint8_t> seed(ground.grid());
  seed(1, 0) = seed(3, 3) = 1;
  const auto land = land_beside_sea(ground, seed);
  EXPECT_EQ(land(1, 0), 0);
  EXPECT_EQ(land(1, 1), 0);
  EXPECT_EQ(land(2, 1), 0);
  EXPECT_EQ(land(1, 3), 1);
  EXPECT_EQ(land(1, 5), 1);
  EXPECT_EQ(land(3, 3), 1);
}

}  // namespace
}  // namespace orogen
