// A vector map on a grid.
//
// A cell is land (or lake) when its centre lies inside by the even-odd rule; a centre exactly on an
// edge counts by the half-open rule, so that neighbouring polygons share no cell.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "foundation/context.h"
#include "foundation/raster.h"
#include "inputs/vector_map.h"

namespace orogen {

/// The grid over the map's frame, `resolution` cells along the longer side.
Grid grid_for(const VectorMap& map, int resolution);

/// 1: land (lakes too), 0: sea. Without coasts everything is land.
Raster<std::uint8_t> land_mask(const VectorMap& map, const Grid& grid, const Context& context);

/// Number of the lake plus one; 0: none.
Raster<std::uint16_t> lake_mask(const VectorMap& map, const Grid& grid, const Context& context);

/// 1 at cells of the grid's border that are land: there the land goes on beyond the map, and water
/// may leave.
Raster<std::uint8_t> open_sides(const VectorMap& map, const Grid& grid,
                                const Raster<std::uint8_t>& land);

/// The cells a line runs through, in order from its first point: an 8-connected chain in which no
/// cell comes twice (where the line comes back to a cell, the loop is left out). Parts outside the
/// grid are left out, which may break the chain.
std::vector<std::size_t> rasterise_line(const Grid& grid, const Polyline& line);

}  // namespace orogen
