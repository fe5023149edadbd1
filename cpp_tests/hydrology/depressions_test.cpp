#include "hydrology/depressions.h"

#include <gtest/gtest.h>

#include <cmath>

#include "foundation/errors.h"
#include "hydrology/random_terrains.h"

namespace orogen {
namespace {

constexpr int kTerrains = 120;

TEST(FillDepressions, NoCellIsBelowItsWayOutAndNoneIsRaisedForNothing) {
  Context context;
  for (int t = 0; t < kTerrains; ++t) {
    SCOPED_TRACE(t);
    const RandomTerrain terrain = random_terrain(t);
    Raster<float> z = terrain.elevation;
    const MassBalance balance = fill_depressions(z, terrain.base, 0.0, context);
    double raised = 0.0;
    for (std::size_t i = 0; i < z.size(); ++i) {
      ASSERT_GE(z[i], terrain.elevation[i]);
      if (terrain.base[i]) {
        ASSERT_EQ(z[i], terrain.elevation[i]);
      }
      raised += double(z[i]) - terrain.elevation[i];
    }
    EXPECT_NEAR(balance.deposited_m3, raised * z.grid().cell_area(), 1e-12 * balance.deposited_m3);
    Raster<float> again = z;
    EXPECT_EQ(fill_depressions(again, terrain.base, 0.0, context).deposited_m3, 0.0);
    EXPECT_EQ(again, z);
  }
}

TEST(FillDepressions, WithEpsilonEveryCellHasALowerNeighbour) {
  Context context;
  for (int t = 0; t < kTerrains; ++t) {
    SCOPED_TRACE(t);
    const RandomTerrain terrain = random_terrain(t);
    const Grid& g = terrain.elevation.grid();
    Raster<float> z = terrain.elevation;
    fill_depressions(z, terrain.base, 1e-3, context);
    for (int r = 0; r < g.ny; ++r)
      for (int c = 0; c < g.nx; ++c) {
        if (terrain.base(r, c)) continue;
        bool lower = false;
        for (int dr = -1; dr <= 1; ++dr)
          for (int dc = -1; dc <= 1; ++dc)
            lower |= g.contains(r + dr, c + dc) && z(r + dr, c + dc) < z(r, c);
        ASSERT_TRUE(lower);
      }
  }
}

TEST(CarveToDrain, OnlyLowersAndWaterFallsEverywhere) {
  Context context;
  for (int t = 0; t < kTerrains; ++t)
    for (double slope : {0.0, 1e-4, 0.05}) {
      SCOPED_TRACE(t);
      const RandomTerrain terrain = random_terrain(t);
      FlowGraph flow(terrain.base);
      flow.route(terrain.elevation, context);
      Raster<float> z = terrain.elevation;
      const CarveResult result = carve_to_drain(z, flow, slope, context);
      double lowered = 0.0;
      std::size_t below = 0;
      for (std::size_t i = 0; i < z.size(); ++i) {
        ASSERT_LE(z[i], terrain.elevation[i]);
        lowered += double(terrain.elevation[i]) - z[i];
        if (terrain.base[i]) {
          ASSERT_EQ(z[i], terrain.elevation[i]);
          continue;
        }
        const std::int32_t to = flow.receiver(std::int32_t(i));
        if (z[i] >= z[to]) continue;
        ++below;  // only where the land itself lies below its base level
        ASSERT_TRUE(terrain.base[to]);
      }
      EXPECT_EQ(result.unresolved, below);
      EXPECT_NEAR(result.balance.eroded_m3, lowered * z.grid().cell_area(),
                  1e-12 * result.balance.eroded_m3);
    }
}

TEST(CarveToDrain, KeepsTheLeastSlopeAboveALowBase) {
  Context context;
  const Grid g{50, 40, 10.0, {}};
  Raster<float> z(g);
  Raster<std::uint8_t> base(g);
  for (std::size_t i = 0; i < z.size(); ++i) z[i] = 500.0f + 20.0f * float(random_uniform(4, 4, i));
  for (int c = 0; c < 50; ++c) {
    base(0, c) = 1;
    z(0, c) = 0.0f;
  }
  FlowGraph flow(base);
  flow.route(z, context);
  ASSERT_GT(flow.pit_count(), 100u);
  const CarveResult result = carve_to_drain(z, flow, 1e-3, context);
  EXPECT_EQ(result.unresolved, 0u);
  EXPECT_EQ(result.level, 0u);
  EXPECT_GT(result.deepest_cut_m, 0.0);
  for (std::int32_t i : flow.order())
    ASSERT_GE(z[i] - z[flow.receiver(i)], 0.99e-3 * flow.distance(i) - 1e-4);
}

TEST(CarveToDrain, LeavesKeptCellsAlone) {
  Context context;
  const RandomTerrain terrain = random_terrain(16);
  FlowGraph flow(terrain.base);
  flow.route(terrain.elevation, context);
  Raster<std::uint8_t> keep(flow.grid());
  for (std::size_t i = 0; i < keep.size(); i += 5) keep[i] = 1;
  Raster<float> z = terrain.elevation;
  carve_to_drain(z, flow, 1e-3, context, &keep);
  for (std::size_t i = 0; i < keep.size(); ++i)
    EXPECT_TRUE(!keep[i] || z[i] == terrain.elevation[i]);
}

TEST(Depressions, RefuseBadParameters) {
  Context context;
  RandomTerrain terrain = random_terrain(16);
  EXPECT_THROW(fill_depressions(terrain.elevation, terrain.base, -1.0, context), InputError);
  EXPECT_THROW(fill_depressions(terrain.elevation, terrain.base, NAN, context), InputError);
  EXPECT_THROW(carve_to_drain(terrain.elevation, terrain.base, 2.0, context), InputError);
}

}  // namespace
}  // namespace orogen
