// Ground lowered until it is nowhere steeper than a given slope.
//
//   z'(x) = min over places y of  z(y) + the integral of slope along the way from y to x
//
// over ways from cell to cell (eight neighbours): the highest surface below z whose steps are no
// steeper, except where ground is held up at `least`. What falls is taken away (a river's work),
// unlike in landslides (hillslope.h), which keep mass. No hollow comes of it: a lowered cell stands
// above the one that lowered it.
#pragma once

#include <cstdint>

#include "foundation/context.h"
#include "foundation/raster.h"
#include "foundation/varying.h"

namespace orogen {

/// `slope`: rise over run, above 0; of each cell towards its neighbours where it is a raster.
/// `base_level`: not 0 where the height is held. `least`: heights (m) below which nothing is
/// lowered.
void limit_slope(Raster<float>& elevation, const Raster<std::uint8_t>& base_level,
                 const Raster<float>& least, const Varying& slope, const Context& context);

}  // namespace orogen
