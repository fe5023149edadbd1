#include "island/island_relief.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace orogen {
namespace {

const glm::dvec2 kLow{0.0, 0.0}, kHigh{50e3, 50e3};

Island island(std::uint32_t seed, int cells = 2000) {
  return make_island({.cells = cells}, kLow, kHigh, seed, {}, Context());
}

IslandRelief relief(const Island& made, IslandReliefParameters parameters = {},
                    int resolution = 256) {
  return island_relief(made, parameters, grid_over(kLow, kHigh, resolution), 5, Context());
}

double correlation(const Raster<float>& a, const Raster<float>& b) {
  double sa = 0, sb = 0, aa = 0, bb = 0, ab = 0;
  const double n = double(a.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    sa += a[i], sb += b[i];
    aa += double(a[i]) * a[i], bb += double(b[i]) * b[i], ab += double(a[i]) * b[i];
  }
  return (ab - sa * sb / n) / std::sqrt((aa - sa * sa / n) * (bb - sb * sb / n));
}

TEST(IslandRelief, ReachesItsHeightAndDepth) {
  for (std::uint32_t seed = 0; seed < 5; ++seed) {
    const IslandRelief made = relief(island(seed), {.peak_height = 1500.0, .sea_depth = 700.0});
    float high = -1e9f, low = 1e9f;
    for (std::size_t i = 0; i < made.elevation.size(); ++i) {
      const float h = made.elevation[i] + made.water_depth[i];
      high = std::max(high, h);
      low = std::min(low, h);
      ASSERT_EQ(made.land[i] != 0, h > 0.0f);
    }
    EXPECT_NEAR(high, 1500.0, 0.1);
    EXPECT_NEAR(low, -700.0, 0.1);
  }
}

TEST(IslandRelief, WithoutNoiseIsThePolygonMap) {
  const Island made = island(1);
  const IslandReliefParameters plain{.peak_height = 1.0,
                                     .sea_depth = 1.0,
                                     .height_exponent = 1.0,
                                     .perturbation = 0.0,
                                     .relief = 0.0,
                                     .lake_depth = 0.0};
  const Grid grid = grid_over(kLow, kHigh, 500);
  const IslandRelief drawn = island_relief(made, plain, grid, 5, Context());
  for (std::int32_t c = 0; c < 2000; ++c) {
    const glm::dvec2 p = made.map.centers[c];
    const std::size_t i = grid.index(grid.row_of(p.y), grid.column_of(p.x));
    ASSERT_EQ(drawn.biome[i], std::int32_t(made.biomes[c]));
    ASSERT_NEAR(drawn.elevation[i], made.centers.elevation[c], 0.06);
    ASSERT_NEAR(drawn.temperature[i], made.centers.temperature[c], 0.06);
    ASSERT_NEAR(drawn.moisture[i], made.centers.moisture[c], 0.08);
  }
}

TEST(IslandRelief, HeightsAreRaisedToThePower) {
  const Island made = island(1);
  IslandReliefParameters plain{
      .peak_height = 1.0, .sea_depth = 1.0, .height_exponent = 1.0, .relief = 0.0};
  const IslandRelief linear = relief(made, plain);
  plain.height_exponent = 1.5;
  const IslandRelief steep = relief(made, plain);
  for (std::size_t i = 0; i < steep.elevation.size(); ++i) {
    const float level = linear.elevation[i] + linear.water_depth[i];
    if (std::fabs(level) < 0.01f) continue;
    ASSERT_NEAR(steep.elevation[i] + steep.water_depth[i],
                std::copysign(std::pow(std::fabs(level), 1.5f), level), 0.02);
  }
}

TEST(IslandRelief, LakesAreLevelAndHeldIn) {
  int cells = 0;
  for (std::uint32_t seed = 0; seed < 8; ++seed) {
    const Island island_made = island(seed);
    const IslandRelief made = relief(island_made);
    const Grid& grid = made.elevation.grid();
    for (int r = 1; r + 1 < grid.ny; ++r)
      for (int c = 1; c + 1 < grid.nx; ++c) {
        const std::size_t i = grid.index(r, c);
        if (made.water_depth[i] == 0.0f) continue;
        ++cells;
        ASSERT_EQ(made.biome[i], std::int32_t(Biome::Lake));
        ASSERT_LE(made.water_depth[i], 40.0f);
        for (const std::size_t j : {i - 1, i + 1, i - grid.nx, i + grid.nx})
          if (made.water_depth[j] > 0.0f) {
            ASSERT_NEAR(made.elevation[i] + made.water_depth[i],
                        made.elevation[j] + made.water_depth[j], 1e-3);
          }
      }
  }
  EXPECT_GT(cells, 1000);
}

TEST(IslandRelief, IsTheSameGroundAtAnyResolution) {
  const Island made = island(3);
  const IslandRelief fine = relief(made, {}, 512), coarse = relief(made, {}, 256);
  Raster<float> mean(coarse.elevation.grid());
  for (int r = 0; r < 256; ++r)
    for (int c = 0; c < 256; ++c)
      mean(r, c) =
          0.25f * (fine.elevation(2 * r, 2 * c) + fine.elevation(2 * r, 2 * c + 1) +
                   fine.elevation(2 * r + 1, 2 * c) + fine.elevation(2 * r + 1, 2 * c + 1));
  EXPECT_GT(correlation(mean, coarse.elevation), 0.998);
}

TEST(IslandRelief, TheSeaGoesRoundTheIslandHoweverRoughItIs) {
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    const Island made = island(seed);
    const IslandRelief rough = relief(made, {.relief = 4.0}, 200);
    const Raster<float>& z = rough.elevation;
    for (int k = 0; k < 200; ++k)
      for (const float rim : {z(0, k), z(199, k), z(k, 0), z(k, 199)}) ASSERT_LT(rim, 0.0f) << seed;
    EXPECT_GT(std::ranges::count(rough.land.values(), 1), 2000);
  }
}

TEST(IslandRelief, RougherBiomesAreRougher) {
  // The highest octave's share grows with R: curvature beside height.
  const auto curvature = [](Biome biome) {
    Island made = island(3);
    std::ranges::fill(made.biomes, biome);
    const IslandRelief drawn =
        relief(made, {.peak_height = 1.0, .sea_depth = 1.0, .perturbation = 0.0}, 512);
    double sum = 0.0;
    for (int r = 1; r < 511; ++r)
      for (int c = 1; c < 511; ++c)
        sum += std::fabs(drawn.elevation(r, c - 1) + drawn.elevation(r, c + 1) -
                         2.0 * drawn.elevation(r, c));
    return sum;
  };
  const double snow = curvature(Biome::Snow), shrubs = curvature(Biome::Shrubland);  // both A = 0.5
  EXPECT_GT(snow, 2.0 * shrubs);
}

TEST(IslandRelief, IsTheSameWithAnyNumberOfThreads) {
  const Island made = island(2);
  const auto once = [&](int threads) {
    Context context({}, threads);
    IslandRelief drawn;
    context.run([&] { drawn = island_relief(made, {}, grid_over(kLow, kHigh, 300), 1, context); });
    return drawn;
  };
  const IslandRelief one = once(1), four = once(4);
  EXPECT_EQ(one.elevation, four.elevation);
  EXPECT_EQ(one.biome, four.biome);
  EXPECT_EQ(one.water_depth, four.water_depth);
}

}  // namespace
}  // namespace orogen
