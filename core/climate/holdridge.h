// Biomes by Holdridge's life zones: L. R. Holdridge (1967), Life Zone Ecology, Fig. 1.
//
// Axes, all logarithmic: biotemperature b (°C), precipitation P (m/yr), and the ratio of potential
// evapotranspiration to precipitation, 0.05893 b / P. Zones are the regular hexagons whose middles
// stand where the middles of the three axes' octaves meet: biotemperatures of 1.5 2^k,
// precipitation of 0.125 2^k, ratios of 0.25 2^k part them. The octave from 12 to 24 °C is parted
// into warm temperate and subtropical in its middle, as by the frost line. Each of the chart's 38
// zones is one of paper B's biomes by the table in holdridge.cpp, which is ours.
#pragma once

#include "climate/biomes.h"

namespace orogen {

/// A zone of the chart.
struct LifeZone {
  int belt = 0;      // 0 polar, 1 subpolar, 2 boreal, 3 cool temperate, 4 warm temperate,
                     // 5 subtropical, 6 tropical
  int humidity = 0;  // octaves of precipitation from 0.0625 to 0.125 m/yr on, up to the belt's last
};

LifeZone life_zone(double biotemperature, double precipitation);
Biome holdridge_biome(double biotemperature, double precipitation);

}  // namespace orogen
