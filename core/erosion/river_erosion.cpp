#include "erosion/river_erosion.h"

#include <cmath>
#include <limits>

#include "erosion/hillslope.h"
#include "erosion/slope_limit.h"
#include "erosion/stream_power.h"
#include "foundation/units.h"
#include "hydrology/base_level.h"

namespace orogen {

namespace {

Raster<std::uint8_t> base_level_of(const Raster<std::int32_t>& land) {
  Raster<std::uint8_t> base(land.grid());
  for (std::size_t i = 0; i < base.size(); ++i) base[i] = !land[i];
  open_sides(base);
  return base;
}

StreamPowerParameters solver_parameters(const RiverErosionParameters& p) {
  return {.area_exponent = p.area_exponent,
          .slope_exponent = p.slope_exponent,
          .minimum_drainage_area = p.minimum_drainage_area,
          .deposition_coefficient = p.deposition_coefficient,
          .deposition_iterations = p.deposition_iterations,
          .fill_lakes = p.fill_lakes};
}

}  // namespace

RiverErosion erode_by_rivers(Raster<float> elevation, const Raster<std::int32_t>& land,
                             const Raster<float>& uplift_rate, const Raster<float>& erodibility,
                             const RiverErosionParameters& parameters, Context& context) {
  check_parameters(parameters);
  const Raster<std::uint8_t> base = base_level_of(land);
  FlowGraph flow(base);
  StreamPower rivers(solver_parameters(parameters));
  StreamPowerForcing forcing;
  forcing.uplift_rate = uplift_rate;
  forcing.erodibility = erodibility;
  forcing.talus_slope = std::tan(radians(parameters.talus_angle_deg));
  const double step_years = parameters.years / parameters.steps;
  for (int step = 0; step < parameters.steps && step_years > 0.0; ++step) {
    context.report(double(step) / parameters.steps);
    rivers.step(flow, elevation, forcing, step_years, context);
  }
  const Raster<float> anything(elevation.grid(), std::numeric_limits<float>::lowest());
  limit_slope(elevation, base, anything, forcing.talus_slope, context);
  const double rounded = parameters.creep_length;
  if (rounded > 0.0) creep(elevation, base, {.diffusivity = 1.0}, 0.5 * rounded * rounded, context);
  flow.route(elevation, context);
  Raster<float> area = drainage_area(flow, context);
  return {std::move(elevation), std::move(area)};
}

}  // namespace orogen
