// The drawn rivers on a grid: which cells are beds, and where each bed cell flows.
//
// Beds are laid from the mouth upwards, rivers that others join before the rivers that join them.
// Where two rivers share a cell at this resolution the later one joins the earlier there. Every bed
// cell flows to a bed cell laid before it, or is a mouth, so beds never form rings. A bed that
// would cut a corner between two cells of another bed is allowed to touch it, never to cross it:
// crossing means joining.
//
// Inside the map's own precision the bed may meander: `wander` (m) moves it sideways by fBm of
// `wander_wavelength` (m), the same at every resolution, less where rivers are drawn in pieces so
// short that they show their own bends. It yields to a peak that it would touch.
#pragma once

#include <cstdint>
#include <vector>

#include "foundation/context.h"
#include "foundation/raster.h"
#include "inputs/vector_map.h"

namespace orogen {

struct RiverBeds {
  Raster<std::int32_t> river;           // 1 + index of the river whose bed lies here; 0: no bed
  std::vector<std::int32_t> cells;      // all bed cells, receivers before donors (mouths first)
  std::vector<std::int32_t> receivers;  // for each of `cells`: the cell it flows to; -1: a mouth
  std::vector<float> source_length;     // for each of `cells`: m along the longest bed above it
  double wander = 0.0, wander_wavelength = 1e3;  // m, as they were laid with
  std::uint32_t seed = 0;
};

/// `land`: 1 on land, 0 at sea; bed cells are land cells only.
RiverBeds lay_river_beds(const VectorMap& map, const Raster<std::uint8_t>& land, double wander,
                         double wander_wavelength, std::uint32_t seed);

/// The receivers as a raster for the flow graph: -1 where no bed forces the flow.
std::vector<std::int32_t> forced_receivers(const RiverBeds& beds);

}  // namespace orogen
