// Places plants on a terrain (paper B, VII-C3).
//
// For each spot plants are tried at random, as many as biome, `density_factor`, slope and altitude
// ask for; the kind is drawn by the table's weights. The paper's spot is a cell of the height map,
// so that density hangs on resolution; here spots are squares of a lattice of its own, and the
// number in each is Poisson's, so that places of trees are the same at any resolution of the same
// ground.
//
// Spacing: each plant has a random rank, and goes if a higher one stands nearer than half the sum
// of their spacings d, whether that one stays or not (Matérn 1960, second process). Of tries with
// density l_j of kind j,
//
//   m_i = l_i (1 - exp(-a_i)) / a_i,   a_i = sum over j of l_j pi d_ij²
//
// stay of kind i. So l is found for each biome with m as the table says: densities and shares are
// the table's, with spacing. More than some 0.99 / (pi d²) cannot stand: that is an InputError.
//
// A biome's border is as fuzzy as a cell: a plant takes the biome of one of the four cells around
// it by chance, bilinearly. None stands where the nearest cell is sea, lake or always under snow.
// Limits: near a limit of slope or altitude, where a kind gets rare, those left have more room and
// a few more of them stay.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <tuple>
#include <vector>

#include "foundation/context.h"
#include "foundation/parameters.h"
#include "foundation/raster.h"
#include "vegetation/plant_table.h"

namespace orogen {

struct PlacementParameters {
  double density_factor = 1.0;
  int most_plants = 2'000'000;
};

constexpr auto parameter_table(const PlacementParameters*) {
  using P = PlacementParameters;
  return std::tuple{
      real("density_factor", &P::density_factor, 0.0, 100.0, "1",
           "What densities of the table are multiplied by."),
      integer("most_plants", &P::most_plants, 0, 100'000'000, "",
              "If some more than this would stand, all densities are lowered alike."),
  };
}

/// Ground that plants stand on; all rasters on one grid.
struct PlantGround {
  const Raster<float>& elevation;              // m
  const Raster<std::int32_t>& biome;           // as Biome counts
  const Raster<float>* water_depth = nullptr;  // m, of lakes
  const Raster<float>* snow_cover = nullptr;   // share of the year
};

/// A rectangle in metres from the grid's lower-left corner.
struct PlantRegion {
  glm::dvec2 low, high;
};

/// One item a plant, spot by spot from the south-west.
struct PlantCloud {
  std::vector<glm::vec3> positions;  // m, from the grid's lower-left corner and sea level
  std::vector<std::uint8_t> kinds;   // places in the table
  std::vector<float> scales;         // beside the kind's usual size
  std::vector<float> rotations;      // about the upward axis, 0 to 2 pi
  double density_share = 1.0;        // below 1 where `most_plants` lowered densities
};

/// InputError for a table that is wrong or whose plants cannot stand so close. `region`: only
/// there, the same plants as without it unless `most_plants` lowers densities.
PlantCloud place_plants(const PlantGround& ground, const PlantTable& table,
                        const PlacementParameters& parameters,
                        const std::optional<PlantRegion>& region, std::uint32_t seed,
                        const Context& context);

/// Plants a hectare that are asked for, cell by cell.
Raster<float> plant_density(const PlantGround& ground, const PlantTable& table,
                            const PlacementParameters& parameters, const Context& context);

}  // namespace orogen
