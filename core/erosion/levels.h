// The grids of a growth that runs from coarse to fine, and the blur that its fits look through.
#pragma once

#include <cstdint>
#include <vector>

#include "foundation/context.h"
#include "foundation/raster.h"

namespace orogen {

/// `coarsest_cells` along the longer side, twice that, ... up to 3/4 of the finest, then that one.
std::vector<Grid> level_grids(const Grid& finest, int coarsest_cells);

/// Gaussian blur (sigma in m) of 1 on land and 0 elsewhere.
Raster<float> blurred_land(const Raster<std::uint8_t>& land, double sigma, const Context& context);

/// Gaussian blur over land alone; `share`: blurred_land of the same width.
Raster<float> blur_over_land(const Raster<float>& field, const Raster<std::uint8_t>& land,
                             const Raster<float>& share, double sigma, const Context& context);

}  // namespace orogen
