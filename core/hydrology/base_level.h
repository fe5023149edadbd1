// Where the water of a map's terrain leaves it: the sea at height 0, and the ends of rivers at the
// frame at their own heights. Where a map has neither, all sides of the grid are open.
// Elsewhere the sides that cut the land let nothing through.
#pragma once

#include "foundation/raster.h"
#include "hydrology/river_beds.h"
#include "inputs/vector_map.h"

namespace orogen {

struct BaseLevel {
  Raster<std::uint8_t> cells;  // not 0: water leaves here
  Raster<float> height;        // m, of those cells; 0 elsewhere
};

/// Marks the outermost cells, too.
void open_sides(Raster<std::uint8_t>& base_level);

BaseLevel base_level(const VectorMap& map, const Raster<std::uint8_t>& land, const RiverBeds& beds);

}  // namespace orogen
