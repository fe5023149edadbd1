// What grows on a terrain: trees and ground cover by their tables, ready to be placed.
#pragma once

#include <cstdint>
#include <string_view>
#include <tuple>

#include "foundation/parameters.h"
#include "vegetation/placement.h"
#include "vegetation/plant_table.h"

namespace orogen {

struct PlantTables {
  PlantTable trees = tree_table();
  PlantTable ground_cover = ground_cover_table();
};

struct VegetationParameters {
  double tree_density_factor = 1.0;
  double ground_cover_factor = 1.0;
};

constexpr auto parameter_table(const VegetationParameters*) {
  using P = VegetationParameters;
  return std::tuple{
      real("tree_density_factor", &P::tree_density_factor, 0.0, 100.0, "1",
           "What the number of trees in each biome is multiplied by."),
      real("ground_cover_factor", &P::ground_cover_factor, 0.0, 100.0, "1",
           "What the number of grasses, ferns and flowers in each biome is multiplied by."),
  };
}

struct Planting {
  PlantTables tables;
  VegetationParameters parameters;
  std::uint32_t seed = 0;
};

enum class PlantLayer { Trees, GroundCover };
inline constexpr std::string_view kPlantLayers[] = {"trees", "ground_cover"};

inline const PlantTable& table_of(const Planting& planting, PlantLayer layer) {
  return layer == PlantLayer::Trees ? planting.tables.trees : planting.tables.ground_cover;
}

inline double factor_of(const Planting& planting, PlantLayer layer) {
  return layer == PlantLayer::Trees ? planting.parameters.tree_density_factor
                                    : planting.parameters.ground_cover_factor;
}

/// The plants of one layer; `region` and `most_plants` as in placement.h.
inline PlantCloud plants_of(const Planting& planting, PlantLayer layer, const PlantGround& ground,
                            const std::optional<PlantRegion>& region, int most_plants,
                            const Context& context) {
  return place_plants(ground, table_of(planting, layer), {factor_of(planting, layer), most_plants},
                      region, planting.seed + std::uint32_t(layer), context);
}

}  // namespace orogen
