// Lakes, climate and biomes in recipes.
#include <gtest/gtest.h>

#include <algorithm>

#include "climate/biomes.h"
#include "foundation/errors.h"
#include "pipeline/pipeline.h"

namespace orogen {
namespace {

std::string document(const std::string& stages, const std::string& rasters = "") {
  return R"({"orogen": 1, "resolution": 96, "extent": {"origin": [0, 0], "size": [48000, 48000]},
    "rasters": {"elevation": [[-400, -200, 600], [-200, 800, 2600], [200, 900, 3400]])" +
         rasters +
         R"(}, "stages": [{"stage": "given_elevation", "parameters": {"roughness": 0}}, )" +
         stages + "]}";
}

Terrain grown(const std::string& text) {
  Context context;
  return generate(read_recipe(text), {}, context, nullptr).terrain;
}

constexpr const char* kClimate = R"({"stage": "lakes"}, {"stage": "climate"}, )";

TEST(ClimateStages, MakeBiomesOfGivenHeights) {
  for (const char* by : {"paper", "whittaker", "holdridge"}) {
    const Terrain made = grown(document(std::string(kClimate) + R"({"stage": "biomes", "parameters":
          {"classification": ")" + by + "\"}}"));
    const auto& biome = made.integer("biome");
    EXPECT_EQ(biome(0, 0), int(Biome::Ocean));
    EXPECT_EQ(biome(95, 95), int(Biome::Snow)) << by;
    EXPECT_LT(biome(48, 48), int(Biome::Beach)) << by;
    EXPECT_NE(biome(48, 48), int(Biome::Snow)) << by;
  }
}

TEST(ClimateStages, PaintStandsAndStaysInTheRecipe) {
  const std::string text = document(std::string(kClimate) + R"({"stage": "biomes"})",
                                    R"(, "biome": [[4, -1, -1], [-1, -1, -1], [-1, -1, 12]])");
  const Recipe recipe = read_recipe(text);
  EXPECT_EQ(write_recipe(read_recipe(write_recipe(recipe))), write_recipe(recipe));
  const Terrain made = grown(text);
  const Terrain plain = grown(document(std::string(kClimate) + R"({"stage": "biomes"})"));
  const auto& biome = made.integer("biome");
  for (int r = 0; r < 96; ++r)
    for (int c = 0; c < 96; ++c) {
      const bool painted = r >= 64 && c >= 64;
      ASSERT_EQ(biome(r, c), painted ? 12 : plain.integer("biome")(r, c)) << r << " " << c;
    }
}

TEST(ClimateStages, RefuseWhatCannotBe) {
  const auto refused = [](const std::string& text, const char* says) {
    try {
      grown(text);
      ADD_FAILURE() << text;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(says), std::string::npos) << error.what();
    }
  };
  const std::string all = std::string(kClimate) + R"({"stage": "biomes"})";
  refused(document(all, R"(, "biome": [[14]])"), "rasters.biome");
  refused(document(all, R"(, "biome": [[2.5]])"), "whole");
  refused(document(R"({"stage": "biomes"})"), "temperature");
  refused(R"({"orogen": 1, "resolution": 32, "extent": {"origin": [0, 0], "size": [9e3, 9e3]},
    "stages": [{"stage": "island"}, {"stage": "biomes",
                "parameters": {"classification": "whittaker"}}]})",
          "air_temperature");
}

TEST(ClimateStages, LakesOfAnIslandAreLevelAfterErosion) {
  const Terrain made = grown(
      R"({"orogen": 1, "resolution": 160, "extent": {"origin": [0, 0], "size": [40000, 40000]},
    "stages": [{"stage": "island"}, {"stage": "hydraulic_erosion", "parameters": {"duration": 30}},
               {"stage": "lakes", "parameters": {"new_lakes": true}}, {"stage": "biomes"}]})");
  const auto& depth = made.real("water_depth");
  const auto& elevation = made.real("elevation");
  const auto& biome = made.integer("biome");
  int lakes = 0;
  for (int r = 0; r < 160; ++r)
    for (int c = 0; c + 1 < 160; ++c) {
      const std::size_t i = depth.grid().index(r, c);
      lakes += depth[i] > 0.0f;
      EXPECT_EQ(biome[i] == int(Biome::Lake), depth[i] > 0.0f);
      if (depth[i] > 0.0f && depth[i + 1] > 0.0f) {
        ASSERT_NEAR(elevation[i] + depth[i], elevation[i + 1] + depth[i + 1], 1e-3);
      }
    }
  EXPECT_GT(lakes, 20);
}

}  // namespace
}  // namespace orogen
