#include "sculpting/sea_floor.h"

#include <gtest/gtest.h>

#include <cmath>

namespace orogen {
namespace {

struct Strip {  // land in the west, then sea
  Grid grid{400, 20, 200.0, {0.0, 0.0}};
  Raster<float> elevation{grid, 5.0f}, distance{grid};
  Raster<std::uint8_t> land{grid, 1};
  Context context;

  Strip() {
    for (int r = 0; r < grid.ny; ++r)
      for (int c = 10; c < grid.nx; ++c) {
        land(r, c) = 0;
        distance(r, c) = float((c - 9) * grid.cell_size);
      }
  }
};

TEST(SeaFloor, GoesDownFromCoastOverShelfToTheDeepAndLeavesLandAlone) {
  Strip s;
  const SeaFloorParameters p{.sea_floor_relief = 0.0};
  lay_sea_floor(s.elevation, s.land, s.distance, p, 1, s.context);
  for (int r = 0; r < s.grid.ny; ++r) {
    for (int c = 0; c < 10; ++c) EXPECT_EQ(s.elevation(r, c), 5.0f);
    EXPECT_LT(s.elevation(r, 10), 0.0f);
    EXPECT_GT(s.elevation(r, 10), -30.0f);
    EXPECT_NEAR(s.elevation(r, s.grid.nx - 1), -p.deep_depth, 1.0);
  }
}

TEST(SeaFloor, IsBelowZeroAndFiniteForAnySettings) {
  Strip s;
  for (double width : {100.0, 3e5})
    for (double depth : {1.0, 1000.0})
      for (double deep : {10.0, 11000.0}) {
        SeaFloorParameters p{width, depth, width, deep, 0.5};
        lay_sea_floor(s.elevation, s.land, s.distance, p, 7, s.context);
        for (int c = 10; c < s.grid.nx; ++c)
          EXPECT_TRUE(s.elevation(3, c) < 0.0f && std::isfinite(s.elevation(3, c)));
      }
}

TEST(SeaFloor, SeedMovesTheShelfEdgeAndNothingElseDoes) {
  Strip a, b, c;
  lay_sea_floor(a.elevation, a.land, a.distance, {}, 1, a.context);
  lay_sea_floor(b.elevation, b.land, b.distance, {}, 1, b.context);
  lay_sea_floor(c.elevation, c.land, c.distance, {}, 2, c.context);
  EXPECT_EQ(a.elevation, b.elevation);
  EXPECT_NE(a.elevation, c.elevation);
}

TEST(SeaFloor, RefusesParametersOutOfRange) {
  Strip s;
  EXPECT_THROW(lay_sea_floor(s.elevation, s.land, s.distance, {.shelf_width = 0.0}, 1, s.context),
               InputError);
}

}  // namespace
}  // namespace orogen
