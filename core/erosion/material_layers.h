// The column of materials under a cell: loose sediment on top, then layers of rock, the last of
// them without end (Stava et al. 2008, layered terrain; Benes and Forsbach 2001).
//
// Running water takes a layer only where all above it is gone. What it lays down is always loose
// sediment. Each material has a dissolution rate k (1/s): a fraction 1 - exp(-k dt) of what the
// water could still carry is taken in a step dt. Each has an angle of repose (talus angle): see
// slippage.h.
// Limits: rock layers are thicknesses below the rock's first surface; they do not fold or fault
// here (the stage that calls cuts them from its strata).
#pragma once

#include <vector>

#include "foundation/raster.h"

namespace orogen {

/// One layer of rock. Layers are listed from the top down.
struct RockLayer {
  Raster<float> thickness;         // m; 0 where it is missing
  double dissolution_rate = 1e-4;  // 1/s
  double talus_angle_deg = 90.0;   // steepest slope this rock stands at; 90: it never breaks
};

/// InputError for a layer whose grid, thickness, rate or angle cannot be used.
void check_rock_layers(const std::vector<RockLayer>& layers, const Grid& grid);

}  // namespace orogen
