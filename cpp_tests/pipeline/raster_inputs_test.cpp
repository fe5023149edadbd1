#include "pipeline/raster_inputs.h"

#include <gtest/gtest.h>

#include <cmath>

#include "foundation/errors.h"
#include "island.h"
#include "pipeline/pipeline.h"

namespace orogen {
namespace {

GivenRasters rasters(const std::string& text) {
  return read_rasters({parse_strict_json(text), "rasters"});
}

std::string refusal(const std::string& text) {
  try {
    rasters(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

std::string packed(const GivenRaster& raster, const std::string& name) {
  return R"({")" + name + R"(": )" + write_raster(raster).dump() + "}";
}

TEST(RasterInputs, ReadsRows) {
  const GivenRasters read = rasters(R"({"uplift_factor": [[1, 2, 3], [4, 5, 6]]})");
  const GivenRaster& one = *read.at("uplift_factor");
  EXPECT_EQ(one.rows, 2);
  EXPECT_EQ(one.columns, 3);
  EXPECT_EQ(one.values, (std::vector<float>{1, 2, 3, 4, 5, 6}));
}

TEST(RasterInputs, PackedValuesAreTheSameToTheBit) {
  for (int columns = 1; columns < 9; ++columns) {
    GivenRaster raster{1, columns, {}};
    for (int c = 0; c < columns; ++c) raster.values.push_back(0.1f + float(c) / 7.0f);
    EXPECT_EQ(rasters(packed(raster, "uplift_factor")).at("uplift_factor")->values, raster.values);
  }
}

TEST(RasterInputs, PackedIsBase64OfLittleEndianFloats) {
  EXPECT_EQ(write_raster({1, 1, {1.0f}})["float32"], "AACAPw==");
  EXPECT_EQ(write_raster({1, 2, {1.0f, -2.5f}})["float32"], "AACAPwAAIMA=");
}

TEST(RasterInputs, RefusesAndNamesThePlace) {
  const auto begins = [](const std::string& text, const std::string& with) {
    EXPECT_EQ(refusal(text).find(with), 0u) << refusal(text);
  };
  begins("[]", "rasters: an object");
  begins(R"({"height": [[1]]})", "rasters: there is no raster 'height'");
  begins(R"({"kept": []})", "rasters.kept: at least one row");
  begins(R"({"kept": [[]]})", "rasters.kept[0]: at least one number");
  begins(R"({"kept": [[1, 0], [1]]})", "rasters.kept[1]: every row");
  begins(R"({"kept": [[1, 2]]})", "rasters.kept: row 0, column 1: 2 is not allowed; 0 to 1");
  begins(R"({"elevation": {"rows": 1, "columns": 2, "float32": "AACAPw=="}})",
         "rasters.elevation.float32: 4 bytes");
  begins(R"({"elevation": {"rows": 1, "columns": 1, "float32": "AAC*Pw=="}})",
         "rasters.elevation.float32: is no base64");
  begins(R"({"elevation": {"rows": 1, "columns": 1, "float32": "AACAP"}})",
         "rasters.elevation.float32: is no base64");
  begins(R"({"elevation": {"rows": 0, "columns": 1, "float32": ""}})", "rasters.elevation.rows: 0");
  begins(packed({1, 1, {std::nanf("")}}, "elevation"), "rasters.elevation: row 0, column 0");
}

std::string heights_document(const std::string& more = "") {
  return R"({"orogen": 1, "resolution": 64, "extent": {"origin": [0, 0], "size": [32000, 32000]},
    "rasters": {"elevation": [[-100, 300, 300], [-100, 900, 1400], [-100, 300, 300]])" +
         more + "}}";
}

Generated grow(const std::string& document, Cache* cache = nullptr) {
  Context context;
  return generate(read_recipe(document), {}, context, cache);
}

TEST(RasterInputs, ARecipeOfHeightsIsWornByRivers) {
  const Generated made = grow(heights_document());
  const auto& z = made.terrain.real("elevation");
  const auto& land = made.terrain.integer("land");
  EXPECT_EQ(land(32, 0), 0);
  EXPECT_EQ(land(32, 40), 1);
  Context context;
  const Recipe bare = read_recipe(heights_document());
  const Raster<float> given = bare.inputs.raster("elevation", z.grid(), context);
  double before = 0.0, after = 0.0;
  for (std::size_t i = 0; i < z.size(); ++i) {
    if (!land[i]) {
      EXPECT_EQ(z[i], given[i]);
    } else {
      EXPECT_LE(z[i], given[i] + 240.0f);  // and its roughness
      before += given[i];
      after += z[i];
    }
  }
  EXPECT_LT(after, 0.95 * before);
  EXPECT_GT(after, 0.2 * before);
}

TEST(RasterInputs, RecipesKeepTheirRasters) {
  const Recipe recipe = read_recipe(heights_document(R"(, "uplift_factor": [[1.5]])"));
  const Recipe again = read_recipe(write_recipe(recipe));
  EXPECT_EQ(write_recipe(again), write_recipe(recipe));
  EXPECT_EQ(again.inputs.rasters.at("elevation")->values,
            recipe.inputs.rasters.at("elevation")->values);
  EXPECT_EQ(recipe.stages.size(), default_stages(DefaultFor::Heights).size());
}

TEST(RasterInputs, ANewRasterRunsOnlyTheStagesThatReadIt) {
  Cache cache;
  grow(heights_document(), &cache);
  const Generated made = grow(heights_document(R"(, "erodibility_factor": [[2]])"), &cache);
  for (const StageTime& time : made.stages)
    EXPECT_EQ(time.cached, time.stage == "given_elevation") << time.stage;
}

TEST(RasterInputs, StagesThatNeedARasterSaySo) {
  const std::string stages = R"(, "stages": [{"stage": "given_elevation"}])";
  try {
    read_recipe(island_document(stages));
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("needs 'rasters.elevation'"), std::string::npos);
  }
}

/// Mean height of the western and the eastern half of the land.
std::pair<double, double> halves(const Generated& made) {
  const auto& z = made.terrain.real("elevation");
  const Grid& grid = z.grid();
  double sum[2] = {0.0, 0.0};
  for (int r = 0; r < grid.ny; ++r)
    for (int c = 0; c < grid.nx; ++c) sum[c >= grid.nx / 2] += std::max(z(r, c), 0.0f);
  return {sum[0], sum[1]};
}

TEST(RasterInputs, MoreUpliftMakesHigherGroundWhereItIsPainted) {
  const std::string factor = R"(, "rasters": {"uplift_factor": [[0.4, 1]]})";
  const auto plain = halves(grow(collision_document()));
  const auto painted = halves(grow(collision_document(factor)));
  EXPECT_LT(painted.first / painted.second, 0.7 * plain.first / plain.second);
  const auto map = halves(grow(island_document()));
  const auto painted_map = halves(grow(island_document(factor)));
  EXPECT_LT(painted_map.first / painted_map.second, 0.9 * map.first / map.second);
}

TEST(RasterInputs, WeakerRockLiesLowerWhereItIsPainted) {
  const std::string factor = R"(, "rasters": {"erodibility_factor": [[4, 1]]})";
  const auto plain = halves(grow(collision_document()));
  const auto painted = halves(grow(collision_document(factor)));
  EXPECT_LT(painted.first / painted.second, 0.8 * plain.first / plain.second);
}

TEST(RasterInputs, AFactorOfOneChangesNothing) {
  const std::string ones =
      R"(, "rasters": {"uplift_factor": [[1, 1], [1, 1]], "erodibility_factor": [[1]]})";
  for (const auto document : {island_document, collision_document})
    EXPECT_EQ(grow(document("")).terrain.real("elevation"),
              grow(document(ones)).terrain.real("elevation"));
}

}  // namespace
}  // namespace orogen
