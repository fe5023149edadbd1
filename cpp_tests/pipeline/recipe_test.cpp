#include "pipeline/recipe.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "island.h"
#include "pipeline/sha256.h"

namespace orogen {
namespace {

std::string refusal(const std::string& document) {
  try {
    read_recipe(document);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

std::string with_stages(const std::string& stages) {
  return island_document(", \"stages\": " + stages);
}

TEST(Recipe, ReadsWhatIsWritten) {
  const Recipe recipe = read_recipe(with_stages(
      R"([{"stage": "land"}, {"stage": "plates", "parameters": {"plate_speed": 0.03}}])"));
  EXPECT_EQ(recipe.name, "island");
  EXPECT_EQ(recipe.seed, 7u);
  EXPECT_EQ(recipe.resolution, 64);
  ASSERT_EQ(recipe.stages.size(), 2u);
  EXPECT_EQ(std::get<double>(recipe.stages[1].parameters.at("plate_speed")), 0.03);
  EXPECT_EQ(recipe.inputs.map->peaks.size(), 4u);

  const std::string text = write_recipe(recipe);
  const Recipe again = read_recipe(text);
  EXPECT_EQ(write_recipe(again), text);
  EXPECT_EQ(recipe_hash(again), recipe_hash(recipe));
  EXPECT_EQ(recipe_hash(recipe), sha256(text));
  EXPECT_EQ(write_recipe(read_recipe(write_recipe(recipe, 2))), text);
}

TEST(Recipe, IsCanonical) {
  const auto hash = [](const std::string& number) {
    return recipe_hash(
        read_recipe(with_stages(R"([{"stage": "plates", "parameters": {"plate_speed": )" + number +
                                R"(, "boundary_roughness": 1000}}])")));
  };
  EXPECT_EQ(hash("0.03"), hash("3e-2"));
  EXPECT_NE(hash("0.03"), hash("0.030000001"));
  // A whole number given for a real parameter is that real number.
  const auto roughness = [](const std::string& number) {
    return recipe_hash(read_recipe(with_stages(
        R"([{"stage": "plates", "parameters": {"boundary_roughness": )" + number + "}}]")));
  };
  EXPECT_EQ(roughness("1000"), roughness("1000.0"));
}

TEST(Recipe, TakesABareMap) {
  const Recipe recipe = read_recipe(island_geojson());
  EXPECT_EQ(recipe.name, "island");
  EXPECT_EQ(recipe.stages.size(), default_stages().size());
  EXPECT_EQ(recipe.resolution, Recipe{}.resolution);
}

TEST(Recipe, MakesTheDefaultForAMapInMemory) {
  const Recipe from_text = read_recipe(island_geojson());
  const Recipe recipe = default_recipe(*from_text.inputs.map);
  EXPECT_EQ(*recipe.inputs.map, *from_text.inputs.map);
  EXPECT_EQ(*read_recipe(write_recipe(recipe)).inputs.map, *from_text.inputs.map);
}

TEST(Recipe, FindsTheMapBesideIt) {
  const auto folder = std::filesystem::temp_directory_path() / "orogen_recipe_test";
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "map.geojson") << island_geojson();
  std::ofstream(folder / "some.orogen.json")
      << R"({"orogen": 1, "map": {"file": "map.geojson"}, "stages": []})";
  const Recipe recipe = load_recipe(folder / "some.orogen.json");
  EXPECT_EQ(recipe.name, "some");
  EXPECT_EQ(recipe.inputs.map->coasts.size(), 1u);
  EXPECT_EQ(load_recipe(folder / "map.geojson").name, "island");
  EXPECT_THROW(load_recipe(folder / "missing.orogen.json"), InputError);
  std::filesystem::remove_all(folder);
}

TEST(Recipe, TheGridCoversTheFrameOrTheExtent) {
  const Grid frame = recipe_grid(island_recipe());
  EXPECT_EQ(frame.nx, 64);
  EXPECT_EQ(frame.ny, 48);
  EXPECT_EQ(frame.cell_size, 625.0);
  EXPECT_EQ(frame.origin, glm::dvec2(-20000.0, -15000.0));
  const Grid part = recipe_grid(
      read_recipe(island_document(R"(, "extent": {"origin": [-1000, 0], "size": [2000, 500]})")),
      100);
  EXPECT_EQ(part, (Grid{100, 25, 20.0, {-1000.0, 0.0}}));
  EXPECT_THROW(recipe_grid(island_recipe(), 1), InputError);
  EXPECT_THROW(recipe_grid(island_recipe(), kMaxResolution + 1), InputError);
}

struct Refusal {
  std::string document, says;
};

TEST(Recipe, RefusesAndNamesThePlace) {
  const Refusal cases[] = {
      {"", "no valid JSON"},
      {"{\"orogen\": 1", "no valid JSON"},
      {"[]", "neither a recipe"},
      {"{}", "neither a recipe"},
      {R"({"orogen": 1})", "member 'extent'"},
      {R"({"orogen": 2, "map": {}})", "orogen: 2 is not allowed"},
      {R"({"orogen": "1", "map": {}})", "orogen: \"1\" is not allowed"},
      {R"({"orogen": 1, "orogen": 1, "map": {}})", "stands twice"},
      {R"({"orogen": 1, "map": 3})", "map: a GeoJSON object"},
      {R"({"orogen": 1, "map": {"file": "/etc/passwd"}})", "map.file: a path relative"},
      {R"({"orogen": 1, "map": {"file": "no/such/file"}})", "cannot be read"},
      {R"({"orogen": 1, "map": {"file": "a", "type": "b"}})", "map: there is no member 'type'"},
      {R"({"orogen": 1, "map": {"type": "FeatureCollection", "features": []}})", "map: "},
      {island_document(R"(, "sed": 1)"), "there is no member 'sed'"},
      {R"({"orogen": 1, "seed": -1, "map": {}})", "seed: -1 is not allowed"},
      {R"({"orogen": 1, "seed": 4294967296, "map": {}})", "seed: 4294967296 is not allowed"},
      {R"({"orogen": 1, "seed": 1.5, "map": {}})", "seed: 1.5 is not allowed"},
      {R"({"orogen": 1, "seed": 18446744073709551615, "map": {}})", "seed: 18446744073709551615"},
      {R"({"orogen": 1, "resolution": 1, "map": {}})", "resolution: 1 is not allowed"},
      {R"({"orogen": 1, "name": 5, "map": {}})", "name: 5 is not allowed"},
      {island_document(R"(, "extent": {"origin": [0, 0]})"), "extent: member 'size' is missing"},
      {island_document(R"(, "extent": {"origin": [0], "size": [1, 1]})"), "extent.origin: two"},
      {island_document(R"(, "extent": {"origin": [0, 0], "size": [1, -1]})"), "extent.size[1]: -1"},
      {with_stages("{}"), "stages: an object is not allowed"},
      {with_stages("[3]"), "stages[0]: 3 is not allowed"},
      {with_stages("[{}]"), "stages[0]: member 'stage' is missing"},
      {with_stages(R"([{"stage": "lnad"}])"), "stages[0].stage: there is no stage 'lnad'"},
      {with_stages(R"([{"stage": "land", "params": {}}])"), "stages[0]: there is no member"},
      {with_stages(R"([{"stage": "land", "parameters": []}])"), "stages[0].parameters: an object"},
      {with_stages(R"([{"stage": "land"}, {"stage": "plates", "parameters": {"speed": 1}}])"),
       "stages[1].parameters.speed: no such parameter"},
      {with_stages(R"([{"stage": "plates", "parameters": {"plate_speed": "fast"}}])"),
       "stages[0].parameters.plate_speed: 'fast' is not allowed"},
      {with_stages(R"([{"stage": "plates", "parameters": {"plate_speed": 1e3}}])"),
       "stages[0].parameters.plate_speed: 1000 is not allowed"},
      {with_stages(R"([{"stage": "plates", "parameters": {"plate_speed": null}}])"),
       "stages[0].parameters.plate_speed: a number, true, false or text is wanted"},
      {with_stages(R"([{"stage": "boundaries"}])"),
       "stages[0]: stage 'boundaries' reads the field 'plate', which no stage before it writes; "
       "plates must come first"},
  };
  for (const auto& [document, says] : cases) {
    const std::string why = refusal(document);
    EXPECT_NE(why.find(says), std::string::npos) << document << "\n  " << why;
    EXPECT_EQ(why.find('\n'), std::string::npos) << why;
  }
}

TEST(Recipe, RefusesDeepNesting) {
  const std::string deep = R"({"orogen": 1, "map": )" + std::string(100000, '[');
  EXPECT_NE(refusal(deep).find("nested deeper than 64"), std::string::npos);
}

}  // namespace
}  // namespace orogen
