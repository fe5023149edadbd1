// The ground below the sea: it goes on from the coast as a shelf, a slope and a deep floor.
//
//   depth(d) = shelf_depth * s(d / shelf_width)                              on the shelf
//            + (deep_depth - shelf_depth) * S((d - shelf_width) / slope_width)  beyond it
//
// d: distance to the coast (m); s(t) = 1 - (1 - t)², so that the floor leaves the coast at an
// ordinary beach's steepness; S: smoothstep. fBm of the given wavelength moves d, so that the shelf
// break wanders as real ones do, and adds relief that grows with depth. Every sea cell lies at
// least `least_depth` below 0.
//
// Limits: no canyons, no trenches; the depth depends on the distance to the coast alone.
#pragma once

#include "foundation/context.h"
#include "foundation/parameters.h"
#include "foundation/raster.h"
#include "foundation/stage.h"

namespace orogen {

struct SeaFloorParameters {
  double shelf_width = 9000.0;
  double shelf_depth = 130.0;
  double slope_width = 22000.0;
  double deep_depth = 1900.0;
  double sea_floor_relief = 0.12;
};

constexpr auto parameter_table(const SeaFloorParameters*) {
  using P = SeaFloorParameters;
  return std::tuple{
      real("shelf_width", &P::shelf_width, 100.0, 3e5, "m",
           "Distance from the coast to the edge of the shelf."),
      real("shelf_depth", &P::shelf_depth, 1.0, 1000.0, "m", "Depth of the shelf's edge."),
      real("slope_width", &P::slope_width, 100.0, 5e5, "m",
           "Width of the slope from the shelf's edge to the deep floor."),
      real("deep_depth", &P::deep_depth, 10.0, 11000.0, "m", "Depth of the deep sea floor."),
      real("sea_floor_relief", &P::sea_floor_relief, 0.0, 0.5, "1",
           "Relief of the sea floor as a part of its depth."),
  };
}

inline const StageInfo& sea_floor_stage() {
  static const StageInfo info{"sea_floor",
                              "Lays the sea floor from the coast down to the deep.",
                              "DESIGN: below the coast the terrain goes on",
                              {"elevation", "land"},
                              {"elevation"}};
  return info;
}

/// Writes the sea floor into `elevation` (m) where `land` is 0. `coast_distance` (m): from each sea
/// cell's centre to the nearest land cell's centre; all three on one grid.
void lay_sea_floor(Raster<float>& elevation, const Raster<std::uint8_t>& land,
                   const Raster<float>& coast_distance, const SeaFloorParameters& parameters,
                   std::uint32_t seed, const Context& context);

}  // namespace orogen
