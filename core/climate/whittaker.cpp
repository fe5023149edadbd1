#include "climate/whittaker.h"

#include <limits>

namespace orogen {

namespace {

struct Line {
  double at_coldest, at_warmest;  // m/yr, at the belt's ends
  Biome below;
};

struct Belt {
  double coldest, warmest;  // °C; the outermost go on beyond
  Line lines[4];            // driest first
};

constexpr double kNever = std::numeric_limits<double>::infinity();

constexpr Belt kBelts[] = {
    {-15.0, -5.0, {{0.05, 0.1, Biome::Bare}, {kNever, kNever, Biome::Tundra}}},
    {-5.0,
     3.0,
     {{0.1, 0.25, Biome::TemperateDesert},
      {0.1, 0.35, Biome::Grassland},
      {0.1, 0.5, Biome::Shrubland},
      {kNever, kNever, Biome::Taiga}}},
    {3.0,
     20.0,
     {{0.25, 0.25, Biome::TemperateDesert},
      {0.35, 0.6, Biome::Grassland},
      {0.5, 1.15, Biome::Shrubland},
      {kNever, kNever, Biome::DeciduousForest}}},
    {20.0,
     30.0,
     {{0.6, 0.9, Biome::SubtropicalDesert},
      {1.1, 1.1, Biome::Grassland},
      {2.3, 2.6, Biome::TropicalSeasonalForest},
      {kNever, kNever, Biome::TropicalRainForest}}},
};

constexpr double kTemperateRainForest = 2.0;  // m/yr, and wetter

const Belt& belt_of(double temperature) {
  for (const Belt& belt : kBelts)
    if (temperature < belt.warmest) return belt;
  return kBelts[3];
}

}  // namespace

Biome whittaker_biome(double temperature, double precipitation) {
  const Belt& belt = belt_of(temperature);
  const double along = (temperature - belt.coldest) / (belt.warmest - belt.coldest);
  const double held = along < 0.0 ? 0.0 : along > 1.0 ? 1.0 : along;
  for (const Line& line : belt.lines) {
    const bool last = line.at_coldest == kNever;
    if (!last && precipitation >= line.at_coldest + held * (line.at_warmest - line.at_coldest))
      continue;
    const bool rain_forest =
        line.below == Biome::DeciduousForest && precipitation >= kTemperateRainForest;
    return rain_forest ? Biome::TemperateRainForest : line.below;
  }
  return Biome::Bare;  // not a number
}

}  // namespace orogen
