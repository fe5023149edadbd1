#include "hydrology/river_beds.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "foundation/random.h"

namespace orogen {
namespace {

River river(Polyline points, int joins = -1) {
  River r;
  r.points = std::move(points);
  r.end = joins < 0 ? RiverEnd::Sea : RiverEnd::River;
  r.joins = joins;
  return r;
}

void expect_beds_are_a_forest(const RiverBeds& beds) {
  std::set<std::int32_t> laid;
  const int nx = beds.river.grid().nx;
  for (std::size_t i = 0; i < beds.cells.size(); ++i) {
    const std::int32_t c = beds.cells[i], r = beds.receivers[i];
    EXPECT_TRUE(laid.insert(c).second);
    if (r < 0) continue;
    EXPECT_TRUE(laid.count(r)) << "a bed flows to a bed laid before it";
    EXPECT_LE(std::abs(c / nx - r / nx), 1);
    EXPECT_LE(std::abs(c % nx - r % nx), 1);
  }
}

TEST(RiverBeds, TributaryFlowsIntoItsRiver) {
  const Grid grid{100, 60, 100.0, {0.0, 0.0}};
  Raster<std::uint8_t> land(grid, 1);
  VectorMap map;
  map.rivers = {river({{5050, 5000}, {5050, 2050}}, 1), river({{9950, 2050}, {50, 2050}})};
  const RiverBeds beds = lay_river_beds(map, land, 0.0, 1000.0, 1);
  expect_beds_are_a_forest(beds);
  EXPECT_EQ(beds.river(20, 50), 2) << "the junction belongs to the river that is joined";
  EXPECT_EQ(beds.river(30, 50), 1);
  const auto forced = forced_receivers(beds);
  EXPECT_EQ(forced[grid.index(21, 50)], std::int32_t(grid.index(20, 50)));
  EXPECT_EQ(forced[grid.index(20, 50)], std::int32_t(grid.index(20, 49)));
  EXPECT_EQ(forced[grid.index(20, 0)], -1);
}

TEST(RiverBeds, LengthAboveACellIsTheLongestBed) {
  const Grid grid{100, 60, 100.0, {0.0, 0.0}};
  Raster<std::uint8_t> land(grid, 1);
  VectorMap map;
  map.rivers = {river({{9950, 2050}, {50, 2050}}), river({{5050, 2500}, {5050, 2050}}, 0)};
  const RiverBeds beds = lay_river_beds(map, land, 0.0, 1000.0, 1);
  EXPECT_FLOAT_EQ(beds.source_length.front(), 9900.0f);
}

TEST(RiverBeds, BedsAreOnLandAndFormAForestOverRandomMaps) {
  for (int seed = 0; seed < 100; ++seed) {
    const auto u = [&](int k) { return random_uniform(seed, 0, k); };
    const Grid grid{1 + int(80 * u(0)), 1 + int(80 * u(1)), 50.0 + 300.0 * u(2), {-500.0, 900.0}};
    Raster<std::uint8_t> land(grid);
    for (std::size_t i = 0; i < land.size(); ++i) land[i] = random_uniform(seed, 1, i / 37) < 0.8;
    VectorMap map;
    for (int k = 0; k < 8; ++k) {
      Polyline line;
      for (int j = 0; j < 5; ++j)
        line.push_back(grid.origin + glm::dvec2(grid.width() * u(100 + 20 * k + j),
                                                grid.height() * u(110 + 20 * k + j)));
      map.rivers.push_back(river(line, k ? int(u(3 + k) * k) : -1));
    }
    const RiverBeds beds = lay_river_beds(map, land, 150.0, 2000.0, seed);
    expect_beds_are_a_forest(beds);
    for (const auto c : beds.cells) EXPECT_TRUE(land[c]);
  }
}

TEST(RiverBeds, WanderIsBoundedAndSameAtEveryResolution) {
  VectorMap map;
  map.rivers = {river({{9000, 500}, {6000, 4000}, {500, 5000}})};
  const auto mean_row = [&](int n, double wander) {
    const Grid grid{n, n, 10000.0 / n, {0.0, 0.0}};
    const RiverBeds beds = lay_river_beds(map, Raster<std::uint8_t>(grid, 1), wander, 1500.0, 3);
    std::vector<double> row(100, 0.0), count(100, 0.0);
    for (const auto c : beds.cells) {
      const auto at = std::size_t(100.0 * (c % n + 0.5) / n);
      row[at] += (c / n + 0.5) * grid.cell_size, count[at] += 1.0;
    }
    for (int i = 0; i < 100; ++i) row[i] = count[i] ? row[i] / count[i] : -1.0;
    return row;
  };
  const auto coarse = mean_row(200, 120.0), fine = mean_row(400, 120.0), none = mean_row(400, 0.0);
  double moved = 0.0;
  for (int i = 0; i < 100; ++i) {
    if (coarse[i] < 0.0 || fine[i] < 0.0 || none[i] < 0.0) continue;
    EXPECT_NEAR(coarse[i], fine[i], 110.0);
    moved = std::max(moved, std::abs(fine[i] - none[i]));
  }
  EXPECT_GT(moved, 25.0);
  EXPECT_LT(moved, 450.0);
}

TEST(RiverBeds, YieldToAPeakAndKeepTheirOwnBends) {
  VectorMap map;
  map.rivers = {river({{500, 5000}, {9500, 5000}})};
  Peak peak;
  peak.position = {5000, 5030};
  map.peaks = {peak};
  const Grid grid{500, 500, 20.0, {0.0, 0.0}};
  const auto farthest = [&](double wander) {
    const RiverBeds beds = lay_river_beds(map, Raster<std::uint8_t>(grid, 1), wander, 1500.0, 3);
    double nearest = 1e9, off = 0.0;
    for (const auto c : beds.cells) {
      const glm::dvec2 d = grid.center(c / grid.nx, c % grid.nx) - peak.position;
      nearest = std::min(nearest, std::hypot(d.x, d.y));
      off = std::max(off, std::abs(d.y + 30.0));
    }
    return std::pair{nearest, off};
  };
  const auto [nearest, off] = farthest(0.0);
  EXPECT_GT(nearest, 90.0);
  EXPECT_LT(off, 110.0);
  map.peaks.clear();
  const double long_pieces = farthest(300.0).second;
  Polyline dense;
  for (double x = 500; x <= 9500; x += 100) dense.push_back({x, 5000});
  map.rivers[0].points = dense;
  EXPECT_LT(farthest(300.0).second, 0.2 * long_pieces);
}

}  // namespace
}  // namespace orogen
