#include "vegetation/placement.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "foundation/errors.h"
#include "foundation/noise.h"
#include "vegetation/ground_cover.h"
#include "vegetation/tree_species.h"

namespace orogen {
namespace {

struct Land {
  Raster<float> elevation;
  Raster<std::int32_t> biome;

  Land(const Grid& grid, Biome kind) : elevation(grid, 100.0f), biome(grid, int(kind)) {}
  PlantGround ground() const { return {elevation, biome}; }
};

Grid square(double side, double cell) {
  const int cells = int(std::lround(side / cell));
  return {cells, cells, cell, {1e5, -3e5}};
}

PlantCloud placed(const PlantGround& ground, const PlantTable& table,
                  const PlacementParameters& parameters = {}, std::uint32_t seed = 5) {
  return place_plants(ground, table, parameters, {}, seed, Context());
}

/// Two kinds, crowded: a third of the tries go.
PlantTable crowded(Biome biome = Biome::Taiga) {
  PlantTable table;
  table.density[int(biome)] = 400.0;
  PlantKind small, large;
  small.name = "small", small.spacing = 1.0, small.weight[int(biome)] = 3.0;
  large.name = "large", large.spacing = 4.0, large.weight[int(biome)] = 1.0;
  table.kinds = {small, large};
  return table;
}

TEST(Placement, DensityAndSharesAreTheTables) {
  for (const PlantTable* table : {&tree_table(), &ground_cover_table()})
    for (int b = 0; b < kBiomes; ++b) {
      const double wanted = table->density[b];
      if (wanted == 0.0) continue;
      const double side = std::min(100.0 * std::sqrt(20000.0 / wanted), 20e3);
      const Land land(square(side, side / 40.0), Biome(b));
      const PlantCloud cloud = placed(land.ground(), *table, {}, 100 + b);
      const double expected = wanted * side * side / 1e4;
      EXPECT_NEAR(double(cloud.kinds.size()), expected, 4.0 * std::sqrt(expected)) << b;
      EXPECT_EQ(cloud.density_share, 1.0);

      double all = 0.0, chi_square = 0.0;
      int freedom = -1;
      for (const PlantKind& kind : table->kinds) all += kind.weight[b];
      for (std::size_t k = 0; k < table->kinds.size(); ++k) {
        const auto found = std::ranges::count(cloud.kinds, k);
        const double mean = double(cloud.kinds.size()) * table->kinds[k].weight[b] / all;
        if (mean == 0.0) {
          EXPECT_EQ(found, 0) << table->kinds[k].name;
          continue;
        }
        chi_square += (found - mean) * (found - mean) / mean;
        ++freedom;
      }
      EXPECT_LT(chi_square, freedom + 4.0 * std::sqrt(2.0 * freedom) + 1.0) << b;
    }
}

TEST(Placement, EveryPairKeepsItsSpacing) {
  for (std::uint32_t seed = 0; seed < 10; ++seed) {
    const Land land(square(300.0, 25.0), Biome::Taiga);
    const PlantTable table = crowded();
    const PlantCloud cloud = placed(land.ground(), table, {}, seed);
    ASSERT_GT(cloud.kinds.size(), 2500u);
    for (std::size_t i = 0; i < cloud.kinds.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) {
        const double d = std::hypot(double(cloud.positions[i].x) - cloud.positions[j].x,
                                    double(cloud.positions[i].y) - cloud.positions[j].y);
        const double least =
            0.5 * (table.kinds[cloud.kinds[i]].spacing + table.kinds[cloud.kinds[j]].spacing);
        ASSERT_GE(d, least * (1.0 - 1e-12)) << i << " " << j;
      }
  }
}

TEST(Placement, PlantsStandOnTheGroundWithinTheirLimits) {
  const Grid grid = square(4000.0, 40.0);
  Land land(grid, Biome::Taiga);
  land.elevation = fbm({.seed = 4, .wavelength = 2500.0}, grid, Context());
  for (float& z : land.elevation.values()) z = 900.0f + 500.0f * z;
  PlantTable table = crowded();
  table.density[int(Biome::Taiga)] = 200.0;
  table.kinds[0].max_slope_deg = 20.0;
  table.kinds[1].min_altitude = 700.0;
  table.kinds[1].max_altitude = 1100.0;
  const PlantCloud cloud = placed(land.ground(), table);
  ASSERT_GT(cloud.kinds.size(), 15000u);
  const auto height = [&](double x, double y) {  // bilinear
    const double u = std::clamp(x / 40.0 - 0.5, 0.0, grid.nx - 1.0);
    const double v = std::clamp(y / 40.0 - 0.5, 0.0, grid.ny - 1.0);
    const int c = std::min(int(u), grid.nx - 2), r = std::min(int(v), grid.ny - 2);
    const auto& z = land.elevation;
    const double south = z(r, c) + (u - c) * (z(r, c + 1) - z(r, c));
    const double north = z(r + 1, c) + (u - c) * (z(r + 1, c + 1) - z(r + 1, c));
    return south + (v - r) * (north - south);
  };
  for (std::size_t i = 0; i < cloud.kinds.size(); ++i) {
    const glm::vec3 p = cloud.positions[i];
    ASSERT_NEAR(p.z, height(p.x, p.y), 0.01);
    const bool inside = p.x > 21 && p.y > 21 && p.x < 3979 && p.y < 3979;
    const double step = 1e-3, dx = (height(p.x + step, p.y) - height(p.x - step, p.y)) / (2 * step);
    const double dy = (height(p.x, p.y + step) - height(p.x, p.y - step)) / (2 * step);
    const bool within_a_cell =
        std::fmod(p.x + 20.0, 40.0) > 0.01 && std::fmod(p.y + 20.0, 40.0) > 0.01;
    if (cloud.kinds[i] == 0 && inside && within_a_cell) {
      ASSERT_LE(std::hypot(dx, dy), std::tan(20.0 * M_PI / 180.0) + 0.01);
    }
    if (cloud.kinds[i] == 1) {
      ASSERT_GE(p.z, 700.0f);
      ASSERT_LE(p.z, 1100.0f);
    }
    const PlantKind& kind = table.kinds[cloud.kinds[i]];
    ASSERT_GE(cloud.scales[i], float(kind.min_scale));
    ASSERT_LE(cloud.scales[i], float(kind.max_scale));
    ASSERT_GE(cloud.rotations[i], 0.0f);
    ASSERT_LE(cloud.rotations[i], float(2.0 * M_PI));
  }
}

bool same(const PlantCloud& a, const PlantCloud& b) {
  return a.positions == b.positions && a.kinds == b.kinds && a.scales == b.scales &&
         a.rotations == b.rotations;
}

TEST(Placement, IsTheSameOnAnyNumberOfThreads) {
  const Land land(square(2000.0, 50.0), Biome::DeciduousForest);
  const PlantCloud one = placed(land.ground(), tree_table());
  for (const int threads : {1, 2, 4}) {
    Context context({}, threads);
    PlantCloud other;
    context.run([&] { other = place_plants(land.ground(), tree_table(), {}, {}, 5, context); });
    EXPECT_TRUE(same(one, other)) << threads;
  }
  EXPECT_FALSE(same(one, placed(land.ground(), tree_table(), {}, 6)));
}

TEST(Placement, DoesNotHangOnResolution) {
  const Land coarse(square(1600.0, 100.0), Biome::Taiga), fine(square(1600.0, 10.0), Biome::Taiga);
  EXPECT_TRUE(same(placed(coarse.ground(), tree_table()), placed(fine.ground(), tree_table())));
  const auto half = [](double cell) {  // forest in the west
    Land land(square(1600.0, cell), Biome::Taiga);
    for (int r = 0; r < land.biome.grid().ny; ++r)
      for (int c = 0; c < land.biome.grid().nx; ++c)
        if (land.biome.grid().center(r, c).x > 1e5 + 800.0) land.biome(r, c) = int(Biome::Ocean);
    return double(placed(land.ground(), tree_table()).kinds.size());
  };
  EXPECT_NEAR(half(100.0) / half(10.0), 1.0, 0.04);
}

TEST(Placement, ARegionHasThePlantsOfTheWhole) {
  const Land land(square(1000.0, 50.0), Biome::TropicalRainForest);
  const PlantCloud whole = placed(land.ground(), tree_table());
  const PlantRegion region{{212.5, 333.0}, {655.0, 400.0}};
  const PlantCloud part = place_plants(land.ground(), tree_table(), {}, region, 5, Context());
  PlantCloud cut;
  for (std::size_t i = 0; i < whole.kinds.size(); ++i) {
    const glm::vec3 p = whole.positions[i];
    if (p.x < 212.5 || p.x >= 655.0 || p.y < 333.0 || p.y >= 400.0) continue;
    cut.positions.push_back(p);
    cut.kinds.push_back(whole.kinds[i]);
    cut.scales.push_back(whole.scales[i]);
    cut.rotations.push_back(whole.rotations[i]);
  }
  EXPECT_GT(cut.kinds.size(), 500u);
  EXPECT_TRUE(same(part, cut));
  const PlantRegion outside{{-500.0, -500.0}, {-10.0, -10.0}};
  EXPECT_TRUE(place_plants(land.ground(), tree_table(), {}, outside, 5, Context()).kinds.empty());
}

TEST(Placement, LowersDensitiesWhereTooManyWouldStand) {
  const Land land(square(2000.0, 50.0), Biome::Taiga);
  const PlantCloud cloud = placed(land.ground(), tree_table(), {.most_plants = 10000});
  EXPECT_NEAR(cloud.density_share, 10000.0 / 300000.0, 1e-3);
  EXPECT_NEAR(double(cloud.kinds.size()), 10000.0, 500.0);
  EXPECT_TRUE(placed(land.ground(), tree_table(), {.most_plants = 0}).kinds.empty());
}

TEST(Placement, DensityFactorMultiplies) {
  const Land land(square(2000.0, 50.0), Biome::Shrubland);
  const double one = double(placed(land.ground(), tree_table()).kinds.size());
  const double half =
      double(placed(land.ground(), tree_table(), {.density_factor = 0.5}).kinds.size());
  EXPECT_NEAR(half / one, 0.5, 0.01);
  const auto density =
      plant_density(land.ground(), tree_table(), {.density_factor = 0.5}, Context());
  EXPECT_NEAR(density(3, 3), 150.0, 1e-3);
}

TEST(Placement, NothingStandsInWaterOrOnIce) {
  Land land(square(2000.0, 100.0), Biome::Taiga);
  Raster<float> water(land.biome.grid()), snow(land.biome.grid());
  for (int c = 0; c < 20; ++c) {
    land.biome(2, c) = int(Biome::Ocean);
    land.biome(6, c) = int(Biome::Lake);
    water(10, c) = 3.0f;
    snow(14, c) = 1.0f;
  }
  const PlantGround ground{land.elevation, land.biome, &water, &snow};
  const PlantCloud cloud = placed(ground, tree_table());
  EXPECT_GT(cloud.kinds.size(), 100000u);
  for (const glm::vec3 p : cloud.positions) {
    const int row = int(p.y / 100.0f);
    ASSERT_TRUE(row != 2 && row != 6 && row != 10 && row != 14) << p.y;
  }
}

TEST(Placement, RefusesWhatCannotStand) {
  const Land land(square(200.0, 50.0), Biome::Taiga);
  const auto refused = [&](const PlantTable& table, const char* says, const Land& on) {
    try {
      placed(on.ground(), table);
      ADD_FAILURE() << says;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(says), std::string::npos) << error.what();
    }
  };
  PlantTable table = crowded();
  table.density[int(Biome::Taiga)] = 5000.0;
  refused(table, "taiga cannot stand at their spacings; at most", land);
  table = crowded();
  table.density[2] = -1.0;
  refused(table, "density.bare", land);
  table = crowded();
  table.kinds[1].name = "small";
  refused(table, "twice", land);
  table = crowded();
  table.kinds[1].min_scale = 3.0;
  refused(table, "kinds[1]: min_scale", land);
  Land odd = land;
  odd.biome(1, 2) = 16;
  refused(crowded(), "row 1, column 2: 16", odd);
}

TEST(Placement, HoldsOnAnyGround) {
  for (std::uint32_t seed = 0; seed < 100; ++seed) {
    const Grid grid{1 + int(seed % 11), 1 + int(seed % 7), 30.0 + seed, {-5e4, 7e4}};
    Land land(grid, Biome::Taiga);
    land.elevation = fbm({.seed = seed, .wavelength = 300.0}, grid, Context());
    for (std::size_t i = 0; i < grid.size(); ++i) {
      land.elevation[i] *= 100.0f;
      land.biome[i] = std::int32_t((seed + 3 * i) % kBiomes);
    }
    const PlantCloud cloud = placed(land.ground(), tree_table(), {}, seed);
    for (std::size_t i = 0; i < cloud.kinds.size(); ++i) {
      const glm::vec3 p = cloud.positions[i];
      ASSERT_TRUE(p.x >= 0.0f && p.y >= 0.0f && p.x < grid.width() && p.y < grid.height());
      const int row = int(p.y / grid.cell_size), column = int(p.x / grid.cell_size);
      bool grows = false;
      for (int r = row - 1; r <= row + 1; ++r)
        for (int c = column - 1; c <= column + 1; ++c)
          if (grid.contains(r, c))
            grows |= tree_table().kinds[cloud.kinds[i]].weight[std::size_t(land.biome(r, c))] > 0.0;
      ASSERT_TRUE(grows);
    }
  }
}

TEST(PlantTables, HaveSpeciesThatThereAre) {
  std::set<std::string_view> known;
  for (const TreeSpecies& species : tree_species()) known.insert(species.name);
  for (const GroundCover& cover : ground_cover()) known.insert(cover.name);
  for (const PlantTable* table : {&tree_table(), &ground_cover_table()})
    for (const PlantKind& kind : table->kinds) EXPECT_TRUE(known.contains(kind.name)) << kind.name;
  EXPECT_NO_THROW(check_plant_table(tree_table(), "trees"));
  EXPECT_NO_THROW(check_plant_table(ground_cover_table(), "ground_cover"));
  for (const PlantTable* table : {&tree_table(), &ground_cover_table()})
    for (int b = 0; b < kBiomes; ++b) {
      double all = 0.0;
      for (const PlantKind& kind : table->kinds) all += kind.weight[b];
      EXPECT_EQ(all > 0.0, table->density[b] > 0.0) << info(Biome(b)).name;
    }
}

}  // namespace
}  // namespace orogen
