// Islands and feature curves in recipes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "climate/biomes.h"
#include "foundation/errors.h"
#include "pipeline/island.h"
#include "pipeline/pipeline.h"

namespace orogen {
namespace {

constexpr const char* kExtent =
    R"("orogen": 1, "resolution": 128, "extent": {"origin": [0, 0], "size": [40000, 40000]})";

std::string document(const std::string& more = "") {
  return "{" + std::string(kExtent) + more + "}";
}

Generated grown(const std::string& text, int threads = 0) {
  Context context({}, threads);
  return generate(read_recipe(text), {}, context, nullptr);
}

TEST(IslandStages, AnExtentAloneGrowsAnIsland) {
  const Recipe recipe = read_recipe(document());
  ASSERT_EQ(recipe.stages.size(), 5u);
  EXPECT_EQ(recipe.stages[0].stage, "island");
  EXPECT_EQ(recipe.stages[1].stage, "feature_curves");
  EXPECT_EQ(recipe.stages[2].stage, "hydraulic_erosion");
  EXPECT_EQ(recipe.stages[3].stage, "lakes");
  EXPECT_EQ(recipe.stages[4].stage, "biomes");
  const Terrain terrain = grown(document()).terrain;
  const auto& elevation = terrain.real("elevation");
  const auto& biome = terrain.integer("biome");
  EXPECT_NEAR(*std::ranges::max_element(elevation.values()), 2000.0, 200.0);
  EXPECT_EQ(biome[0], std::int32_t(Biome::Ocean));
  const auto land = std::ranges::count(terrain.integer("land").values(), 1);
  EXPECT_GT(land, 128 * 128 / 10);
  EXPECT_LT(land, 128 * 128 / 2);
}

TEST(IslandStages, IsTheSameWithAnyNumberOfThreads) {
  const Terrain one = grown(document(), 1).terrain, four = grown(document(), 4).terrain;
  for (const char* field : {"elevation", "temperature", "moisture", "water_depth"})
    EXPECT_EQ(one.real(field), four.real(field)) << field;
  EXPECT_EQ(one.integer("biome"), four.integer("biome"));
}

TEST(IslandStages, TakesTheCoastOfAMap) {
  const Recipe recipe = read_recipe(island_document(
      R"(, "stages": [{"stage": "mapped_island", "parameters": {"cells": 3000}}])"));
  Context context;
  const Terrain terrain = generate(recipe, {}, context, nullptr).terrain;
  const auto& elevation = terrain.real("elevation");
  const auto& land = terrain.integer("land");
  std::size_t inside = 0;
  for (std::size_t i = 0; i < land.size(); ++i) {
    inside += land[i] != 0;
    ASSERT_EQ(land[i] != 0, elevation[i] + terrain.real("water_depth")[i] > 0.0f);
  }
  EXPECT_GT(inside, land.size() / 10);
}

TEST(IslandStages, PaintChangesHeightsAndClimate) {
  const std::string stages = R"(, "stages": [{"stage": "island"}])";
  const Terrain plain = grown(document(stages)).terrain;
  const Terrain painted =
      grown(document(stages +
                     R"(, "rasters": {"moisture_change": [[-1]], "temperature_change": [[-1]],
                 "elevation_change": [[1.5, 0, 0], [0, 0, 0], [0, 0, 0]]})"))
          .terrain;
  EXPECT_EQ(plain.integer("land")(8, 8), 0);
  EXPECT_EQ(painted.integer("land")(20, 20), 1);
  for (const float v : painted.real("moisture").values()) ASSERT_EQ(v, 0.0f);
  for (const float v : painted.real("temperature").values()) ASSERT_EQ(v, 0.0f);
  EXPECT_GT(std::ranges::count(painted.integer("biome").values(), int(Biome::Scorched)), 100);
}

constexpr const char* kRidge = R"(, "features": [{"name": "ridge", "points": [
  {"position": [8000, 20000, 1200], "plateau": 400,
   "sides": {"slope_size": 1500, "slope_angle_deg": 20, "envelope": 2000}},
  {"position": [32000, 20000, 1200], "plateau": 400,
   "left": {"slope_size": 1500, "slope_angle_deg": 20, "envelope": 2000}}]}])";

