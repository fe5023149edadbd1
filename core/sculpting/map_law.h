// The map is law: a terrain brought to agree with its vector map, to the cell.
//
//   land     every land cell stands at least `least_height` above the sea
//   peaks    the ground lies between what the named peaks ask at least and at most (summits.h);
//            each peak's cell gets its height, nothing that the map does not name stands above it
//   rivers   water is routed with the drawn beds as receivers, and the ground is cut until it falls
//            at `least_fall` along every path to the sea
//
// Limits: ground that lies far below its peak gets a bare pyramid; growth (erosion/relief_growth.h)
// leaves little to correct. Two peaks in one cell cannot both be right: the higher one is.
#pragma once

#include <cstdint>
#include <tuple>

#include "foundation/context.h"
#include "foundation/parameters.h"
#include "foundation/raster.h"
#include "foundation/stage.h"
#include "hydrology/river_beds.h"
#include "inputs/vector_map.h"

namespace orogen {

struct MapLawParameters {
  double least_height = 0.5;
  double summit_reach = 5000.0;
  double least_fall = 2e-4;
};

constexpr auto parameter_table(const MapLawParameters*) {
  using P = MapLawParameters;
  return std::tuple{
      real("least_height", &P::least_height, 0.01, 100.0, "m", "Lowest height of land."),
      real("summit_reach", &P::summit_reach, 0.0, 100e3, "m",
           "Distance from a named peak within which nothing unnamed stands higher."),
      real("least_fall", &P::least_fall, 0.0, 0.01, "", "Least slope along rivers and valleys."),
  };
}

inline const StageInfo& map_law_stage() {
  static const StageInfo info{"map_law",
                              "Brings coast, peaks and rivers to agree with the map to the cell.",
                              "DESIGN: the vector map is law",
                              {"elevation", "land", "river"},
                              {"elevation", "drainage_area"},
                              {"map"}};
  return info;
}

struct MapLawResult {
  Raster<float> drainage_area;  // m²
  int peaks_met = 0;            // within 1 m
  double largest_peak_error_m = 0.0;
  double deepest_cut_m = 0.0;  // by the rivers' fall
};

/// Changes `elevation` (m) on land; `beds` as laid on the same grid.
MapLawResult enforce_map(Raster<float>& elevation, const VectorMap& map,
                         const Raster<std::uint8_t>& land, const RiverBeds& beds,
                         const MapLawParameters& parameters, Context& context);

}  // namespace orogen
