// The height of the land at large, as far as a map of coasts, rivers and peaks tells it.
//
// Along a river of length L, at s from its source (bed heights; Hack's law and concavity 0.45 give
// slopes ~ (s + s0)^-0.8):
//
//   z(s) = z_end + (z_source - z_end) (I(L) - I(s)) / (I(L) - I(0))      I(s) = (s + s0)^0.2
//   z_source = max( max over peaks p of 0.75 H_p e^(-r_p / 45 km),  z_end + 0.006 L )
//
// z_end: 0 at the sea, the height given at the frame, the height of the river it joins. Between
// beds and coast lies a membrane B (Laplace's equation, no flux through the frame), and ranges rise
// from it towards the peaks:
//
//   h = B + 0.7 max over p of (H_p - B)+ e^(-r_p / 9 km) g + 0.02 d g        g = 1 - e^(-d / 4 km)
//
// d: distance to the nearest bed or coast. Constants were fitted to the Sierra Nevada of Spain by
// hand; there this surface misses the real heights by 290 m RMS (55 m of them below 900 m in size).
// Limits: meant for grids of some 256 cells a side; a coarse guide, not terrain.
#pragma once

#include "foundation/context.h"
#include "foundation/raster.h"
#include "hydrology/river_beds.h"
#include "inputs/vector_map.h"

namespace orogen {

/// In metres; 0 at sea.
Raster<float> regional_height(const VectorMap& map, const Raster<std::uint8_t>& land,
                              const RiverBeds& beds, const Context& context);

}  // namespace orogen
