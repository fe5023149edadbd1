// Bends a relief so that land and sea lie where they are drawn.
//
// Within `reach` of the drawn coast heights fade to 0, and from there the ground rises, or falls,
// by at least `least_slope`: so the coast is where it was drawn, without a step.
#pragma once

#include <cstdint>

#include "foundation/context.h"
#include "foundation/raster.h"

namespace orogen {

/// `land`: 1 on land, 0 at sea, on the same grid. `reach` in metres.
void fit_coast(Raster<float>& elevation, const Raster<std::uint8_t>& land, double reach,
               double least_slope, const Context& context);

}  // namespace orogen
