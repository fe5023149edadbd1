// Given ground that rivers wear down: stream power on a grid (stream_power.h), hillslopes no
// steeper than talus, soil creep at the end. In even steps, all of `years`.
//
// Water leaves at the sea and at the sides of the grid, which keep their heights.
// Limits: one receiver a cell, so that perfectly smooth ground shows the grid's eight directions:
// give it some roughness first.
#pragma once

#include <tuple>

#include "erosion/river_parameters.h"
#include "foundation/context.h"
#include "foundation/parameters.h"
#include "foundation/raster.h"
#include "foundation/stage.h"

namespace orogen {

struct RiverErosionParameters {
  double years = 2e5;
  int steps = 20;
  double area_exponent = 0.5;
  double slope_exponent = 1.0;
  double minimum_drainage_area = 3e5;  // m²
  double deposition_coefficient = 0.0;
  int deposition_iterations = 4;
  bool fill_lakes = true;
  double talus_angle_deg = 34.0;
  double creep_length = 35.0;  // m
};

constexpr auto parameter_table(const RiverErosionParameters*) {
  using P = RiverErosionParameters;
  return std::tuple_cat(
      std::tuple{
          real("years", &P::years, 0.0, 1e9, "yr", "Time that rivers have."),
          integer("steps", &P::steps, 1, 100000, "1", "Steps in time."),
      },
      incision_parameters<P>(), deposition_parameters<P>(),
      std::tuple{
          real("talus_angle_deg", &P::talus_angle_deg, 5.0, 80.0, "deg", "Steepest slope of rock."),
          real("creep_length", &P::creep_length, 0.0, 2e3, "m",
               "Length over which soil creep rounds crests and hollows."),
      });
}

inline const StageInfo& river_erosion_stage() {
  static const StageInfo info{"river_erosion",
                              "Lets rivers cut into the ground, and lay down sediment.",
                              "Paper C, eq. 5; Braun and Willett 2013; Yuan et al. 2019",
                              {"elevation", "land", "uplift_rate", "erodibility"},
                              {"elevation", "drainage_area"}};
  return info;
}

struct RiverErosion {
  Raster<float> elevation;      // m
  Raster<float> drainage_area;  // m²
};

/// `land`: not 0 on land. `uplift_rate` in m/yr, `erodibility` in m^(1-2m)/yr; all on one grid.
RiverErosion erode_by_rivers(Raster<float> elevation, const Raster<std::int32_t>& land,
                             const Raster<float>& uplift_rate, const Raster<float>& erodibility,
                             const RiverErosionParameters& parameters, Context& context);

}  // namespace orogen
