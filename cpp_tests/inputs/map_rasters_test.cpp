#include "inputs/map_rasters.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <numbers>

#include "inputs/test_maps.h"

namespace orogen {
namespace {

using test::Dice;

/// Even-odd by the slow rule, one point against every edge.
bool inside(const std::vector<const Ring*>& rings, glm::dvec2 p) {
  bool result = false;
  for (const Ring* ring : rings)
    for (std::size_t i = 0; i < ring->size(); ++i) {
      glm::dvec2 a = (*ring)[i], b = (*ring)[(i + 1) % ring->size()];
      if (a.y > b.y) std::swap(a, b);
      if (!(a.y < p.y && p.y <= b.y)) continue;
      if (a.x + (p.y - a.y) * (b.x - a.x) / (b.y - a.y) < p.x) result = !result;
    }
  return result;
}

Ring random_ring(Dice& dice, int n, glm::dvec2 centre, double radius, bool on_centres) {
  Ring ring;
  for (int i = 0; i < n; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / n;
    const double r = radius * dice.uniform(0.2, 1.0);
    glm::dvec2 p = centre + r * glm::dvec2(std::cos(angle), std::sin(angle));
    if (on_centres) p = glm::floor(p / 10.0) * 10.0 + 5.0;  // exactly on centres of 10 m cells
    ring.push_back(p);
  }
  return ring;
}

TEST(LandMask, EqualsTheSlowRuleOnRandomMaps) {
  const Context context;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    Dice dice(seed);
    const int sizes[] = {1, 2, 7, 31, 64};
    const Grid grid{sizes[dice.below(5)],
                    sizes[dice.below(5)],
                    10.0,
                    {dice.below(2) * 100.0, dice.uniform(-50.0, 50.0)}};
    VectorMap map;
    std::vector<const Ring*> rings;
    const int coasts = 1 + dice.below(3);
    for (int k = 0; k < coasts; ++k) {
      const glm::dvec2 centre = grid.origin + glm::dvec2(grid.width() * dice.uniform(0.0, 1.0),
                                                         grid.height() * dice.uniform(0.0, 1.0));
      const double radius = dice.uniform(5.0, 400.0);
      Coast coast;
      coast.outer = random_ring(dice, 3 + dice.below(40), centre, radius, dice.below(2));
      if (dice.below(2)) coast.holes.push_back(random_ring(dice, 8, centre, radius / 5.0, false));
      map.coasts.push_back(coast);
    }
    for (const Coast& coast : map.coasts) {
      rings.push_back(&coast.outer);
      for (const Ring& hole : coast.holes) rings.push_back(&hole);
    }
    const auto land = land_mask(map, grid, context);
    for (int r = 0; r < grid.ny; ++r)
      for (int c = 0; c < grid.nx; ++c)
        ASSERT_EQ(land(r, c), inside(rings, grid.center(r, c))) << seed << " " << r << " " << c;
  }
}

TEST(LandMask, NeighboursShareNoCellAndLeaveNone) {
  // Two triangles of a square whose diagonal runs through cell centres.
  VectorMap a, b;
  a.coasts.push_back({{{0, 0}, {100, 0}, {100, 100}}, {}, false, "", -1});
  b.coasts.push_back({{{0, 0}, {100, 100}, {0, 100}}, {}, false, "", -1});
  const Grid grid{10, 10, 10.0, {0.0, 0.0}};
  const Context context;
  const auto first = land_mask(a, grid, context), second = land_mask(b, grid, context);
  for (std::size_t i = 0; i < grid.size(); ++i) EXPECT_EQ(first[i] + second[i], 1);
}

TEST(LandMask, IsAllLandWithoutCoasts) {
  const Grid grid{5, 3, 10.0, {0.0, 0.0}};
  const Context context;
  EXPECT_EQ(land_mask({}, grid, context), Raster<std::uint8_t>(grid, 1));
}

TEST(LandMask, DoesNotDependOnThreads) {
  Dice dice(5);
  VectorMap map;
  map.coasts.push_back({random_ring(dice, 5000, {0, 0}, 1000.0, false), {}, false, "", -1});
  const Grid grid{301, 199, 7.0, {-1000.0, -700.0}};
  Raster<std::uint8_t> one, four;
  Context first({}, 1), second({}, 4);
  first.run([&] { one = land_mask(map, grid, first); });
  second.run([&] { four = land_mask(map, grid, second); });
  EXPECT_EQ(one, four);
}

TEST(LakeMask, NumbersLakesAndLeavesIslandsOut) {
  VectorMap map;
  map.lakes.push_back({{{0, 0}, {50, 0}, {50, 50}, {0, 50}},
                       {{{20, 20}, {20, 30}, {30, 30}, {30, 20}}},
                       {},
                       "",
                       -1});
  map.lakes.push_back({{{60, 60}, {90, 60}, {90, 90}, {60, 90}}, {}, {}, "", -1});
  const Grid grid{10, 10, 10.0, {0.0, 0.0}};
  const Context context;
  const auto lakes = lake_mask(map, grid, context);
  EXPECT_EQ(lakes(0, 0), 1);
  EXPECT_EQ(lakes(2, 2), 0);
  EXPECT_EQ(lakes(6, 6), 2);
  EXPECT_EQ(std::count(lakes.values().begin(), lakes.values().end(), 1), 24);
  EXPECT_EQ(std::count(lakes.values().begin(), lakes.values().end(), 2), 9);
}

TEST(OpenSides, AreLandOnTheBorder) {
  const Grid grid{4, 3, 10.0, {0.0, 0.0}};
  Raster<std::uint8_t> land(grid, 0);
  land(0, 1) = land(1, 1) = land(1, 3) = 1;
  const auto open = open_sides({}, grid, land);
  EXPECT_EQ(open(0, 1), 1);
  EXPECT_EQ(open(1, 3), 1);
  EXPECT_EQ(open(1, 1), 0);  // inside the grid
  EXPECT_EQ(open(2, 0), 0);  // sea
}

TEST(OpenSides, OfAClippedCoastReachTheLastRowOfAnyGrid) {
  const std::string coast =
      test::feature(R"("kind": "coast", "clipped": true)", "Polygon",
                    "[[[0,0],[40,0],[45,12],[38,30],[50,41],[55,70],[0,70],[0,0]]]");
  const VectorMap map = read_geojson(test::collection(
      coast, R"("units": "km", "frame": {"origin_m": [1000, -2000], "size_km": [100, 70]},)"));
  const Context context;
  for (const int resolution : {9, 16, 23, 64, 97, 100, 333}) {
    const Grid grid = grid_for(map, resolution);
    const auto land = land_mask(map, grid, context);
    for (int r = 0; r < grid.ny; ++r) EXPECT_EQ(land(r, 0), 1) << resolution;
    EXPECT_EQ(land(0, 0), 1);
    EXPECT_EQ(land(grid.ny - 1, 0), 1) << resolution;
    EXPECT_EQ(land(grid.ny / 2, grid.nx - 1), 0);
  }
  ASSERT_EQ(shorelines(map).size(), 1u);
  EXPECT_EQ(shorelines(map)[0].size(), 5u);
}

TEST(RasteriseLine, IsAConnectedChainWithoutRepeats) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    Dice dice(seed);
    const Grid grid{1 + dice.below(60), 1 + dice.below(60), dice.uniform(1.0, 50.0), {-300.0, 7.0}};
    Polyline line;
    for (int k = 1 + dice.below(12); k-- > 0;)
      line.push_back(grid.origin + glm::dvec2(dice.uniform(0.0, 0.999) * grid.width(),
                                              dice.uniform(0.0, 0.999) * grid.height()));
    const auto cells = rasterise_line(grid, line);
    ASSERT_FALSE(cells.empty());
    EXPECT_EQ(cells.front(),
              grid.index(grid.row_of(line.front().y), grid.column_of(line.front().x)));
    EXPECT_EQ(cells.back(), grid.index(grid.row_of(line.back().y), grid.column_of(line.back().x)));
    auto sorted = cells;
    std::sort(sorted.begin(), sorted.end());
    EXPECT_EQ(std::adjacent_find(sorted.begin(), sorted.end()), sorted.end());
    for (std::size_t k = 0; k + 1 < cells.size(); ++k) {
      EXPECT_LE(std::abs(int(cells[k] / grid.nx) - int(cells[k + 1] / grid.nx)), 1);
      EXPECT_LE(std::abs(int(cells[k] % grid.nx) - int(cells[k + 1] % grid.nx)), 1);
    }
  }
}

TEST(RasteriseLine, LeavesOutWhatLiesOutside) {
  const Grid grid{10, 10, 1.0, {0.0, 0.0}};
  EXPECT_TRUE(rasterise_line(grid, {{-5, -5}, {-1, 30}}).empty());
  EXPECT_TRUE(rasterise_line(grid, {}).empty());
  const auto across = rasterise_line(grid, {{-1e7, 5.5}, {1e7, 5.5}});
  ASSERT_EQ(across.size(), 10u);
  EXPECT_EQ(across.front(), grid.index(5, 0));
  EXPECT_EQ(across.back(), grid.index(5, 9));
}

TEST(GridFor, RefusesNonsense) {
  EXPECT_THROW(grid_for({}, 0), InputError);
  EXPECT_THROW(grid_for({}, 1 << 20), InputError);
}

}  // namespace
}  // namespace orogen
