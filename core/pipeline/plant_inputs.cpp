#include "pipeline/plant_inputs.h"

#include <algorithm>

namespace orogen {

namespace {

constexpr double kLargestWeight = 1e6;

OfBiomes read_of_biomes(const JsonValue& object, OfBiomes values, double most) {
  if (!object.json().is_object()) object.refuse("an object of biomes and numbers is wanted");
  for (const auto& [name, value] : object.json().items()) {
    const auto found = std::ranges::find(biomes(), std::string_view(name), &BiomeInfo::name);
    if (found == biomes().end()) object.refuse("there is no biome '" + name.substr(0, 60) + "'");
    values[std::size_t(found - biomes().begin())] =
        JsonValue(value, object.place() + "." + name).number(0.0, most);
  }
  return values;
}

nlohmann::json write_of_biomes(const OfBiomes& values) {
  nlohmann::json object = nlohmann::json::object();
  for (std::size_t b = 0; b < values.size(); ++b)
    if (values[b] > 0.0) object[std::string(info(Biome(b)).name)] = values[b];
  return object;
}

void read_kind(const JsonValue& item, PlantKind& kind) {
  if (item.has("biomes")) kind.weight = read_of_biomes(item.member("biomes"), {}, kLargestWeight);
  for (const auto& [name, value] : item.json().items()) {
    if (name == "name" || name == "biomes") continue;
    const JsonValue number(value, item.place() + "." + name);
    if (!value.is_number()) number.refuse("a number is wanted");
    set_parameter(kind, name, value.get<double>(), item.place());
  }
}

PlantKind& find_or_add(std::vector<PlantKind>& kinds, const std::string& name) {
  const auto found = std::ranges::find(kinds, name, &PlantKind::name);
  if (found != kinds.end()) return *found;
  kinds.emplace_back().name = name;
  return kinds.back();
}

}  // namespace

PlantTable read_plant_table(const JsonValue& table, PlantTable base) {
  table.only_members({"density", "kinds"});
  if (table.has("density"))
    base.density = read_of_biomes(table.member("density"), base.density, kMostPlants);
  if (table.has("kinds")) {
    const JsonValue kinds = table.member("kinds");
    for (std::size_t i = 0; i < kinds.array_size(); ++i) {
      const JsonValue item = kinds.element(i);
      if (!item.json().is_object()) item.refuse("an object is wanted");
      read_kind(item, find_or_add(base.kinds, item.member("name").text(100)));
    }
  }
  check_plant_table(base, table.place());
  return base;
}

nlohmann::json write_plant_table(const PlantTable& table) {
  nlohmann::json kinds = nlohmann::json::array();
  for (const PlantKind& kind : table.kinds) {
    nlohmann::json item{{"name", kind.name}, {"biomes", write_of_biomes(kind.weight)}};
    for (const auto& [name, value] : parameter_values(kind)) item[name] = std::get<double>(value);
    kinds.push_back(std::move(item));
  }
  return {{"density", write_of_biomes(table.density)}, {"kinds", std::move(kinds)}};
}

PlantTables read_plants(const JsonValue& plants) {
  plants.only_members({"trees", "ground_cover"});
  PlantTables tables;
  if (plants.has("trees")) tables.trees = read_plant_table(plants.member("trees"), tables.trees);
  if (plants.has("ground_cover"))
    tables.ground_cover = read_plant_table(plants.member("ground_cover"), tables.ground_cover);
  return tables;
}

}  // namespace orogen
