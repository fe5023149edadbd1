#include "climate/holdridge.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "foundation/random.h"

namespace orogen {
namespace {

struct Zone {
  const char* name;
  double biotemperature, precipitation;  // °C, m/yr: a place well inside it
  LifeZone zone;
  Biome biome;
};

// From the chart, belt by belt.
constexpr Zone kZones[] = {
    {"polar desert", 0.7, 0.2, {0, 0}, Biome::Snow},
    {"subpolar dry tundra", 2.1, 0.09, {1, 0}, Biome::Bare},
    {"subpolar moist tundra", 2.1, 0.18, {1, 1}, Biome::Tundra},
    {"subpolar rain tundra", 2.1, 0.7, {1, 3}, Biome::Tundra},
    {"boreal desert", 4.2, 0.09, {2, 0}, Biome::TemperateDesert},
    {"boreal dry scrub", 4.2, 0.18, {2, 1}, Biome::Shrubland},
    {"boreal moist forest", 4.2, 0.35, {2, 2}, Biome::Taiga},
    {"boreal rain forest", 4.2, 1.4, {2, 4}, Biome::Taiga},
    {"cool temperate desert scrub", 8.5, 0.18, {3, 1}, Biome::TemperateDesert},
    {"cool temperate steppe", 8.5, 0.35, {3, 2}, Biome::Grassland},
    {"cool temperate moist forest", 8.5, 0.7, {3, 3}, Biome::DeciduousForest},
    {"cool temperate rain forest", 8.5, 2.8, {3, 5}, Biome::TemperateRainForest},
    {"warm temperate desert", 16.0, 0.09, {4, 0}, Biome::SubtropicalDesert},
    {"warm temperate thorn steppe", 16.0, 0.35, {4, 2}, Biome::Grassland},
    {"warm temperate dry forest", 16.0, 0.7, {4, 3}, Biome::DeciduousForest},
    {"warm temperate wet forest", 16.0, 2.8, {4, 5}, Biome::TemperateRainForest},
    {"subtropical desert scrub", 18.0, 0.18, {5, 1}, Biome::SubtropicalDesert},
    {"subtropical dry forest", 18.0, 0.7, {5, 3}, Biome::TropicalSeasonalForest},
    {"subtropical rain forest", 18.0, 5.6, {5, 6}, Biome::TropicalRainForest},
    {"tropical desert", 28.0, 0.09, {6, 0}, Biome::SubtropicalDesert},
    {"tropical thorn woodland", 28.0, 0.35, {6, 2}, Biome::Shrubland},
    {"tropical very dry forest", 28.0, 0.7, {6, 3}, Biome::Grassland},
    {"tropical dry forest", 28.0, 1.4, {6, 4}, Biome::TropicalSeasonalForest},
    {"tropical moist forest", 28.0, 2.8, {6, 5}, Biome::TropicalRainForest},
    {"tropical rain forest", 28.0, 11.0, {6, 7}, Biome::TropicalRainForest},
};

TEST(Holdridge, KnowsTheZonesOfTheChart) {
  for (const Zone& zone : kZones) {
    const LifeZone found = life_zone(zone.biotemperature, zone.precipitation);
    EXPECT_EQ(found.belt, zone.zone.belt) << zone.name;
    EXPECT_EQ(found.humidity, zone.zone.humidity) << zone.name;
    EXPECT_EQ(holdridge_biome(zone.biotemperature, zone.precipitation), zone.biome) << zone.name;
  }
}

/// How far a place is from a zone's middle: the largest of its three distances, in octaves.
double distance(double biotemperature, double precipitation, int warm, int wet) {
  const double ratio = 0.05893 * biotemperature / precipitation;
  const double b = std::log2(biotemperature / (1.5 * std::exp2(warm + 0.5)));
  const double p = std::log2(precipitation / (0.0625 * std::exp2(wet + 0.5)));
  const double r = std::log2(ratio / std::exp2(warm - wet + 0.5));
  return std::max({std::fabs(b), std::fabs(p), std::fabs(r)});
}

TEST(Holdridge, TakesTheHexagonWhoseMiddleIsNearest) {
  for (std::uint64_t i = 0; i < 3000; ++i) {
    const double biotemperature = 1.6 * std::exp2(3.9 * random_uniform(3, 0, i));
    const double precipitation = 0.07 * std::exp2(5.0 * random_uniform(3, 1, i));
    double least = 1e9;
    int warm = 0, wet = 0;
    for (int w = -1; w <= 4; ++w)
      for (int p = -1; p <= 8; ++p)
        if (const double d = distance(biotemperature, precipitation, w, p); d < least)
          least = d, warm = w, wet = p;
    double second = 1e9;
    for (int w = -1; w <= 4; ++w)
      for (int p = -1; p <= 8; ++p)
        if (w != warm || p != wet)
          second = std::min(second, distance(biotemperature, precipitation, w, p));
    if (second - least < 1e-3) continue;  // on a border
    const LifeZone zone = life_zone(biotemperature, precipitation);
    const int belt = warm < 3 ? warm + 1 : warm > 3 ? 6 : biotemperature < 12.0 * M_SQRT2 ? 4 : 5;
    constexpr int kZonesOf[] = {1, 4, 5, 6, 7, 7, 8};
    ASSERT_EQ(zone.belt, belt) << biotemperature << " " << precipitation;
    ASSERT_EQ(zone.humidity, std::clamp(wet, 0, kZonesOf[belt] - 1))
        << biotemperature << " " << precipitation;
  }
}

TEST(Holdridge, HoldsOutsideTheChart) {
  for (const double b : {0.0, 0.5, 10.0, 30.0})
    for (const double p : {0.0, 1e-9, 1.0, 50.0})
      EXPECT_LT(int(holdridge_biome(b, p)), int(Biome::Beach)) << b << " " << p;
}

}  // namespace
}  // namespace orogen
