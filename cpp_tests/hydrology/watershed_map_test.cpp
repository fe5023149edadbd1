#include "hydrology/watershed_map.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "foundation/distance_transform.h"
#include "foundation/errors.h"
#include "foundation/noise.h"
#include "foundation/random.h"
#include "hydrology/lower_envelope.h"

namespace orogen {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

// The envelope by trying every source at every cell, in double.
double slow_envelope(const Raster<float>& sources, int r, int c, const Hillside& h) {
  const Grid& g = sources.grid();
  double best = kInfinity;
  for (int sr = 0; sr < g.ny; ++sr)
    for (int sc = 0; sc < g.nx; ++sc) {
      if (sources(sr, sc) == kInfinity) continue;
      const double d = g.cell_size * std::hypot(r - sr, c - sc);
      double n = 1.0;
      if (h.steepness && d > 0.0) {
        n = 0.0;
        for (int k = 0; k < 32; ++k) {  // the mean on the straight line, by many places
          const double t = (k + 0.5) / 32;
          n += (*h.steepness)(int(sr + t * (r - sr) + 0.5), int(sc + t * (c - sc) + 0.5)) / 32;
        }
      }
      const double rise = d > 0.0 ? h.slope * n * d * d / (d + h.floor_width) : 0.0;
      best = std::min(best, sources(sr, sc) + rise);
    }
  return best;
}

// Sources strewn at random, with random heights: the worst case.
TEST(LowerEnvelope, StaysWithinEightPercentOnStrewnSources) {
  const Context context;
  for (int seed = 0; seed < 60; ++seed) {
    const int sizes[] = {1, 2, 13, 41, 60};
    const Grid grid{sizes[seed % 5], sizes[seed / 5 % 5], 100.0, {0.0, 0.0}};
    Raster<float> sources(grid, kInfinity), steepness(grid);
    Raster<std::uint8_t> domain(grid, 1), mask(grid);
    for (std::size_t i = 0; i < grid.size(); ++i)
      if (random_uniform(seed, 0, i) < 0.02 || i == grid.size() / 2)
        sources[i] = float(300.0 * random_uniform(seed, 1, i)), mask[i] = 1;
    for (int r = 0; r < grid.ny; ++r)
      for (int c = 0; c < grid.nx; ++c)
        steepness(r, c) = 2.0f + std::sin(0.05f * r) * std::cos(0.04f * c);
    for (const Hillside& h :
         {Hillside{0.15, 0.0}, Hillside{0.15, 400.0}, Hillside{0.15, 200.0, &steepness, 2500.0}}) {
      auto source = nearest_feature(mask, context).nearest;
      const auto z = lower_envelope(sources, domain, source, h, context);
      for (int r = 0; r < grid.ny; ++r)
        for (int c = 0; c < grid.nx; ++c) {
          const double expected = slow_envelope(sources, r, c, h);
          ASSERT_GE(z(r, c), 0.97 * expected - 1e-3) << seed << " " << r << " " << c;
          ASSERT_LE(z(r, c), 1.08 * expected + 0.5 * h.slope * grid.cell_size)
              << seed << " " << r << " " << c;
        }
    }
  }
}

struct Case {
  VectorMap map;
  Raster<std::uint8_t> land;
  Raster<float> peak_distance;
  RiverBeds beds;
};

// An island with a ragged coast, peaks, rivers that join, at any resolution.
Case island(std::uint32_t seed, int resolution) {
  Case c;
  const Context context;
  const Grid grid = grid_over({0.0, 0.0}, glm::dvec2(60e3), resolution);
  c.map.frame.size = glm::dvec2(60e3);
  const auto noise = fbm({.seed = seed, .wavelength = 25e3, .octaves = 5}, grid, context);
  c.land = Raster<std::uint8_t>(grid);
  for (int r = 0; r < grid.ny; ++r)
    for (int k = 0; k < grid.nx; ++k) {
      const glm::dvec2 d = (grid.center(r, k) - glm::dvec2(30e3)) / 24e3;
      c.land(r, k) = std::hypot(d.x, d.y) + 0.1 * noise(r, k) < 1.0;
    }
  std::vector<glm::dvec2> peaks;
  for (int i = 0; i < 6; ++i) {
    c.map.peaks.push_back({});
    c.map.peaks.back().position = {22e3 + 16e3 * random_uniform(seed, 1, i),
                                   22e3 + 16e3 * random_uniform(seed, 2, i)};
    c.map.peaks.back().height_m = 800.0 + 1500.0 * random_uniform(seed, 3, i);
    peaks.push_back(c.map.peaks.back().position);
  }
  for (int i = 0; i < 4; ++i) {
    const double angle = 1.6 * i + random_uniform(seed, 4, i);
    const glm::dvec2 way{std::cos(angle), std::sin(angle)}, aside{-way.y, way.x};
    River river;
    for (int k = 0; k <= 20; ++k)
      river.points.push_back(glm::dvec2(30e3) + (4e3 + 1.4e3 * k) * way +
                             1e3 * std::sin(0.8 * k + seed) * aside);
    c.map.rivers.push_back(river);
    River joining;
    joining.end = RiverEnd::River;
    joining.joins = 2 * i;
    joining.points = {river.points[6] + 5e3 * aside - 2e3 * way, river.points[10]};
    c.map.rivers.push_back(joining);
  }
  c.peak_distance = nearest_point(peaks, grid, context).distance;
  c.beds = lay_river_beds(c.map, c.land, 0.0, 1e3, seed);
  return c;
}

// Cells from which water, going down from cell to cell, reaches the sea.
std::size_t count_drained(const Raster<float>& z, const Raster<std::uint8_t>& land) {
  const Grid& g = z.grid();
  std::vector<char> wet(g.size());
  std::vector<std::size_t> todo;
  for (std::size_t i = 0; i < g.size(); ++i)
    if (!land[i]) wet[i] = 1, todo.push_back(i);
  while (!todo.empty()) {
    const std::size_t i = todo.back();
    todo.pop_back();
    const int r = int(i / g.nx), c = int(i % g.nx);
    for (int dr = -1; dr <= 1; ++dr)
      for (int dc = -1; dc <= 1; ++dc) {
        if (!g.contains(r + dr, c + dc)) continue;
        const std::size_t j = g.index(r + dr, c + dc);
        if (!wet[j] && z[j] > z[i]) wet[j] = 1, todo.push_back(j);
      }
  }
  return std::count(wet.begin(), wet.end(), 1);
}

TEST(LowerEnvelope, AgreesWithTryingEverySourceForRiversAndCoasts) {
  const Context context;
  for (int seed = 0; seed < 10; ++seed) {
    const Case c = island(seed, 60);
    const auto beds = watershed_map(c.map, c.beds, c.land, c.peak_distance, {}, context).bed_height;
    Raster<float> sources(c.land.grid(), kInfinity);
    Raster<std::uint8_t> mask(c.land.grid());
    for (std::size_t i = 0; i < sources.size(); ++i)
      if (!c.land[i]) sources[i] = 0.0f, mask[i] = 1;
    for (std::size_t i = 0; i < beds.size(); ++i)
      sources[c.beds.cells[i]] = beds[i], mask[c.beds.cells[i]] = 1;
    for (const Hillside& h : {Hillside{0.1, 0.0}, Hillside{0.2, 500.0}}) {
      auto source = nearest_feature(mask, context).nearest;
      const auto z = lower_envelope(sources, c.land, source, h, context);
      for (int r = 0; r < z.grid().ny; ++r)
        for (int k = 0; k < z.grid().nx; ++k) {
          if (!c.land(r, k)) continue;
          const double expected = slow_envelope(sources, r, k, h);
          ASSERT_NEAR(z(r, k), expected, 0.01 * expected + 0.2 * h.slope * z.grid().cell_size)
              << seed << " " << r << " " << k;
        }
    }
  }
}

TEST(WatershedMap, EveryCellDrainsToTheSea) {
  const Context context;
  for (int seed = 0; seed < 100; ++seed) {
    const Case c = island(seed, 40 + seed % 3 * 43);
    const auto result = watershed_map(c.map, c.beds, c.land, c.peak_distance, {}, context);
    EXPECT_EQ(count_drained(result.elevation, c.land), c.land.size()) << seed;
  }
}

TEST(WatershedMap, BedsFallAllTheWayAndLieOnTheGround) {
  const Context context;
  for (int seed = 0; seed < 30; ++seed) {
    const Case c = island(seed, 150);
    const WatershedParameters parameters;
    const auto result = watershed_map(c.map, c.beds, c.land, c.peak_distance, parameters, context);
    Raster<float> bed(c.land.grid(), kInfinity);
    for (std::size_t i = 0; i < c.beds.cells.size(); ++i) {
      const std::int32_t cell = c.beds.cells[i], to = c.beds.receivers[i];
      bed[cell] = result.bed_height[i];
      EXPECT_GT(bed[cell], 0.0f);
      if (to >= 0) {
        EXPECT_GT(bed[cell], bed[to]);
      }
      EXPECT_LE(result.elevation[cell], bed[cell]);
      EXPECT_GE(result.elevation[cell], bed[cell] - 0.51f);
      EXPECT_EQ(result.river_distance[cell], 0.0f);
      EXPECT_EQ(result.river_cell[cell], cell);
    }
    double highest = 0.0;
    for (const Peak& p : c.map.peaks) highest = std::max(highest, *p.height_m);
    EXPECT_LE(*std::max_element(result.bed_height.begin(), result.bed_height.end()),
              parameters.source_share * highest * 1.05);
  }
}

TEST(WatershedMap, RiversAreConcaveTowardsPeaks) {
  const Context context;
  VectorMap map;
  map.frame.size = {40e3, 10e3};
  map.peaks.push_back({});
  map.peaks.back().position = {38e3, 5e3};
  map.peaks.back().height_m = 3000.0;
  map.rivers.push_back({{{37e3, 5e3}, {1e3, 5e3}}, RiverEnd::Sea, -1, {}, 0, "", -1});
  const Grid grid = grid_over({0.0, 0.0}, map.frame.size, 400);
  Raster<std::uint8_t> land(grid, 1);
  for (int r = 0; r < grid.ny; ++r)
    for (int c = 0; c < 15; ++c) land(r, c) = 0;
  const auto beds = lay_river_beds(map, land, 0.0, 1e3, 1);
  const auto distance = nearest_point(std::vector<glm::dvec2>{{38e3, 5e3}}, grid, context).distance;
  const auto z = watershed_map(map, beds, land, distance, {}, context).elevation;
  const int row = grid.row_of(5e3);
  const double low = z(row, 80) - z(row, 40), high = z(row, 350) - z(row, 310);
  EXPECT_NEAR(low / 4000.0, 0.008, 0.002);
  EXPECT_GT(high, 2.5 * low);
}

TEST(WatershedMap, GivenEndHeightsHold) {
  const Context context;
  VectorMap map;
  map.frame.size = {20e3, 10e3};
  map.rivers.push_back({{{15e3, 5e3}, {-1e3, 5e3}}, RiverEnd::Frame, -1, 640.0, 0, "", -1});
  const Grid grid = grid_over({0.0, 0.0}, map.frame.size, 200);
  const Raster<std::uint8_t> land(grid, 1);
  const auto beds = lay_river_beds(map, land, 0.0, 1e3, 1);
  const auto result = watershed_map(map, beds, land, Raster<float>(grid, 30e3f), {}, context);
  EXPECT_NEAR(result.elevation(50, 0), 640.0, 2.0);
  EXPECT_GT(*std::min_element(result.elevation.values().begin(), result.elevation.values().end()),
            639.0);
  // Nothing to drain to: the sides lie at 0.
  const VectorMap bare;
  const auto none = lay_river_beds(bare, land, 0.0, 1e3, 1);
  const auto z = watershed_map(bare, none, land, Raster<float>(grid, 30e3f), {}, context).elevation;
  EXPECT_EQ(z(0, 7), 0.0f);
  EXPECT_GT(z(50, 100), 100.0f);
}

TEST(WatershedMap, LakesStandAtTheirLevel) {
  const Context context;
  Case c = island(3, 120);
  Lake lake;
  lake.outer = {{27e3, 38e3}, {31e3, 38e3}, {31e3, 41e3}, {27e3, 41e3}};
  lake.level_m = 210.0;
  c.map.lakes.push_back(lake);
  const auto z = watershed_map(c.map, c.beds, c.land, c.peak_distance, {}, context).elevation;
  const Grid& g = z.grid();
  EXPECT_NEAR(z(g.row_of(39.5e3), g.column_of(29e3)), 210.0f, 60.0f);
}

TEST(WatershedMap, AgreesBetweenResolutions) {
  const Context context;
  const Case coarse = island(8, 100), fine = island(8, 300);
  const auto a =
      watershed_map(coarse.map, coarse.beds, coarse.land, coarse.peak_distance, {}, context);
  const auto b = watershed_map(fine.map, fine.beds, fine.land, fine.peak_distance, {}, context);
  double sum = 0.0, spread = 0.0;
  for (int r = 0; r < 100; ++r)
    for (int k = 0; k < 100; ++k) {
      sum += std::pow(a.elevation(r, k) - b.elevation(3 * r + 1, 3 * k + 1), 2);
      spread += std::pow(b.elevation(3 * r + 1, 3 * k + 1), 2);
    }
  EXPECT_LT(std::sqrt(sum / spread), 0.1);
}

TEST(WatershedMap, SameForAnyNumberOfThreads) {
  const Case c = island(5, 170);
  WatershedMap first;
  for (int threads : {1, 2, 4}) {
    Context context({}, threads);
    context.run([&] {
      const auto result = watershed_map(c.map, c.beds, c.land, c.peak_distance, {}, context);
      if (first.elevation.empty()) first = result;
      EXPECT_EQ(result.elevation, first.elevation);
      EXPECT_EQ(result.river_distance, first.river_distance);
      EXPECT_EQ(result.bed_height, first.bed_height);
    });
  }
}

TEST(WatershedMap, SmallGridsAndBadParameters) {
  const Context context;
  for (auto [nx, ny] : {std::pair(1, 1), {1, 7}, {11, 1}})
    for (std::uint8_t value : {0, 1}) {
      const Grid grid{nx, ny, 100.0, {0.0, 0.0}};
      const Raster<std::uint8_t> land(grid, value);
      const VectorMap map;
      const auto beds = lay_river_beds(map, land, 0.0, 1e3, 1);
      const auto z =
          watershed_map(map, beds, land, Raster<float>(grid, 1e4f), {}, context).elevation;
      for (float v : z.values()) EXPECT_TRUE(std::isfinite(v));
    }
  const Case c = island(1, 20);
  WatershedParameters bad;
  bad.river_slope = 0.0;
  EXPECT_THROW(watershed_map(c.map, c.beds, c.land, c.peak_distance, bad, context), InputError);
}

}  // namespace
}  // namespace orogen
