// Biomes by temperature and precipitation: Whittaker (1975), Communities and Ecosystems, as drawn
// in Ricklefs (2008), The Economy of Nature, Fig. 5.5.
//
// Belts of mean temperature, parted at -5, 3 and 20 °C, are parted by precipitation along lines.
// The diagram prints no numbers: its lines are read off as straight ones, to some 1 °C and 0.1
// m/yr, and go on where it has no climate. Nine kinds stand in it; three are parted further, so
// that paper B's names fit: tundra that is as good as dry is bare; temperate grassland/desert is
// desert below 0.25 m/yr; tropical seasonal forest/savanna is grassland below 1.1 m/yr.
#pragma once

#include "climate/biomes.h"

namespace orogen {

/// Mean temperature of the year in °C, precipitation in m/yr.
Biome whittaker_biome(double temperature, double precipitation);

}  // namespace orogen
