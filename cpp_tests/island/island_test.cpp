#include "island/island.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "foundation/errors.h"
#include "foundation/random.h"

namespace orogen {
namespace {

const glm::dvec2 kLow{0.0, 0.0}, kHigh{50e3, 50e3};

Island island(std::uint32_t seed, IslandParameters parameters = {},
              const IslandInputs& inputs = {}) {
  return make_island(parameters, kLow, kHigh, seed, inputs, Context());
}

bool is_lake(const Island& made, std::int32_t center) {
  return made.centers.water[center] && !made.centers.ocean[center];
}

TEST(Island, HasLandWhereTheFunctionSays) {
  double cells = 0.0, function = 0.0;
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    const Island made = island(seed, {.cells = 3000});
    cells += double(std::ranges::count(made.centers.water, 0)) / 3000.0 / 20.0;
    for (int i = 0; i < 3000; ++i) {
      const glm::dvec2 p{50e3 * random_uniform(seed, 8, i), 50e3 * random_uniform(seed, 9, i)};
      function += (island_function({}, kLow, kHigh, seed, p) >= 0.0) / 3000.0 / 20.0;
    }
  }
  EXPECT_GT(function, 0.2);
  EXPECT_NEAR(cells, function, 0.04);  // a shore's polygon is water at 30% of its corners
  EXPECT_LT(cells, function);
}

TEST(Island, FunctionIsThePapers) {
  // At the rectangle's middle only noise and offset count; far away distance alone.
  const IslandParameters still{.base_amplitude = 0.0, .window = 1.0};
  EXPECT_NEAR(island_function(still, kLow, kHigh, 1, {25e3, 25e3}), 0.2, 1e-12);
  EXPECT_NEAR(island_function(still, kLow, kHigh, 1, {50e3, 25e3}), 0.2 - 2.2, 1e-12);
  EXPECT_NEAR(island_function(still, kLow, kHigh, 1, {50e3, 0.0}), 0.2 - 4.4, 1e-12);
  IslandParameters fine = still;
  fine.cells = 100'000;
  const double share = double(std::ranges::count(island(1, fine).centers.water, 0)) / 1e5;
  EXPECT_NEAR(share, M_PI * 0.2 / 2.2 / 4.0, 0.003);
}

TEST(Island, WaterIsOceanOnlyWhereTheSideIsJoined) {
  for (std::uint32_t seed = 0; seed < 30; ++seed) {
    const Island made = island(seed);
    for (std::int32_t c = 0; c < 4000; ++c) {
      const auto ring = made.map.center_corners.of(c);
      const auto wet = std::ranges::count_if(ring, [&](auto v) { return made.corners.water[v]; });
      ASSERT_EQ(made.centers.water[c] != 0,
                wet >= 0.3 * double(ring.size()) || made.map.center_border[c]);
      if (made.map.center_border[c]) {
        ASSERT_TRUE(made.centers.ocean[c]);
      }
      for (const std::int32_t e : made.map.center_edges.of(c)) {
        const std::int32_t other = made.map.beyond(e, c);
        if (other >= 0 && made.centers.ocean[c]) {
          ASSERT_FALSE(is_lake(made, other));
        }
      }
    }
  }
}

TEST(Island, HeightsRiseByStepsFromTheCoast) {
  for (std::uint32_t seed = 0; seed < 10; ++seed) {
    const Island made = island(seed);
    const auto& height = made.corners.elevation;
    EXPECT_EQ(*std::ranges::max_element(height), 1.0f);
    EXPECT_EQ(*std::ranges::min_element(height), -1.0f);
    for (std::size_t v = 0; v < height.size(); ++v) {
      if (made.coast[v]) {
        ASSERT_EQ(height[v], 0.0f);
      }
      if (made.corners.ocean[v]) {
        ASSERT_LT(height[v], 0.0f);
      }
    }
    float step = 1.0f;  // of land
    for (const float h : height)
      if (h > 0.0f) step = std::min(step, h);
    for (std::size_t e = 0; e < made.map.edge_corners.size(); ++e) {
      const auto [v, w] = made.map.edge_corners[e];
      if (!made.corners.ocean[v] && !made.corners.ocean[w]) {
        ASSERT_LE(std::fabs(height[v] - height[w]), 1.0001f * step);
      }
    }
  }
}

TEST(Island, LakesAreFlat) {
  int lakes = 0;
  for (std::uint32_t seed = 0; seed < 100; ++seed) {
    const Island made = island(seed, {.cells = 2000});
    for (std::int32_t c = 0; c < 2000; ++c) {
      if (!is_lake(made, c)) continue;
      ++lakes;
      ASSERT_EQ(made.biomes[c], Biome::Lake);
      for (const std::int32_t v : made.map.center_corners.of(c))
        ASSERT_EQ(made.corners.elevation[v], made.centers.elevation[c]);
      for (const std::int32_t e : made.map.center_edges.of(c)) {
        const std::int32_t other = made.map.beyond(e, c);
        ASSERT_TRUE(!is_lake(made, other) ||
                    made.centers.elevation[other] == made.centers.elevation[c]);
      }
    }
  }
  EXPECT_GT(lakes, 500);
}

void expect_rivers_run_out(const Island& made) {
  for (std::size_t v = 0; v < made.map.corners.size(); ++v) {
    if (!made.corner_river[v]) continue;
    std::size_t at = v, steps = 0;
    while (made.downstream[at] >= 0) {
      const std::int32_t edge = made.downstream[at], next = made.map.other_end(edge, at);
      ASSERT_EQ(made.edge_river[edge], made.corner_river[at]);
      ASSERT_GT(made.corner_river[next], made.corner_river[at]);  // each step adds water
      ASSERT_LT(++steps, made.map.corners.size());
      at = next;
    }
    ASSERT_TRUE(made.coast[at] || made.corners.ocean[at] || made.map.corner_border[at]);
  }
}

TEST(Island, RiversRunDownToTheSea) {
  for (std::uint32_t seed = 0; seed < 50; ++seed) {
    const Island made = island(seed, {.cells = 2000});
    EXPECT_GT(std::ranges::count_if(made.corner_river, [](int r) { return r > 0; }), 50);
    expect_rivers_run_out(made);
    for (std::size_t v = 0; v < made.map.corners.size(); ++v)
      if (made.corner_river[v] && made.downstream[v] >= 0) {
        ASSERT_LE(made.corners.elevation[made.map.other_end(made.downstream[v], v)],
                  made.corners.elevation[v]);
      }
  }
}

TEST(Island, SourcesKeepTheirDistance) {
  for (const int spacing : {1, 2, 4}) {
    const Island made = island(3, {.river_density = 1.0, .river_spacing = spacing});
    int sources = 0;
    for (std::int32_t v = 0; v < std::int32_t(made.map.corners.size()); ++v) {
      if (made.corner_river[v] != 1) continue;  // 1: no river comes from above
      ++sources;
      std::vector<std::int32_t> near{v};
      for (int step = 1; step < spacing; ++step)
        for (std::size_t i = near.size(); i-- > 0;)
          for (const std::int32_t e : made.map.corner_edges.of(near[i]))
            near.push_back(made.map.other_end(e, near[i]));
      for (const std::int32_t w : near) ASSERT_TRUE(w == v || made.corner_river[w] != 1);
    }
    EXPECT_GT(sources, 40);
  }
}

TEST(Island, MoistureFallsAwayFromWater) {
  const Island made = island(5);
  for (std::size_t e = 0; e < made.map.edge_corners.size(); ++e) {
    const auto [v, w] = made.map.edge_corners[e];
    ASSERT_GE(made.corners.moisture[v], 0.7999f * made.corners.moisture[w]);
    ASSERT_GE(made.corners.moisture[w], 0.7999f * made.corners.moisture[v]);
  }
  for (std::size_t v = 0; v < made.map.corners.size(); ++v)
    ASSERT_GE(made.corners.moisture[v], std::min(1.0f, made.corner_river[v] / 5.0f));
}

TEST(Island, BiomesFollowTemperatureAndMoisture) {
  const Island made = island(5);
  for (std::int32_t c = 0; c < 4000; ++c) {
    const Biome biome = made.biomes[c];
    ASSERT_EQ(biome == Biome::Ocean, made.centers.ocean[c] != 0);
    if (biome != Biome::Ocean && biome != Biome::Lake && biome != Biome::Beach) {
      ASSERT_EQ(biome, biome_of(made.centers.temperature[c], made.centers.moisture[c]));
    }
  }
}

TEST(Island, TakesACoastThatIsGiven) {
  const auto ring = [](glm::dvec2 p) {
    const double r = std::hypot(p.x - 25e3, p.y - 25e3);
    return r < 18e3 && r > 5e3;
  };
  const Island made = island(1, {.cells = 10000}, {.is_land = ring});
  double land = 0.0, lake = 0.0;
  for (std::int32_t c = 0; c < 10000; ++c) {
    land += !made.centers.water[c] / 10000.0;
    lake += is_lake(made, c) / 10000.0;
  }
  EXPECT_NEAR(land, M_PI * (18.0 * 18.0 - 25.0) / 2500.0, 0.03);
  EXPECT_NEAR(lake, M_PI * 25.0 / 2500.0, 0.01);
  expect_rivers_run_out(made);
  // Land all over the rectangle: water leaves by its sides.
  const Island inland = island(1, {}, {.is_land = [](glm::dvec2) { return true; }});
  EXPECT_EQ(std::ranges::count(inland.centers.ocean, 1), 0);
  expect_rivers_run_out(inland);
  EXPECT_THROW(island(1, {}, {.is_land = [](glm::dvec2) { return false; }}), InputError);
}

TEST(Island, KeepsWhatWasEditedByHand) {
  const auto hill = [](glm::dvec2 p) { return p.x < 12e3 && p.y < 12e3 ? 1.4 : 0.0; };
  const auto pit = [](glm::dvec2 p) {
    return std::hypot(p.x - 25e3, p.y - 25e3) < 6e3 ? -0.4 : 0.0;
  };
  const auto dry = [](glm::dvec2) { return -1.0; };
  const IslandInputs inputs{.elevation = [&](glm::dvec2 p) { return hill(p) + pit(p); },
                            .moisture = dry};
  const Island plain = island(2), edited = island(2, {}, inputs);
  for (std::int32_t c = 0; c < 4000; ++c) {
    const glm::dvec2 p = edited.map.centers[c];
    if (p.x > 2e3 && p.x < 10e3 && p.y > 2e3 && p.y < 10e3) {
      ASSERT_TRUE(plain.centers.ocean[c]);
      ASSERT_FALSE(edited.centers.ocean[c]);
    }
    ASSERT_EQ(edited.centers.moisture[c], 0.0f);
  }
  expect_rivers_run_out(edited);
}

TEST(Island, IsTheSameWithAnyNumberOfThreads) {
  const auto once = [](int threads) {
    Context context({}, threads);
    Island made;
    context.run([&] { made = make_island({}, kLow, kHigh, 3, {}, context); });
    return made;
  };
  const Island one = once(1), four = once(4);
  EXPECT_EQ(one.corners.elevation, four.corners.elevation);
  EXPECT_EQ(one.centers.moisture, four.centers.moisture);
  EXPECT_EQ(one.edge_river, four.edge_river);
}

}  // namespace
}  // namespace orogen
