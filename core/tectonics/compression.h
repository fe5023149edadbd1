// How the crust is squeezed between moving plates (paper C, sections 4.2 and 5.2).
//
// q: amount of crust in a cell after the plates have moved, over that before.
// C = (1 - ν₁) e₁ where ν₁ < 1, else 0: direction and strength of compression, from the smaller
// eigenvalue ν₁ of the stretch tensor U = sqrt(FᵀF) and its eigenvector e₁.
#pragma once

#include <cstdint>

#include "foundation/raster.h"

namespace orogen {

struct CompressionField {
  Raster<float> crust;          // q
  Raster<float> compression_x;  // C, east; C and -C mean the same
  Raster<float> compression_y;  // C, north
  Raster<std::int32_t> plate;   // influence region: number of the nearest plate
};

}  // namespace orogen
