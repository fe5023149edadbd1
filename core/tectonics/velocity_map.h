// The smoothed velocity of the plates (paper A, section 5, "Velocity map").
//
//   V = G_σ * v        v: velocity of the plate at each place; G_σ: Gaussian of width σ in metres
//
// Within plates V is v; across a boundary it turns from one plate's velocity to the other's over
// some 3σ, whatever the resolution.
#pragma once

#include <tuple>

#include "foundation/context.h"
#include "foundation/parameters.h"
#include "foundation/raster.h"
#include "foundation/stage.h"
#include "tectonics/sub_plates.h"

namespace orogen {

struct VelocityParameters {
  double velocity_blur = 6000.0;  // m
};

constexpr auto parameter_table(const VelocityParameters*) {
  return std::tuple{real("velocity_blur", &VelocityParameters::velocity_blur, 0.0, 200e3, "m",
                         "Standard deviation of the blur of plate velocities.")};
}

struct VelocityMap {
  Raster<float> velocity_x, velocity_y;  // m/yr
};

VelocityMap velocity_map(const PlateMap& plates, const VelocityParameters& parameters,
                         const Context& context);

const StageInfo& velocity_stage();

}  // namespace orogen
