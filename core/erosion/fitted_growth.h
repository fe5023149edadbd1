// Mountains grown by uplift against stream power until they stand, at large, as high as given
// ground: an elevation model's ranges and plains, with valleys that rivers made here.
//
//   0 = U_i − k (A + A₀)^m |∇z_i|                             steady state, n = 1 (stream_power.h)
//   U_{i+1} = U_i · [ (G_σ h + ε) / (G_σ z_i + ε) ]^γ         ≤ 1.3 k tan(talus angle) A₀^m
//
// h: the given heights (m), held at 0 at sea; G_σ: Gaussian blur over land alone, σ = `fit_radius`;
// U uplift rate (m/yr); k erodibility (m^(1-2m)/yr); A drainage area (m²), A₀ `hillslope_area`; z
// heights (m); γ `fit_rate`; ε 1% of the greatest G_σ h, at least 1 m. Beyond the bound hillslopes
// stand at the talus angle already, and more uplift moves no heights.
//
// Water first runs as it does on the given ground, blurred by `drainage_radius`: great valleys lie
// where they lay. Coarse to fine, as in relief_growth.h: `coarsest_cells` along the longer side,
// twice that, ... then the grid asked for. At the end soil creep over `creep_length` (or 0.35
// cells) rounds crests.
//
// Water leaves at the sea, at height 0, and at the sides of the grid, at the given heights. The sea
// floor stays as it is given.
//
// Limits: one receiver a cell, so that smooth ground shows the grid's eight directions: give it
// some roughness first. A steady state, so no high plains, lakes or relict surfaces; what is
// narrower than `fit_radius` is not followed; where the given ground is steeper than talus over
// such widths, the land stays lower.
#pragma once

#include <cstdint>
#include <tuple>

#include "foundation/context.h"
#include "foundation/parameters.h"
#include "foundation/raster.h"
#include "foundation/stage.h"

namespace orogen {

struct FittedGrowthParameters {
  int coarsest_cells = 128;
  int coarse_steps = 30;
  int middle_steps = 12;
  int finest_steps = 10;
  double fit_radius = 4000.0;
  double fit_rate = 0.8;
  double drainage_radius = 500.0;
  double area_exponent = 0.43;
  double hillslope_area = 0.5e6;
  double talus_angle_deg = 34.0;
  double creep_length = 35.0;
};

constexpr auto parameter_table(const FittedGrowthParameters*) {
  using P = FittedGrowthParameters;
  return std::tuple{
      integer("coarsest_cells", &P::coarsest_cells, 32, 2048, "1",
              "Cells along the longer side at the coarsest level."),
      integer("coarse_steps", &P::coarse_steps, 1, 1000, "1", "Steps at the coarsest level."),
      integer("middle_steps", &P::middle_steps, 1, 1000, "1",
              "Steps at each level between the coarsest and the finest."),
      integer("finest_steps", &P::finest_steps, 1, 1000, "1", "Steps at the finest level."),
      real("fit_radius", &P::fit_radius, 100.0, 100e3, "m",
           "Width over which heights are brought to those that are given."),
      real("fit_rate", &P::fit_rate, 0.0, 1.5, "1", "How fast uplift follows what is amiss."),
      real("drainage_radius", &P::drainage_radius, 0.0, 100e3, "m",
           "Width over which the given ground is blurred before water runs over it first."),
      real("area_exponent", &P::area_exponent, 0.2, 1.0, "1", "Exponent m of drainage area."),
      real("hillslope_area", &P::hillslope_area, 1.0, 1e8, "m2",
           "Drainage area below which ground is hillslope rather than channel."),
      real("talus_angle_deg", &P::talus_angle_deg, 5.0, 80.0, "deg", "Steepest slope of rock."),
      real("creep_length", &P::creep_length, 0.0, 2e3, "m",
           "Length over which soil creep rounds crests and hollows."),
  };
}

inline const StageInfo& fitted_growth_stage() {
  static const StageInfo info{
      "fitted_growth",
      "Grows mountains by uplift against stream power until they stand at large as the ground did.",
      "Paper C, eq. 5; Braun and Willett 2013",
      {"elevation", "land", "erodibility"},
      {"elevation", "uplift_rate", "drainage_area"},
      {"rasters.uplift_factor"}};
  return info;
}

struct FittedGrowth {
  Raster<float> elevation;      // m
  Raster<float> uplift_rate;    // m/yr
  Raster<float> drainage_area;  // m²
};

/// `given`: heights (m) to be followed; `land`: not 0 on land; `erodibility` in m^(1-2m)/yr; all on
/// one grid.
FittedGrowth grow_towards(const Raster<float>& given, const Raster<std::int32_t>& land,
                          const Raster<float>& erodibility,
                          const FittedGrowthParameters& parameters, Context& context);

}  // namespace orogen
