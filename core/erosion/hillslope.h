// Hillslopes: soil creep (diffusion) and landslides. Both move mass and lose none.
//
//   creep      dz/dt = div q,  q = D grad z / max(1 - (|grad z| / S_c)², f)     (Roering et al.
//   1999)
//              linear for S_c = infinity; f keeps the flux finite at the critical slope
//   landslide  dz/dt = -l (s - tan θ) where the slope s to the lowest neighbour exceeds tan θ
//              (paper C, section 6.1); what falls is laid down on the neighbour, further down or,
//              at base level, leaves
//
// z (m); D diffusivity (m²/yr); θ talus angle; l landslide rate (m/yr); t (yr).
// Creep is solved backward in time along rows and columns in turn, in sub-steps of D dt / cell
// size² below 2 (below 1/2 with S_c, whose diffusivity is that of the sub-step's start): stable for
// any step. Sides of the grid are closed; base-level cells keep their height and take what comes.
// The landslide runs in rounds. Each moves, from every cell that is too steep, rock down its
// steepest step, at most what brings the pair to the talus slope, so that it never overshoots. An
// infinite dt relaxes until no step exceeds the talus slope by more than some mm, or rounds are
// spent.
//
// Mass is balanced in double; heights are rounded to float32 at the end.
// Limits: a cliff of h needs some (h / (cell size * tan θ))² rounds.
#pragma once

#include <cstdint>
#include <limits>

#include "foundation/context.h"
#include "foundation/mass_balance.h"
#include "foundation/parameters.h"
#include "foundation/raster.h"
#include "foundation/stage.h"
#include "foundation/varying.h"

namespace orogen {

struct CreepParameters {
  double diffusivity = 0.01;
  double critical_slope = 0.0;
};

constexpr auto parameter_table(const CreepParameters*) {
  using P = CreepParameters;
  return std::tuple{
      real("diffusivity", &P::diffusivity, 0.0, 100.0, "m2/yr", "Diffusivity of soil creep."),
      real("critical_slope", &P::critical_slope, 0.0, 10.0, "1",
           "Slope at which creep runs away; 0 leaves creep linear."),
  };
}

struct LandslideParameters {
  double landslide_rate = 0.01;
  int rounds = 50;
};

constexpr auto parameter_table(const LandslideParameters*) {
  using P = LandslideParameters;
  return std::tuple{
      real("landslide_rate", &P::landslide_rate, 0.0, 1e9, "m/yr",
           "Speed at which ground falls for each unit of slope above the talus slope."),
      integer("rounds", &P::rounds, 1, 10000, "1", "Most rounds of relaxation."),
  };
}

inline const StageInfo& creep_stage() {
  static const StageInfo info{"creep",
                              "Lets soil creep downhill.",
                              "Roering, Kirchner and Dietrich 1999",
                              {"elevation", "land"},
                              {"elevation"}};
  return info;
}

inline const StageInfo& landslide_stage() {
  static const StageInfo info{"landslide",
                              "Lets slopes above the talus angle slide.",
                              "Paper C, section 6.1; Musgrave, Kolb and Mace 1989",
                              {"elevation", "land"},
                              {"elevation"}};
  return info;
}

/// `base_level`: not 0 where the height is held.
MassBalance creep(Raster<float>& elevation, const Raster<std::uint8_t>& base_level,
                  const CreepParameters& parameters, double dt_years, const Context& context);

/// `talus_slope`: tan(talus angle). dt may be infinite.
MassBalance landslide(Raster<float>& elevation, const Raster<std::uint8_t>& base_level,
                      const Varying& talus_slope, const LandslideParameters& parameters,
                      double dt_years, const Context& context);

}  // namespace orogen
