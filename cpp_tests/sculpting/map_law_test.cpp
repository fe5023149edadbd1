#include "sculpting/map_law.h"

#include <gtest/gtest.h>

#include "foundation/disc.h"
#include "hydrology/base_level.h"
#include "hydrology/depressions.h"
#include "support_island.h"

namespace orogen {
namespace {

struct Ruled {
  VectorMap map;
  Grid grid;
  Raster<std::uint8_t> land;
  RiverBeds beds;
  Raster<float> elevation;
  MapLawResult result;
};

Ruled rule(int seed, int n, const MapLawParameters& parameters = {}) {
  Context context;
  Ruled t;
  t.map = test::island(seed);
  t.grid = test::island_grid(t.map, n);
  t.land = test::island_land(t.map, t.grid);
  t.beds = lay_river_beds(t.map, t.land, 60.0, 2000.0, seed);
  const auto rough = fbm({.seed = std::uint32_t(seed), .wavelength = 6000.0}, t.grid, context);
  t.elevation = Raster<float>(t.grid);
  for (std::size_t i = 0; i < t.elevation.size(); ++i)
    t.elevation[i] = t.land[i] ? 500.0f + 300.0f * rough[i] : -20.0f;
  t.result = enforce_map(t.elevation, t.map, t.land, t.beds, parameters, context);
  return t;
}

class MapLaw : public testing::TestWithParam<int> {};

TEST_P(MapLaw, PeaksHaveTheirHeightAndAreSummits) {
  const Ruled t = rule(GetParam(), 160);
  EXPECT_LT(t.result.largest_peak_error_m, 0.1);
  for (const Peak& peak : t.map.peaks) {
    const int r = t.grid.row_of(peak.position.y), c = t.grid.column_of(peak.position.x);
    EXPECT_NEAR(t.elevation(r, c), *peak.height_m, 0.1);
    for (int dr = -1; dr <= 1; ++dr)
      for (int dc = -1; dc <= 1; ++dc)
        if (dr || dc) {
          EXPECT_LT(t.elevation(r + dr, c + dc), t.elevation(r, c));
        }
  }
}

TEST_P(MapLaw, NothingUnnamedStandsHigherThanItsNamedNeighbour) {
  const Ruled t = rule(GetParam(), 160);
  for (int r = 1; r + 1 < t.grid.ny; ++r)
    for (int c = 1; c + 1 < t.grid.nx; ++c) {
      if (!t.land(r, c)) continue;
      const Peak* nearest = nullptr;
      double distance = 5000.0;
      for (const Peak& peak : t.map.peaks) {
        const glm::dvec2 d = peak.position - t.grid.center(r, c);
        if (std::hypot(d.x, d.y) < distance) distance = std::hypot(d.x, d.y), nearest = &peak;
      }
      if (!nearest || distance < 1.5 * t.grid.cell_size) continue;
      bool summit = true;
      for (int dr = -1; dr <= 1; ++dr)
        for (int dc = -1; dc <= 1; ++dc)
          if (dr || dc) summit &= t.elevation(r, c) > t.elevation(r + dr, c + dc);
      if (summit) {
        EXPECT_LE(t.elevation(r, c), *nearest->height_m);
      }
    }
}

TEST_P(MapLaw, WaterReachesTheSeaAndRiversFall) {
  const Ruled t = rule(GetParam(), 160);
  Context context;
  const BaseLevel base = base_level(t.map, t.land, t.beds);
  Raster<float> filled = t.elevation;
  fill_depressions(filled, base.cells, 0.0, context);
  std::size_t deep = 0;
  for (std::size_t i = 0; i < filled.size(); ++i) deep += filled[i] > t.elevation[i] + 1.0f;
  EXPECT_EQ(deep, 0u);
  for (std::size_t i = 0; i < t.beds.cells.size(); ++i)
    if (t.beds.receivers[i] >= 0) {
      EXPECT_LE(t.elevation[t.beds.receivers[i]], t.elevation[t.beds.cells[i]] + 1e-3f);
    }
  for (std::size_t i = 0; i < t.land.size(); ++i)
    if (t.land[i]) {
      EXPECT_GT(t.elevation[i], 0.0f);
    }
}

INSTANTIATE_TEST_SUITE_P(Islands, MapLaw, testing::Range(0, 12));

TEST(MapLaw, LeavesFarGroundAsItIs) {
  Context context;
  VectorMap map;
  map.frame = {{0, 0}, {40e3, 40e3}, ""};
  Peak peak;
  peak.position = {8050.0, 8050.0};
  peak.height_m = 1000.0;
  map.peaks = {peak};
  const Grid grid = grid_over(map.frame.origin, map.frame.size, 200);
  const Raster<std::uint8_t> land(grid, 1);
  Raster<float> elevation(grid);
  for (int r = 0; r < grid.ny; ++r)
    for (int c = 0; c < grid.nx; ++c) elevation(r, c) = float(2.0 * std::min(r, c));
  const auto before = elevation;
  enforce_map(elevation, map, land, lay_river_beds(map, land, 0.0, 1e3, 1), {}, context);
  for (int r = 120; r < grid.ny - 1; ++r)
    for (int c = 120; c < grid.nx - 1; ++c) EXPECT_EQ(elevation(r, c), before(r, c));
}

TEST(MapLaw, WorksWithoutPeaksRiversOrHeights) {
  Context context;
  VectorMap map;
  map.frame = {{0, 0}, {1000, 1000}, ""};
  Peak nameless;
  nameless.position = {500, 500};
  map.peaks = {nameless};
  for (const auto& [nx, ny] : {std::pair{1, 1}, {1, 7}, {5, 3}}) {
    const Grid grid{nx, ny, 100.0, {0, 0}};
    const Raster<std::uint8_t> land(grid, 1);
    Raster<float> elevation(grid, 3.0f);
    const auto result =
        enforce_map(elevation, map, land, lay_river_beds(map, land, 0.0, 1e3, 1), {}, context);
    EXPECT_EQ(result.peaks_met, 0);
  }
}

}  // namespace
}  // namespace orogen
