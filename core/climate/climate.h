// Climate of a terrain by height, wind and water.
//
//   T = sea_level_temperature - lapse_rate max(z, 0)       mean of the year, z of ground or water
//   P = rain that winds drop (climate/orographic_rain.h): the share `wind_steadiness` by the
//       prevailing wind, the rest by those from the other three sides alike
//
// From both: biotemperature, snow cover, and paper B's temperature and moisture from 0 to 1
// (climate/seasons.h). Near fresh water ground is moister than its rain:
//
//   m <- m + (1 - m) exp(-d / water_reach)
//
// d: distance to lakes and to rivers, cells that `river_area` drains through. Changes by hand are
// added to temperature and moisture, on B's scales; degrees and rain are those that go with them.
// Limits: no rain shadow of temperature (foehn), no cold air in valleys, the sea warms nothing.
#pragma once

#include <tuple>

#include "climate/orographic_rain.h"
#include "foundation/context.h"
#include "foundation/parameters.h"
#include "foundation/raster.h"

namespace orogen {

struct ClimateParameters {
  double sea_level_temperature = 15.0;  // °C
  double lapse_rate = 6.5;              // K/km
  double seasonal_swing = 8.0;          // K
  double snow_melt = 4.5;               // mm/(K day)
  double wind_steadiness = 0.6;
  double river_area = 20.0;    // km²
  double water_reach = 400.0;  // m
};

constexpr auto parameter_table(const ClimateParameters*) {
  using P = ClimateParameters;
  return std::tuple{
      real("sea_level_temperature", &P::sea_level_temperature, -40.0, 40.0, "degC",
           "Mean temperature of the year at the sea."),
      real("lapse_rate", &P::lapse_rate, 0.0, 12.0, "K/km", "How much colder it is higher up."),
      real("seasonal_swing", &P::seasonal_swing, 0.0, 40.0, "K",
           "How much warmer than the year's mean the warmest month is, and the coldest colder."),
      real("snow_melt", &P::snow_melt, 0.1, 20.0, "mm/(K day)",
           "Water that melts a day and degree above 0: the more, the higher the snow line."),
      real("wind_steadiness", &P::wind_steadiness, 0.0, 1.0, "1",
           "Share of the rain's time in which the prevailing wind blows; in the rest, winds from "
           "the other three sides do."),
      real("river_area", &P::river_area, 0.01, 1e6, "km2",
           "Area that drains through a place which makes it a river that moistens its banks."),
      real("water_reach", &P::water_reach, 1.0, 100e3, "m",
           "Distance from lakes and rivers at which what they moisten has fallen by e."),
  };
}

/// Terrain that a climate is made for; what may be missing is nullptr or empty.
struct ClimateInputs {
  const Raster<float>& elevation;                // m
  const Raster<float>* water_depth = nullptr;    // m, of lakes
  const Raster<float>* drainage_area = nullptr;  // m²
  Raster<float> temperature_change = {};         // of temperature from 0 to 1
  Raster<float> moisture_change = {};            // of moisture from 0 to 1
};

struct Climate {
  Raster<float> air_temperature;        // °C, mean of the year
  Raster<float> biotemperature;         // °C
  Raster<float> rainfall;               // m/yr
  Raster<float> snow_cover;             // share of the year, 1 above the snow line
  Raster<float> temperature, moisture;  // 0 to 1, as paper B has them
};

Climate make_climate(const ClimateInputs& inputs, const ClimateParameters& parameters,
                     const OrographicRainParameters& rain, const Context& context);

}  // namespace orogen
