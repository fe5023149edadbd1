#include "climate/climate.h"

#include <algorithm>
#include <cmath>

#include "climate/seasons.h"
#include "foundation/distance_transform.h"
#include "foundation/parallel.h"
#include "foundation/units.h"

namespace orogen {

namespace {

constexpr std::size_t kGrain = 16384;
constexpr double kWettest = 0.98;  // above which rain says nothing more
constexpr double kDaysAYear = 365.25;
constexpr double kSquareMetres = 1e6;  // a km²
constexpr double kMillimetres = 1e3;   // a m

/// Distance to lakes and rivers, in m; empty if nothing says where they are.
Raster<float> distance_to_water(const ClimateInputs& inputs, double river_area,
                                const Context& context) {
  if (!inputs.water_depth && !inputs.drainage_area) return {};
  Raster<std::uint8_t> water(inputs.elevation.grid());
  for (std::size_t i = 0; i < water.size(); ++i)
    water[i] = (inputs.water_depth && (*inputs.water_depth)[i] > 0.0f) ||
               (inputs.drainage_area && (*inputs.drainage_area)[i] >= float(river_area));
  return distance_transform(water, context);
}

/// Rain of a year's winds, m/yr.
Raster<float> rain_of_winds(const Raster<float>& elevation, double steadiness,
                            OrographicRainParameters parameters, const Context& context) {
  Raster<float> rain = orographic_rain(elevation, parameters, context);
  if (steadiness >= 1.0) return rain;
  const float share = float(steadiness), others = float((1.0 - steadiness) / 3.0);
  for (float& value : rain.values()) value *= share;
  for (int side = 1; side < 4; ++side) {
    parameters.wind_from_deg = std::fmod(parameters.wind_from_deg + 90.0, 360.0);
    const Raster<float> other = orographic_rain(elevation, parameters, context);
    for (std::size_t i = 0; i < rain.size(); ++i) rain[i] += others * other[i];
  }
  return rain;
}

float at(const Raster<float>& values, std::size_t i) {  // which may be empty
  return values.empty() ? 0.0f : values[i];
}

}  // namespace

Climate make_climate(const ClimateInputs& inputs, const ClimateParameters& parameters,
                     const OrographicRainParameters& rain, const Context& context) {
  check_parameters(parameters);
  const Grid& grid = inputs.elevation.grid();
  const Raster<float> to_water =
      distance_to_water(inputs, parameters.river_area * kSquareMetres, context);
  const double lapse = parameters.lapse_rate / kMetresPerKilometre;
  const double swing = parameters.seasonal_swing;
  const double melt = parameters.snow_melt / kMillimetres * kDaysAYear;
  Climate made;
  made.rainfall = rain_of_winds(inputs.elevation, parameters.wind_steadiness, rain, context);
  for (Raster<float>* field : {&made.air_temperature, &made.biotemperature, &made.snow_cover,
                               &made.temperature, &made.moisture})
    *field = Raster<float>(grid);
  const auto settle = [&](std::size_t i) {
    const double z = inputs.elevation[i] + (inputs.water_depth ? (*inputs.water_depth)[i] : 0.0f);
    const double mean = parameters.sea_level_temperature - lapse * std::max(z, 0.0) +
                        kWarmthDegrees * at(inputs.temperature_change, i);
    const double bio = biotemperature(mean, swing), given_off = evapotranspiration(bio);
    double wet = wetness(made.rainfall[i], given_off);
    if (const double change = at(inputs.moisture_change, i); change != 0.0) {
      wet = std::clamp(wet + change, 0.0, kWettest);
      made.rainfall[i] = float(rain_of_wetness(wet, given_off));
    }
    if (!to_water.empty()) wet += (1.0 - wet) * std::exp(-to_water[i] / parameters.water_reach);
    made.air_temperature[i] = float(mean);
    made.biotemperature[i] = float(bio);
    made.snow_cover[i] = float(snow_cover(mean, swing, made.rainfall[i], melt));
    made.temperature[i] = float(warmth(mean));
    made.moisture[i] = float(wet);
  };
  parallel_chunks(context, grid.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) settle(i);
  });
  return made;
}

}  // namespace orogen
