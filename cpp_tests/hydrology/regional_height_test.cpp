#include "hydrology/regional_height.h"

#include <gtest/gtest.h>

#include "support_island.h"

namespace orogen {
namespace {

TEST(RegionalHeight, RisesFromTheCoastAlongRiversAndTowardsPeaks) {
  Context context;
  for (int seed = 0; seed < 20; ++seed) {
    const VectorMap map = test::island(seed);
    const Grid grid = test::island_grid(map, 96);
    const auto land = test::island_land(map, grid);
    const RiverBeds beds = lay_river_beds(map, land, 0.0, 1e3, 1);
    const auto height = regional_height(map, land, beds, context);
    double highest = 0.0;
    for (const Peak& peak : map.peaks) highest = std::max(highest, *peak.height_m);
    for (std::size_t i = 0; i < land.size(); ++i) {
      EXPECT_TRUE(std::isfinite(height[i]));
      if (!land[i]) {
        EXPECT_EQ(height[i], 0.0f);
      } else {
        EXPECT_GE(height[i], 0.0f);
        EXPECT_LT(height[i], highest + 500.0);
      }
    }
    for (std::size_t i = 0; i < beds.cells.size(); ++i)
      if (beds.receivers[i] >= 0) {
        EXPECT_GE(height[beds.cells[i]], height[beds.receivers[i]] - 1e-3f);
      }
  }
}

TEST(RegionalHeight, MembraneBetweenTwoParallelBedsHasTheSlopeBetweenThem) {
  // An open frame, equal beds along its western and eastern side, the eastern 100 m higher all
  // along: the part of the surface that is odd about the middle is a straight slope of 100 m.
  Context context;
  VectorMap map;
  map.frame = {{0, 0}, {6400, 6400}, ""};
  for (const double x : {50.0, 6350.0}) {
    River river;
    river.points = {{x, 6350.0}, {x, 50.0}};
    river.end = RiverEnd::Frame;
    river.end_height_m = x < 100 ? 0.0 : 100.0;
    map.rivers.push_back(river);
  }
  const Grid grid = grid_over(map.frame.origin, map.frame.size, 64);
  const Raster<std::uint8_t> land(grid, 1);
  const RiverBeds beds = lay_river_beds(map, land, 0.0, 1e3, 1);
  const auto height = regional_height(map, land, beds, context);
  for (int r = 0; r < 64; ++r)
    for (int c = 0; c < 64; ++c)
      EXPECT_NEAR(height(r, c) - height(r, 63 - c), 100.0 * (2 * c - 63) / 63.0, 0.5);
}

TEST(RegionalHeight, WorksOnTheSmallestGrids) {
  Context context;
  VectorMap map;
  map.frame = {{0, 0}, {1000, 1000}, ""};
  for (const auto& [nx, ny] : {std::pair{1, 1}, {1, 5}, {3, 2}}) {
    const Grid grid{nx, ny, 200.0, {0, 0}};
    const Raster<std::uint8_t> land(grid, 1);
    const auto height = regional_height(map, land, lay_river_beds(map, land, 0.0, 1e3, 1), context);
    for (const float z : height.values()) EXPECT_TRUE(std::isfinite(z));
  }
}

}  // namespace
}  // namespace orogen
