// Horizontal motion of the rock above a dipping fault. Paper C, section 4.3, leaves it out and says
// so; its reference 35 (Castelltort et al. 2012) shows what it does to rivers.
//
// The rock above the fault (the hanging wall, on the moving side) slides up along its plane. With
// the dip δ and the rate u_f at which it rises beside the fault, it moves across the fault's line
// onto the stable side at
//
//   |v| = u_f / tan δ,    v = −|v| ∇s · fade(s),    fade(s) = (1 − s / reach)² (1 + 2 s / reach)
//
// s: signed distance to the fault (m, positive on the moving side; 0 and below: v = 0). u_f is read
// from the uplift rate at the foot of the perpendicular, one and a half cells inside.
//
// Limits: 2D at every place: the nearest stretch of the fault alone counts, so that v turns in a
// step where two are as near. Uplift that is not due to the fault has no horizontal part.
#pragma once

#include <tuple>

#include "foundation/context.h"
#include "foundation/parameters.h"
#include "foundation/raster.h"

namespace orogen {

struct FaultDipParameters {
  bool dipping_fault = false;
  double dip_deg = 30.0;
  double dip_reach = 30e3;  // m
};

constexpr auto parameter_table(const FaultDipParameters*) {
  using P = FaultDipParameters;
  return std::tuple{
      boolean("dipping_fault", &P::dipping_fault,
              "Whether the fault dips, so that the rock above it moves sideways too."),
      real("dip_deg", &P::dip_deg, 5.0, 90.0, "deg",
           "Dip of the fault below the horizontal; 90 is upright."),
      real("dip_reach", &P::dip_reach, 100.0, 500e3, "m",
           "Distance from the fault at which the horizontal motion has faded."),
  };
}

struct FaultMotion {
  Raster<float> velocity_x, velocity_y;  // m/yr
};

/// `uplift_rate` (m/yr) and `fault` (m) as CollisionUplift has them, on one grid.
FaultMotion fault_motion(const Raster<float>& uplift_rate, const Raster<float>& fault,
                         const FaultDipParameters& parameters, const Context& context);

}  // namespace orogen
