// Lines along which a field has a given value, and the distance to them.
//
// Marching squares between cell centres: each side of a square whose ends lie on different sides of
// the level (not below it, below it) is crossed once, where the straight line between the two
// values meets the level; at a saddle the mean of the four corners decides. Lines keep the higher
// ground on their left and end only at the outermost cell centres; a closed line repeats its first
// point.
//
// Limits: features under a cell are lost. Within a cell of a line the distance is exact; beyond, it
// is that to the pieces in the nearest cell and beside them along the line: too large by up to a
// quarter of a cell, and by up to 1.4 where two lines are about as near.
#pragma once

#include <span>
#include <vector>

#include "foundation/context.h"
#include "foundation/raster.h"
#include "inputs/vector_map.h"

namespace orogen {

/// In order along each line; the lines in the order of their first square.
std::vector<Polyline> iso_lines(const Raster<float>& field, float level, const Context& context);

/// Distance (m) of each cell's centre to the lines of `level`, negative where the field is below
/// it. Without lines: the grid's width + height, with the same sign.
Raster<float> signed_distance(const Raster<float>& field, float level,
                              std::span<const Polyline> lines, const Context& context);

}  // namespace orogen
