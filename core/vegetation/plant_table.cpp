#include "vegetation/plant_table.h"

#include <initializer_list>
#include <set>
#include <utility>

#include "foundation/errors.h"

namespace orogen {

namespace {

using enum Biome;

OfBiomes of_biomes(std::initializer_list<std::pair<Biome, double>> values) {
  OfBiomes all{};
  for (const auto& [biome, value] : values) all[std::size_t(biome)] = value;
  return all;
}

/// Altitudes stay open: biomes know how warm it is.
PlantKind kind(std::string name, double spacing, double max_slope_deg,
               std::initializer_list<std::pair<Biome, double>> weight) {
  PlantKind made;
  made.name = std::move(name);
  made.weight = of_biomes(weight);
  made.spacing = spacing;
  made.max_slope_deg = max_slope_deg;
  return made;
}

PlantTable make_trees() {
  PlantTable table;
  table.density = of_biomes({{Tundra, 20.0},
                             {Bare, 3.0},
                             {Scorched, 6.0},
                             {Taiga, 750.0},
                             {Shrubland, 300.0},
                             {TemperateDesert, 10.0},
                             {TemperateRainForest, 450.0},
                             {DeciduousForest, 400.0},
                             {Grassland, 6.0},
                             {TropicalRainForest, 500.0},
                             {TropicalSeasonalForest, 220.0},
                             {SubtropicalDesert, 2.0},
                             {Beach, 8.0}});
  table.kinds = {
      kind("norway_spruce", 1.6, 45.0, {{Taiga, 0.55}, {TemperateRainForest, 0.45}}),
      kind("scots_pine", 1.8, 50.0,
           {{Taiga, 0.25}, {TemperateRainForest, 0.1}, {Shrubland, 0.05}, {DeciduousForest, 0.05}}),
      kind("silver_birch", 1.6, 40.0,
           {{Taiga, 0.15}, {DeciduousForest, 0.15}, {Tundra, 0.1}, {Grassland, 0.15}}),
      kind("quaking_aspen", 1.8, 40.0, {{Taiga, 0.04}, {DeciduousForest, 0.1}}),
      kind("european_beech", 2.4, 40.0, {{DeciduousForest, 0.35}, {TemperateRainForest, 0.25}}),
      kind("black_oak", 2.8, 35.0,
           {{DeciduousForest, 0.25},
            {Grassland, 0.4},
            {Shrubland, 0.05},
            {TemperateRainForest, 0.05},
            {TropicalSeasonalForest, 0.1}}),
      kind("weeping_willow", 3.0, 15.0, {{DeciduousForest, 0.02}, {Grassland, 0.1}}),
      kind("italian_cypress", 1.5, 40.0, {{Shrubland, 0.05}}),
      kind("black_tupelo", 2.4, 40.0, {{TropicalRainForest, 0.4}, {TropicalSeasonalForest, 0.35}}),
      kind("kapok", 3.5, 35.0, {{TropicalRainForest, 0.06}}),
      kind("umbrella_acacia", 3.0, 30.0,
           {{TropicalSeasonalForest, 0.35}, {SubtropicalDesert, 0.2}, {Grassland, 0.2}}),
      kind("saguaro", 3.0, 35.0, {{SubtropicalDesert, 0.3}}),
      kind("coconut_palm", 2.2, 25.0,
           {{TropicalRainForest, 0.2}, {TropicalSeasonalForest, 0.05}, {Beach, 1.0}}),
      kind("hazel_bush", 1.4, 45.0,
           {{DeciduousForest, 0.08},
            {Shrubland, 0.55},
            {Grassland, 0.15},
            {TemperateRainForest, 0.15},
            {TropicalRainForest, 0.25},
            {TropicalSeasonalForest, 0.15},
            {TemperateDesert, 0.2}}),
      kind("dwarf_juniper", 1.0, 55.0,
           {{Tundra, 0.9},
            {Bare, 1.0},
            {Shrubland, 0.3},
            {TemperateDesert, 0.8},
            {SubtropicalDesert, 0.4}}),
      kind("dead_snag", 1.5, 50.0, {{Scorched, 1.0}, {Taiga, 0.01}, {SubtropicalDesert, 0.1}}),
  };
  return table;
}

PlantTable make_ground_cover() {
  PlantTable table;
  table.density = of_biomes({{Tundra, 5e3},
                             {Bare, 500.0},
                             {Scorched, 200.0},
                             {Taiga, 8e3},
                             {Shrubland, 12e3},
                             {TemperateDesert, 1500.0},
                             {TemperateRainForest, 20e3},
                             {DeciduousForest, 15e3},
                             {Grassland, 40e3},
                             {TropicalRainForest, 20e3},
                             {TropicalSeasonalForest, 20e3},
                             {SubtropicalDesert, 300.0},
                             {Beach, 600.0}});
  table.kinds = {
      kind("meadow_grass", 0.2, 45.0,
           {{Grassland, 0.6},
            {Shrubland, 0.3},
            {DeciduousForest, 0.35},
            {Taiga, 0.2},
            {TemperateRainForest, 0.1},
            {TropicalSeasonalForest, 0.2}}),
      kind("big_bluestem", 0.25, 35.0,
           {{Grassland, 0.22}, {TropicalSeasonalForest, 0.5}, {Beach, 0.5}, {Shrubland, 0.15}}),
      kind("dry_tussock", 0.3, 45.0,
           {{TemperateDesert, 1.0},
            {SubtropicalDesert, 1.0},
            {Shrubland, 0.4},
            {Scorched, 1.0},
            {Beach, 0.5},
            {TropicalSeasonalForest, 0.1}}),
      kind("tundra_sedge", 0.25, 50.0, {{Tundra, 1.0}, {Bare, 1.0}, {Taiga, 0.1}}),
      kind("male_fern", 0.3, 50.0,
           {{TemperateRainForest, 0.8},
            {TropicalRainForest, 0.95},
            {DeciduousForest, 0.4},
            {Taiga, 0.65},
            {TropicalSeasonalForest, 0.2}}),
      kind("common_poppy", 0.2, 40.0, {{Grassland, 0.06}, {Shrubland, 0.1}}),
      kind("oxeye_daisy", 0.2, 40.0,
           {{Grassland, 0.12},
            {DeciduousForest, 0.25},
            {TemperateRainForest, 0.1},
            {TropicalRainForest, 0.05},
            {Shrubland, 0.05},
            {Taiga, 0.05}}),
  };
  return table;
}

[[noreturn]] void refuse(std::string_view place, const std::string& text) {
  throw InputError(std::string(place) + ": " + text);
}

void check_numbers(const OfBiomes& values, double most, const std::string& place) {
  for (std::size_t b = 0; b < values.size(); ++b)
    if (!(values[b] >= 0.0 && values[b] <= most))
      refuse(place + "." + std::string(info(Biome(b)).name),
             detail::format_number(values[b]) + " is not allowed; 0 to " +
                 detail::format_number(most) + " is wanted");
}

}  // namespace

const PlantTable& tree_table() {
  static const PlantTable table = make_trees();
  return table;
}

const PlantTable& ground_cover_table() {
  static const PlantTable table = make_ground_cover();
  return table;
}

void check_plant_table(const PlantTable& table, std::string_view place) {
  check_numbers(table.density, kMostPlants, std::string(place) + ".density");
  if (table.kinds.size() > kMostKinds)
    refuse(place, std::to_string(table.kinds.size()) + " kinds are too many; at most " +
                      std::to_string(kMostKinds));
  std::set<std::string_view> names;
  for (std::size_t k = 0; k < table.kinds.size(); ++k) {
    const PlantKind& kind = table.kinds[k];
    const std::string at = std::string(place) + ".kinds[" + std::to_string(k) + "]";
    if (!names.insert(kind.name).second) refuse(at, "'" + kind.name + "' is there twice");
    check_parameters(kind, at);
    check_numbers(kind.weight, 1e6, at + ".biomes");
    if (kind.min_scale > kind.max_scale) refuse(at, "min_scale is above max_scale");
    if (kind.min_altitude > kind.max_altitude) refuse(at, "min_altitude is above max_altitude");
  }
}

}  // namespace orogen
