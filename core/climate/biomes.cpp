#include "climate/biomes.h"

namespace orogen {

namespace {

constexpr BiomeInfo kTable[kBiomes] = {
    {"snow", 0.5, 0.7, 0xf4f6f8},
    {"tundra", 0.5, 0.5, 0xbfc3a6},
    {"bare", 0.4, 0.4, 0x9b958a},
    {"scorched", 0.7, 0.3, 0x6f665e},
    {"taiga", 0.4, 0.3, 0x5c7a56},
    {"shrubland", 0.5, 0.2, 0xa0a372},
    {"temperate_desert", 0.1, 0.1, 0xd8c898},
    {"temperate_rain_forest", 0.3, 0.2, 0x3f6e4a},
    {"deciduous_forest", 0.3, 0.4, 0x6a9350},
    {"grassland", 0.4, 0.5, 0x9cb85c},
    {"tropical_rain_forest", 0.3, 0.2, 0x2f7a3d},
    {"tropical_seasonal_forest", 0.3, 0.2, 0x5a9a45},
    {"subtropical_desert", 0.3, 0.6, 0xdfbf86},
    {"beach", 0.3, 0.5, 0xe8d9a8},
    {"lake", 0.2, 0.2, 0x4f8fb8},
    {"ocean", 0.2, 0.1, 0x2c5f8a},
};

struct Share {
  double driest;  // moisture above which it is this biome
  Biome biome;
};

struct Belt {
  double coldest;   // temperature above which it is this belt
  Share shares[4];  // wettest first, the last from 0 on
};

constexpr Belt kBelts[] = {
    {0.7,
     {{0.66, Biome::TropicalRainForest},
      {0.33, Biome::TropicalSeasonalForest},
      {0.16, Biome::Grassland},
      {0.0, Biome::SubtropicalDesert}}},
    {0.4,
     {{0.83, Biome::TemperateRainForest},
      {0.5, Biome::DeciduousForest},
      {0.16, Biome::Grassland},
      {0.0, Biome::TemperateDesert}}},
    {0.2, {{0.66, Biome::Taiga}, {0.33, Biome::Shrubland}, {0.0, Biome::TemperateDesert}}},
    {0.0, {{0.5, Biome::Snow}, {0.33, Biome::Tundra}, {0.16, Biome::Bare}, {0.0, Biome::Scorched}}},
};

}  // namespace

std::span<const BiomeInfo, kBiomes> biomes() {
  return kTable;
}

Biome biome_of(double temperature, double moisture) {
  for (const Belt& belt : kBelts) {
    if (temperature <= belt.coldest && belt.coldest > 0.0) continue;
    for (const Share& share : belt.shares)
      if (moisture > share.driest || share.driest == 0.0) return share.biome;
  }
  return Biome::Scorched;  // not a number
}

}  // namespace orogen
