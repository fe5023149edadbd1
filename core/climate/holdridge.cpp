#include "climate/holdridge.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace orogen {

namespace {

constexpr int kMostZones = 8;
constexpr double kLowest = 0.01;  // °C and m/yr: below, all is the same

struct Belt {
  int zones;
  Biome biomes[kMostZones];  // driest first
};

using enum Biome;
constexpr Belt kBelts[] = {
    {1, {Snow}},
    {4, {Bare, Tundra, Tundra, Tundra}},
    {5, {TemperateDesert, Shrubland, Taiga, Taiga, Taiga}},
    {6,
     {TemperateDesert, TemperateDesert, Grassland, DeciduousForest, DeciduousForest,
      TemperateRainForest}},
    {7,
     {SubtropicalDesert, Shrubland, Grassland, DeciduousForest, DeciduousForest,
      TemperateRainForest, TemperateRainForest}},
    {7,
     {SubtropicalDesert, SubtropicalDesert, Shrubland, TropicalSeasonalForest,
      TropicalSeasonalForest, TropicalRainForest, TropicalRainForest}},
    {8,
     {SubtropicalDesert, SubtropicalDesert, Shrubland, Grassland, TropicalSeasonalForest,
      TropicalRainForest, TropicalRainForest, TropicalRainForest}},
};

double octaves(double value, double from) {
  return std::log2(std::max(value, kLowest) / from);
}

/// The hexagon's middle nearest to a place, in steps of whole numbers along two of its three axes.
struct Hexagon {
  int warm, wet;
  Hexagon(double warm_at, double wet_at) {
    const double third = -(warm_at - wet_at);
    double a = std::round(warm_at), b = std::round(-wet_at), c = std::round(third);
    const double da = std::fabs(a - warm_at), db = std::fabs(b + wet_at), dc = std::fabs(c - third);
    if (da > db && da > dc)
      a = -b - c;
    else if (db > dc)
      b = -a - c;
    warm = int(a);
    wet = int(-b);
  }
};

}  // namespace

LifeZone life_zone(double biotemperature, double precipitation) {
  // Middles of the subpolar belt and of the driest zones are at 0.
  const Hexagon hexagon(octaves(biotemperature, 1.5 * std::numbers::sqrt2),
                        octaves(precipitation, 0.0625 * std::numbers::sqrt2));
  const bool parted = hexagon.warm >= 3;  // from the octave of 12 to 24 °C on
  const bool warmer = biotemperature >= 12.0 * std::numbers::sqrt2;
  const int belt = std::clamp(hexagon.warm + 1 + (parted && (warmer || hexagon.warm > 3)), 0, 6);
  return {belt, std::clamp(hexagon.wet, 0, kBelts[belt].zones - 1)};
}

Biome holdridge_biome(double biotemperature, double precipitation) {
  const LifeZone zone = life_zone(biotemperature, precipitation);
  return kBelts[zone.belt].biomes[zone.humidity];
}

}  // namespace orogen
