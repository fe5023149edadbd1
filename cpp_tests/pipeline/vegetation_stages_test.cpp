// Plants in recipes.
#include "pipeline/vegetation_stages.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "foundation/errors.h"
#include "pipeline/pipeline.h"

namespace orogen {
namespace {

std::string document(const std::string& plants = "") {
  return R"({"orogen": 1, "resolution": 64, "extent": {"origin": [0, 0], "size": [3200, 3200]},
    "rasters": {"elevation": [[-40, 60], [120, 400]]})" +
         plants + R"(, "stages": [{"stage": "given_elevation", "parameters": {"roughness": 0}},
    {"stage": "climate", "parameters": {"sea_level_temperature": 12}}, {"stage": "biomes"},
    {"stage": "vegetation", "parameters": {"tree_density_factor": 0.5}}]})";
}

Generated grown(const std::string& text) {
  Context context;
  return generate(read_recipe(text), {}, context, nullptr);
}

TEST(VegetationStages, AsManyPlantsStandAsTheFieldSays) {
  const Generated made = grown(document());
  const auto& density = made.terrain.real("tree_density").values();
  const double expected = std::accumulate(density.begin(), density.end(), 0.0) * 0.25;
  const auto planting = made.products.find<Planting>();
  ASSERT_NE(planting, nullptr);
  const PlantCloud trees =
      plants_of(*planting, PlantLayer::Trees, plant_ground(made.terrain), {}, 1'000'000, Context());
  EXPECT_GT(expected, 5000.0);
  EXPECT_NEAR(double(trees.kinds.size()), expected, 0.05 * expected);
  const auto& cover = made.terrain.real("ground_cover_density").values();
  EXPECT_GT(std::ranges::max(cover), 1000.0f);
}

TEST(VegetationStages, TablesOfTheRecipeChangeTheBuiltInOnes) {
  const std::string text = document(R"(, "plants": {"trees": {"density": {"grassland": 50},
    "kinds": [{"name": "norway_spruce", "spacing": 5, "biomes": {"grassland": 2}},
              {"name": "baobab", "max_slope_deg": 10, "biomes": {"beach": 1}}]}})");
  const Recipe recipe = read_recipe(text);
  EXPECT_EQ(write_recipe(read_recipe(write_recipe(recipe))), write_recipe(recipe));
  const PlantTable& trees = recipe.inputs.plants.trees;
  EXPECT_EQ(trees.density[int(Biome::Grassland)], 50.0);
  EXPECT_EQ(trees.density[int(Biome::Taiga)], tree_table().density[int(Biome::Taiga)]);
  ASSERT_EQ(trees.kinds.size(), tree_table().kinds.size() + 1);
  EXPECT_EQ(trees.kinds[0].spacing, 5.0);
  EXPECT_EQ(trees.kinds[0].weight[int(Biome::Taiga)], 0.0);
  EXPECT_EQ(trees.kinds[0].weight[int(Biome::Grassland)], 2.0);
  EXPECT_EQ(trees.kinds.back().name, "baobab");
  EXPECT_EQ(trees.kinds.back().max_slope_deg, 10.0);
  EXPECT_NO_THROW(grown(text));
}

TEST(VegetationStages, TablesThatCannotBeAreRefused) {
  const auto refused = [](const std::string& table, const char* says) {
    try {
      read_recipe(document(R"(, "plants": {"trees": )" + table + "}"));
      ADD_FAILURE() << table;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(says), std::string::npos) << error.what();
    }
  };
  refused(R"({"density": {"jungle": 5}})", "plants.trees.density: there is no biome 'jungle'");
  refused(R"({"density": {"taiga": -5}})", "plants.trees.density.taiga");
  refused(R"({"kinds": [{"biomes": {}}]})", "plants.trees.kinds[0]: member 'name'");
  refused(R"({"kinds": [{"name": "oak", "height": 3}]})", "height");
  refused(R"({"kinds": [{"name": "oak", "spacing": 1000}]})", "spacing");
  refused(R"({"kinds": [{"name": "oak", "min_scale": 9}]})", "min_scale");
  refused(R"({"shrubs": {}})", "shrubs");
}

}  // namespace
}  // namespace orogen
