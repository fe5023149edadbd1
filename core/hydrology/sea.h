// The sea: ground at or below 0 that hangs together, side by side, with what is sea already.
#pragma once

#include <cstdint>

#include "foundation/raster.h"

namespace orogen {

/// 1 on land, 0 at sea. `seed`: not 0 where the sea is known to be; there too ground above 0 is
/// land.
Raster<std::uint8_t> land_beside_sea(const Raster<float>& elevation,
                                     const Raster<std::uint8_t>& seed);

}  // namespace orogen
