#include "pipeline/recipe_inputs.h"

#include <gtest/gtest.h>

#include "foundation/errors.h"
#include "pipeline/recipe.h"

namespace orogen {
namespace {

std::vector<MotionPhase> phases(const std::string& text) {
  return read_phases({parse_strict_json(text), "phases"});
}

StratigraphicColumn column(const std::string& text) {
  return read_column({parse_strict_json(text), "column"});
}

template <class Read>
std::string refusal(Read&& read, const std::string& text) {
  try {
    read(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(RecipeInputs, ReadsPhases) {
  const auto list = phases(R"([
    {"years": 2e6, "plates": [
      {"points": [[0, 0], [10, 0]], "arrows": [[1, 2], [3, 4]], "name": "a"},
      {"points": [[50, 0]], "arrows": [[0, 0]], "crust": "oceanic", "stable": true}]},
    {"plates": [{"points": [[0, 0]], "arrows": [[1, 2]], "stable": false}]}])");
  ASSERT_EQ(list.size(), 2u);
  EXPECT_EQ(list[0].years, 2e6);
  EXPECT_EQ(list[0].stable_plate, 1);
  ASSERT_EQ(list[0].plates.size(), 2u);
  EXPECT_EQ(list[0].plates[0].points[1], glm::dvec2(10, 0));
  EXPECT_EQ(list[0].plates[0].arrows[1], glm::dvec2(3, 4));
  EXPECT_EQ(list[0].plates[0].name, "a");
  EXPECT_EQ(list[0].plates[0].crust, PlateCrust::Continental);
  EXPECT_EQ(list[0].plates[1].crust, PlateCrust::Oceanic);
  EXPECT_EQ(list[1].stable_plate, -1);
}

TEST(RecipeInputs, RefusesPhasesAndNamesThePlace) {
  const auto says = [](const std::string& text) { return refusal(phases, text); };
  EXPECT_EQ(says("[]").find("phases: 1 to 100"), 0u);
  EXPECT_EQ(says("3").find("phases: 3"), 0u);
  EXPECT_EQ(says(R"([{"plates": [{"points": [[0, 0]], "arrows": []}]}])")
                .find("phases[0].plates[0].arrows"),
            0u);
  EXPECT_EQ(says(R"([{"plates": [{"points": [[0, 0, 1]], "arrows": [[1, 1]]}]}])")
                .find("phases[0].plates[0].points[0]: two numbers"),
            0u);
  EXPECT_EQ(says(R"([{"years": -1, "plates": []}])").find("phases[0].years: -1"), 0u);
  EXPECT_EQ(says(R"([{"plates": [{"points": [[0, 0]], "arrows": [[1, 1]], "crust": "cheese"}]}])")
                .find("phases[0].plates[0].crust"),
            0u);
  EXPECT_NE(says(R"([{"plates": [
      {"points": [[0, 0]], "arrows": [[1, 1]], "stable": true},
      {"points": [[9, 0]], "arrows": [[1, 1]], "stable": true}]}])")
                .find("plates[1]: another"),
            std::string::npos);
}

TEST(RecipeInputs, ReadsFoldEdits) {
  const auto read = [](const std::string& text) {
    return read_fold_edits({parse_strict_json(text), "fold_edits"});
  };
  const auto edits = read(R"([
    {"edit": "set", "layer": 2, "phase": 3, "from": [1, 2], "to": [3, 4], "value": 800},
    {"edit": "remove", "layer": 1, "from": [1, 2], "to": [3, 4]}])");
  ASSERT_EQ(edits.size(), 2u);
  EXPECT_EQ(edits[0].edit.kind, FoldEditKind::Set);
  EXPECT_EQ(edits[0].layer, 1);
  EXPECT_EQ(edits[0].phase, 2);
  EXPECT_EQ(edits[0].edit.b, glm::dvec2(3, 4));
  EXPECT_EQ(edits[0].edit.value, 800.0);
  EXPECT_EQ(edits[1].edit.kind, FoldEditKind::Remove);
  EXPECT_EQ(edits[1].phase, 0);
  EXPECT_EQ(refusal(read, R"([{"edit": "bend", "layer": 1, "from": [0, 0], "to": [1, 1]}])")
                .find("fold_edits[0].edit: add"),
            0u);
  EXPECT_EQ(refusal(read, R"([{"edit": "add", "layer": 0, "from": [0, 0], "to": [1, 1]}])")
                .find("fold_edits[0].layer: 0"),
            0u);
}

