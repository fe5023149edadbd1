// Plants of a terrain that the stage `vegetation` has settled.
#pragma once

#include "pipeline/terrain.h"
#include "vegetation/planting.h"

namespace orogen {

/// The terrain as plants find it. std::out_of_range if it lacks elevation or biomes.
PlantGround plant_ground(const Terrain& terrain);

}  // namespace orogen
