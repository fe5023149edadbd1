// Height map of an island, and its climate (paper B, IV-F).
//
// The polygon map's values are drawn as triangles (center, corner, next corner), and each cell
// takes the value a noise-made offset away, so that no straight side shows. Then
//
//   h <- sign(h) |h|^1.5                                                                    (3)
//   h <- h + A sum over k of noise(r^k p) / r^(k (1 - R))                                   (4)
//
// k runs from 0 to n, as printed: `relief_octaves` is n + 1, and r = 2. A and R are those of the
// biomes (climate/biomes.h), blended across their borders; p runs from -`relief_frequency` to
// `relief_frequency` across the longer side, and noise is Perlin's, of standard deviation 0.216.
// Last, heights are scaled: the highest land to `peak_height`, the deepest sea to `sea_depth`.
//
// What the paper leaves open: A fades to 0 towards a lake's shore, so that its water stays level
// and held in; the lake's bed falls away from the shore to `lake_depth`. Ground below 0 that the
// sea does not reach is turned up, above it. Near the sides noise raises no land out of the ocean.
#pragma once

#include <cstdint>
#include <tuple>

#include "foundation/context.h"
#include "foundation/parameters.h"
#include "foundation/raster.h"
#include "island/island.h"

namespace orogen {

struct IslandReliefParameters {
  double peak_height = 2000.0;  // m
  double sea_depth = 1000.0;    // m
  double height_exponent = 1.5;
  double perturbation = 0.7;
  double relief = 1.0;
  double relief_frequency = 6.0;
  int relief_octaves = 6;
  double lake_depth = 40.0;  // m
};

constexpr auto parameter_table(const IslandReliefParameters*) {
  using P = IslandReliefParameters;
  return std::tuple{
      real("peak_height", &P::peak_height, 1.0, 12e3, "m", "Height of the highest place."),
      real("sea_depth", &P::sea_depth, 1.0, 12e3, "m", "Depth of the deepest place of the sea."),
      real("height_exponent", &P::height_exponent, 0.2, 5.0, "1",
           "Power of heights above 0 to 1: above 1 lowlands are flatter and mountains steeper."),
      real("perturbation", &P::perturbation, 0.0, 5.0, "1",
           "How far the sides of polygons are bent, in polygons."),
      real("relief", &P::relief, 0.0, 5.0, "1", "How strong the hills of each biome are."),
      real("relief_frequency", &P::relief_frequency, 0.1, 1000.0, "1",
           "Frequency of the widest hills: how many over half the longer side."),
      integer("relief_octaves", &P::relief_octaves, 1, 16, "", "Octaves of the hills."),
      real("lake_depth", &P::lake_depth, 0.0, 1e3, "m", "Depth of lakes far from their shores."),
  };
}

struct IslandRelief {
  Raster<float> elevation;              // m, of the ground; lakes' beds
  Raster<float> water_depth;            // m, of lakes
  Raster<float> temperature, moisture;  // 0 to 1
  Raster<std::int32_t> biome;           // as Biome counts
  Raster<std::uint8_t> land;            // 1 on land, lakes included
};

IslandRelief island_relief(const Island& island, const IslandReliefParameters& parameters,
                           const Grid& grid, std::uint32_t seed, const Context& context);

}  // namespace orogen