TEST(RecipeInputs, ReadsColumns) {
  EXPECT_EQ(column(R"({"preset": "jura"})").layers.size(), preset_column("jura").layers.size());
  const auto own = column(R"({
    "basement": {"sub_layers": [{"lithology": "gneiss"}]},
    "layers": [{"name": "beds", "thickness": 900, "viscosity": 1e19, "fold_wavelength": 5000,
                "fold_share": 0.3, "thickness_map": [[100, 200, 300], [400, 500, 600]],
                "sub_layers": [{"lithology": "marl", "share": 2},
                               {"lithology": "limestone", "resistance": 0.9}]}]})");
  ASSERT_EQ(own.layers.size(), 1u);
  const Layer& layer = own.layers[0];
  EXPECT_EQ(own.basement.sub_layers[0].lithology, Lithology::Gneiss);
  EXPECT_EQ(layer.name, "beds");
  EXPECT_EQ(layer.thickness, 900.0);
  EXPECT_EQ(layer.viscosity, 1e19);
  EXPECT_EQ(layer.fold_wavelength, 5000.0);
  EXPECT_EQ(layer.fold_share, 0.3);
  EXPECT_EQ(layer.sub_layers[0].share, 2.0);
  EXPECT_EQ(layer.sub_layers[1].resistance, 0.9);
  ASSERT_TRUE(layer.thickness_map);
  EXPECT_EQ(layer.thickness_map->columns, 3);
  EXPECT_EQ(layer.thickness_map->values[4], 500.0);
}

TEST(RecipeInputs, WritesColumnsThatReadTheSame) {
  for (const auto name : column_names()) {
    StratigraphicColumn preset = preset_column(name);
    preset.layers[0].thickness_map = CornerMap{2, 2, {1, 2, 3, 4}};
    preset.layers[0].sub_layers[0].resistance = 0.25;
    const auto json = write_column(preset);
    EXPECT_EQ(write_column(read_column({json, "column"})), json);
    EXPECT_EQ(json["layers"][0]["thickness_map"][1][0], 3.0);
    EXPECT_EQ(json["layers"].size(), preset.layers.size());
  }
}

TEST(RecipeInputs, RefusesColumnsAndNamesThePlace) {
  const auto says = [](const std::string& text) { return refusal(column, text); };
  EXPECT_EQ(says(R"({"preset": "cheese"})").find("column.preset: there is no column 'cheese'"), 0u);
  EXPECT_EQ(says(R"({"preset": "jura", "layers": []})").find("column: there is no member"), 0u);
  const auto with = [&](const std::string& layer) {
    return says(R"({"basement": {"sub_layers": [{"lithology": "gneiss"}]}, "layers": [)" + layer +
                "]}");
  };
  EXPECT_EQ(with("").find("column.layers: 0 are not allowed"), 0u);
  EXPECT_EQ(with(R"({"sub_layers": [{"lithology": "cheese"}]})")
                .find("column.layers[0].sub_layers[0].lithology: no such rock"),
            0u);
  EXPECT_EQ(with(R"({"thickness": 0, "sub_layers": [{"lithology": "marl"}]})")
                .find("column.layers[0].thickness: 0"),
            0u);
  EXPECT_EQ(with(R"({"sub_layers": [{"lithology": "marl"}], "thickness_map": [[1, 2], [3]]})")
                .find("column.layers[0].thickness_map[1]"),
            0u);
}

TEST(RecipeInputs, ReadsRain) {
  const auto rain = [](const std::string& text) {
    return read_rain({parse_strict_json(text), "rain"});
  };
  const CornerMap map = rain("[[1, 2, 3], [4, 5, 600.5]]");
  EXPECT_EQ(map.rows, 2);
  EXPECT_EQ(map.columns, 3);
  EXPECT_EQ(map.values, (std::vector<double>{1, 2, 3, 4, 5, 600.5}));
  const auto says = [&](const std::string& text) { return refusal(rain, text); };
  EXPECT_EQ(says("[[1, -2]]").find("rain[0][1]: -2"), 0u);
  EXPECT_EQ(says("[[1, 2], [3]]").find("rain[1]: "), 0u);
  EXPECT_EQ(says("[]").find("rain: "), 0u);
  EXPECT_EQ(says("[[]]").find("rain[0]: "), 0u);
  EXPECT_EQ(says("[[0, 0]]").find("rain: "), 0u);
  EXPECT_EQ(says("3").find("rain: "), 0u);
}

}  // namespace
}  // namespace orogen
