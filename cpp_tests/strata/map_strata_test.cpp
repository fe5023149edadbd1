#include "strata/map_strata.h"

#include <gtest/gtest.h>

#include <cmath>

#include "foundation/errors.h"
#include "strata/folded_block.h"

namespace orogen {
namespace {

struct Dome {
  Context context;
  StratigraphicColumn column = test::three_layers();
  Grid grid{120, 80, 500.0, {}};
  Raster<float> ground{grid};
  std::vector<Raster<float>> folds{3, Raster<float>(grid)};

  Dome() {
    for (int r = 0; r < grid.ny; ++r)
      for (int c = 0; c < grid.nx; ++c) {
        const glm::dvec2 d = grid.center(r, c) - glm::dvec2(30e3, 20e3);
        ground(r, c) = float(1500.0 * std::exp(-(d.x * d.x + d.y * d.y) / 1.6e8));
        folds[1](r, c) = float(300.0 * (1.0 + std::cos(d.x / 800.0)));
      }
  }
  HorizonStack horizons(const MapStrataParameters& p = {}) {
    return map_horizons(column, ground, folds, p, context);
  }
};

TEST(MapStrata, HorizonsKeepTheirOrderAndPlainsTheYoungestRock) {
  Dome dome;
  const HorizonStack stack = dome.horizons();
  const RockTable rocks(dome.column, {}, StrataPalette::Map);
  ASSERT_EQ(stack.layers(), 3);
  for (int k = 1; k <= 3; ++k)
    for (std::size_t i = 0; i < dome.grid.size(); ++i)
      ASSERT_GE(stack.heights[k][i], stack.heights[k - 1][i]);
  float h[4];
  stack.at({30e3, 20e3}, h);
  EXPECT_LT(rocks.rock_at(h, 1500.0f).layer, 3);  // the dome's top shows older rock
  EXPECT_GT(h[3], 1800.0f);
}

TEST(MapStrata, LayersThatDoNotFoldLieEven) {
  Dome dome;
  dome.folds.assign(3, Raster<float>(dome.grid));
  const HorizonStack stack = dome.horizons({.exhumation_share = 0.5, .smoothing = 4000.0});
  for (std::size_t i = 0; i < dome.grid.size(); ++i) {
    ASSERT_NEAR(stack.heights[3][i] - stack.heights[2][i], 500.0, 0.05);
    ASSERT_NEAR(stack.heights[1][i] - stack.heights[0][i], 600.0, 0.05);
  }
}

TEST(MapStrata, RefusesFoldsOfOtherLayersOrGrids) {
  Dome dome;
  dome.folds.pop_back();
  EXPECT_THROW(dome.horizons(), InputError);
  dome.folds.emplace_back(Grid{3, 3, 500.0, {}});
  EXPECT_THROW(dome.horizons(), InputError);
}

}  // namespace
}  // namespace orogen