TEST(IslandStages, FeatureCurvesBendTheGround) {
  const std::string stages = R"(, "stages": [{"stage": "island"}, {"stage": "feature_curves"}])";
  const Terrain plain = grown(document(stages)).terrain;
  const Terrain bent = grown(document(stages + kRidge)).terrain;
  EXPECT_NEAR(bent.real("elevation")(64, 40), 1200.0, 24.0);
  EXPECT_EQ(bent.integer("land")(64, 27), 1);
  for (const int row : {5, 120})
    for (int c = 0; c < 128; ++c)
      ASSERT_EQ(plain.real("elevation")(row, c), bent.real("elevation")(row, c));
  const Recipe recipe = read_recipe(document(stages + kRidge));
  EXPECT_EQ(write_recipe(read_recipe(write_recipe(recipe))), write_recipe(recipe));
}

TEST(IslandStages, RiverSourcesAddWater) {
  const std::string stages = R"(, "stages": [{"stage": "island"},
      {"stage": "hydraulic_erosion", "parameters": {"rain_rate_mm_per_h": 0}}])";
  const Terrain dry = grown(document(stages)).terrain;
  const Raster<float>& z = dry.real("elevation");
  const int top = int(std::ranges::max_element(z.values()) - z.values().begin());
  const glm::dvec2 p = z.grid().center(top / 128, top % 128);
  const std::string sources = R"(, "river_sources": [{"position": [)" + std::to_string(p.x) + "," +
                              std::to_string(p.y) + R"(], "discharge": 500},
      {"name": "Drowned", "position": [1, 1], "discharge": 5}])";  // it lies in the sea
  const Recipe recipe = read_recipe(document(stages + sources));
  EXPECT_EQ(write_recipe(read_recipe(write_recipe(recipe))), write_recipe(recipe));
  const Generated wet = grown(document(stages + sources));
  EXPECT_EQ(*std::ranges::max_element(dry.real("wear").values()), 0.0f);
  EXPECT_GT(wet.terrain.real("wear")[top], 1.0f);
  EXPECT_EQ(wet.warnings,
            std::vector<std::string>{"river_sources[1]: changes nothing; it lies in the sea"});
  const Generated still = grown(document(R"(, "stages": [{"stage": "island"}])" + sources));
  EXPECT_EQ(still.warnings.size(), 2u);
}

TEST(IslandStages, RiverSourcesThatCannotBeAreRefused) {
  for (const auto& [source, says] :
       {std::pair{R"({"position": [50000, 1], "discharge": 1})", "[0].position: lies outside"},
        {R"({"position": [1, 1], "discharge": -1})", "[0].discharge: -1"},
        {R"({"position": [1, 1], "discharge": "1"})", "from 0 to 1e+09 m3/s"},
        {R"({"name": 1, "position": [1, 1], "discharge": 1})", "[0].name"},
        {R"({"position": [1, 1]})", "discharge"},
        {R"({"position": [1, 1], "discharge": 1, "width": 2})", "width"}}) {
    try {
      read_recipe(document(R"(, "river_sources": [)" + std::string(source) + "]"));
      ADD_FAILURE() << source;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(says), std::string::npos) << error.what();
    }
  }
}

TEST(IslandStages, FeaturesThatCannotBeAreRefused) {
  const auto refused = [](const std::string& point, const char* says) {
    try {
      read_recipe(
          document(R"(, "features": [{"points": [{"position": [0, 0, 0]}, )" + point + "]}]"));
      ADD_FAILURE() << point;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(says), std::string::npos) << error.what();
    }
  };
  refused(R"({"position": [1]})", "features[0].points[1].position");
  refused(R"({"position": [1, 2], "elevation": true})", "without a height");
  refused(R"({"position": [1, 2, 3], "plateau": -1})", "points[1].plateau");
  refused(R"({"position": [1, 2, 3], "left": {"slope_angle_deg": 90}})", "slope_angle_deg");
  refused(R"({"position": [1, 2, 3], "width": 5})", "width");
  EXPECT_THROW(read_recipe(document(R"(, "features": [{"points": [{"position": [0, 0]}]}])")),
               InputError);
}

}  // namespace
}  // namespace orogen
