// A recipe's tables of plants, from JSON and to it.
//
//   "plants": {"trees": table, "ground_cover": table}
//     table: {"density": {"taiga": 600, ...},                                 plants a hectare
//             "kinds": [{"name": "norway_spruce", "spacing": 2, "max_altitude": 1800,
//                        "biomes": {"taiga": 3, "tundra": 1}}, ...]}
//
// A table changes the built-in one (vegetation/plant_table.h): biomes and kinds that it names, no
// others. A kind's `biomes`, weights beside the other kinds', take the place of those that it had;
// a new name is a new kind.
#pragma once

#include "pipeline/strict_json.h"
#include "vegetation/planting.h"

namespace orogen {

PlantTable read_plant_table(const JsonValue& table, PlantTable base);
nlohmann::json write_plant_table(const PlantTable& table);

PlantTables read_plants(const JsonValue& plants);

}  // namespace orogen
