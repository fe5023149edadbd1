// Biomes: kinds of country with a climate, soil and plants of their own (paper B, VII-A).
//
// The sixteen of paper B's Table I, in its order, each with the amplitude A and roughness R of its
// relief (eq. 4). `biome_of` is the classification of Fig. 8 by temperature and moisture: four
// belts of temperature, each parted by moisture. The figure prints no numbers; the limits are those
// of the polygon maps that the paper builds on (its reference 9), with temperature for 1 - height.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace orogen {

enum class Biome : std::uint8_t {
  Snow,
  Tundra,
  Bare,
  Scorched,
  Taiga,
  Shrubland,
  TemperateDesert,
  TemperateRainForest,
  DeciduousForest,
  Grassland,
  TropicalRainForest,
  TropicalSeasonalForest,
  SubtropicalDesert,
  Beach,
  Lake,
  Ocean,
};

inline constexpr int kBiomes = 16;

struct BiomeInfo {
  std::string_view name;
  double amplitude;     // A, of heights from -1 (deepest) to 1 (highest)
  double roughness;     // R
  std::uint32_t color;  // sRGB, 0xRRGGBB
};

/// In the order of Biome.
std::span<const BiomeInfo, kBiomes> biomes();

inline const BiomeInfo& info(Biome biome) {
  return biomes()[std::size_t(biome)];
}

/// The biome of dry land. Temperature from 0, cold, to 1, hot; moisture from 0 to 1.
Biome biome_of(double temperature, double moisture);

}  // namespace orogen
