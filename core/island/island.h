// An island on a polygon map (paper B, IV-C to IV-E): where land is, its heights, rivers, moisture
// and biomes, at centers and corners.
//
//   noise = sum over i of noise(o_b o_s^i p) a_b a_s^-i                                     (1)
//   water where noise < offset + scale (x² + y²)                                            (2)
//
// with p from -1 to 1 across the paper's square. With its constants an island fills some 7% of
// that, so the rectangle shows the middle of it, from -`window` to `window`. i runs from 0 to n, as
// printed: `octaves` is n + 1. The printed (x², y²) is read as x² + y², and `noise` is Perlin's, of
// standard deviation 0.216. A center is water if at least `water_share` of its corners are; water
// that the rectangle's side is joined to is ocean, other water lakes. Without a drawn coast the
// cells at the side are ocean.
//
// Height is the number of steps along corners from the coast, below the sea downwards; along a
// lake's shore a step counts nothing, so that lakes are flat. Land is scaled to 1 at its highest
// corner and sea to -1 at its deepest. Temperature is 1 - height, at most 1.
//
// Rivers begin at random corners of dry land, at least `river_spacing` steps from another, and run
// down the steepest edge to the sea, through lakes; each step adds 1 to what a river carries, and
// rivers that meet add up. A river's corner has the moisture carried / `moist_volume`, at most 1, a
// lake's 1; it falls by `moisture_decay` a step. Values of centers are means over their corners.
#pragma once

#include <cstdint>
#include <functional>
#include <tuple>
#include <vector>

#include "climate/biomes.h"
#include "foundation/context.h"
#include "foundation/parameters.h"
#include "island/polygon_map.h"

namespace orogen {

struct IslandParameters {
  int cells = 4000;
  int relaxations = 2;
  int octaves = 5;
  double base_octave = 6.0;
  double octave_scale = 2.0;
  double base_amplitude = 0.5;
  double amplitude_scale = 2.5;
  double distance_scale = 2.2;
  double offset = -0.2;
  double window = 0.5;
  double water_share = 0.3;
  double river_density = 0.1;
  int river_spacing = 2;
  double moist_volume = 5.0;
  double moisture_decay = 0.8;
};

constexpr auto parameter_table(const IslandParameters*) {
  using P = IslandParameters;
  return std::tuple{
      integer("cells", &P::cells, 16, 1'000'000, "", "Polygons of the map."),
      integer("relaxations", &P::relaxations, 0, 20, "",
              "How often polygons are evened out before they are used."),
      integer("octaves", &P::octaves, 1, 16, "", "Octaves of the noise that shapes the island."),
      real("base_octave", &P::base_octave, 0.1, 100.0, "1",
           "Frequency of the widest octave: bays and capes over half the noise's square."),
      real("octave_scale", &P::octave_scale, 1.0, 4.0, "1",
           "Frequency of each octave beside that of the one before."),
      real("base_amplitude", &P::base_amplitude, 0.0, 10.0, "1",
           "Amplitude of the widest octave: how ragged the island is."),
      real("amplitude_scale", &P::amplitude_scale, 1.0, 10.0, "1",
           "How many times weaker each octave is than the one before."),
      real("distance_scale", &P::distance_scale, 0.0, 20.0, "1",
           "How fast land gives way to sea away from the middle."),
      real("offset", &P::offset, -5.0, 5.0, "1", "Lower values make a larger island."),
      real(
          "window", &P::window, 0.05, 2.0, "1",
          "Half the width of what is seen of the noise's square: the less, the larger the island."),
      real("water_share", &P::water_share, 0.05, 1.0, "1",
           "Share of its corners that makes a polygon water."),
      real("river_density", &P::river_density, 0.0, 1.0, "1",
           "Share of land's corners where a river is tried."),
      integer("river_spacing", &P::river_spacing, 1, 20, "",
              "Steps that a river's source keeps from other rivers."),
      real("moist_volume", &P::moist_volume, 0.1, 1000.0, "1",
           "What a river must carry to be as moist as can be; each step adds 1."),
      real("moisture_decay", &P::moisture_decay, 0.0, 0.99, "1",
           "Share of moisture that is left a step further from the water."),
  };
}

/// Values of centers or corners.
struct IslandValues {
  std::vector<std::uint8_t> water, ocean;
  std::vector<float> elevation;              // -1 to 1
  std::vector<float> temperature, moisture;  // 0 to 1
};

/// Standard deviation of Perlin's noise, whose gradients have length 1.
inline constexpr double kPerlinDeviation = 0.2157;

struct Island {
  PolygonMap map;
  IslandValues centers, corners;
  std::vector<std::uint8_t> coast;       // of corners: 1 where land and ocean meet
  std::vector<std::int32_t> downstream;  // of corners: the edge that water takes; -1: it has ended
  std::vector<std::int32_t> corner_river, edge_river;  // what the river there carries; 0: none
  std::vector<Biome> biomes;                           // of centers
};

/// What is given of an island, each a function of the place; empty: nothing.
struct IslandInputs {
  std::function<bool(glm::dvec2)> is_land = {};  // in place of eq. 2
  /// Added by hand to what is made; a corner whose height changes its sign becomes land or sea.
  std::function<double(glm::dvec2)> elevation = {}, temperature = {}, moisture = {};
};

/// InputError if there is no land.
Island make_island(const IslandParameters& parameters, glm::dvec2 low, glm::dvec2 high,
                   std::uint32_t seed, const IslandInputs& inputs, const Context& context);

/// Left side of eq. 2 minus its right side at a place of the rectangle: above 0 on land.
double island_function(const IslandParameters& parameters, glm::dvec2 low, glm::dvec2 high,
                       std::uint32_t seed, glm::dvec2 place);

}  // namespace orogen
