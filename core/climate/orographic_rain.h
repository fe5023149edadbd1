// Rain that a wind drops on mountains: the linear model of Smith and Barstad (2004), J. Atmos. Sci.
// 61, 1377-1391, doi:10.1175/1520-0469(2004)061<1377:ALTOOP>2.0.CO;2.
//
//   P^(k, l) = C_w i s h^ / ((1 - i m H_w) (1 + i s t_c) (1 + i s t_f)),   s = U k + V l
//   m = sgn(s) sqrt((N² - s²) / s² (k² + l²)), i times the root where s² > N²
//   P = max(P_0 + P^ in space, 0)
//
// h: ground above the sea (m); (U, V): wind (m/s); C_w: how much vapour rising air gives up
// (kg/m³); N: moist stability (1/s); H_w: depth of the moist layer (m); t_c, t_f: times in which
// cloud water becomes rain, and rain falls (s). P is in kg/m²/s, that is mm/s; a year has
// `storm_share` of such weather.
//
// Ground goes on beyond the grid with the height of its nearest side, sinking to the sea over the
// padding of five times the wind's way in t_c + t_f. With it the model has at most 1024 cells a
// side; where the grid is finer, cells are gathered and the rain is interpolated.
// Limits: air that rises everywhere is saturated, and does not remember what it has lost.
#pragma once

#include <tuple>

#include "foundation/context.h"
#include "foundation/parameters.h"
#include "foundation/raster.h"

namespace orogen {

struct OrographicRainParameters {
  double wind_from_deg = 270.0;       // compass: 270 is a west wind
  double wind_speed = 12.0;           // m/s
  double background_rain = 0.8;       // m/yr
  double storm_share = 0.05;          // of the year
  double uplift_sensitivity = 0.005;  // kg/m³
  double moist_layer = 2500.0;        // m
  double moist_stability = 0.005;     // 1/s
  double conversion_time = 1000.0;    // s
  double fallout_time = 1000.0;       // s
};

constexpr auto parameter_table(const OrographicRainParameters*) {
  using P = OrographicRainParameters;
  return std::tuple{
      real("wind_from_deg", &P::wind_from_deg, 0.0, 360.0, "deg",
           "Where the wind comes from: 0 north, 90 east, 180 south, 270 west."),
      real("wind_speed", &P::wind_speed, 0.1, 60.0, "m/s", "Speed of the wind that brings rain."),
      real("background_rain", &P::background_rain, 0.0, 12.0, "m/yr", "Rain on flat ground."),
      real("storm_share", &P::storm_share, 0.0, 1.0, "1",
           "Share of the year in which that wind brings rain."),
      real("uplift_sensitivity", &P::uplift_sensitivity, 0.0, 0.05, "kg/m3",
           "Water that rising air gives up a metre of rise."),
      real("moist_layer", &P::moist_layer, 0.0, 10e3, "m", "Depth of the moist layer of air."),
      real("moist_stability", &P::moist_stability, 0.0, 0.05, "1/s",
           "Stability of moist air: the more, the more it flows round mountains than over them."),
      real("conversion_time", &P::conversion_time, 0.0, 1e4, "s",
           "Time in which the water of clouds becomes rain."),
      real("fallout_time", &P::fallout_time, 0.0, 1e4, "s",
           "Time in which rain reaches the ground."),
  };
}

/// Rain in m/yr.
Raster<float> orographic_rain(const Raster<float>& elevation,
                              const OrographicRainParameters& parameters, const Context& context);

}  // namespace orogen
