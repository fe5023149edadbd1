// What the named peaks of a map ask of the ground around them.
//
//   at least  max over peaks p of  H_p − f(α) r_p − H_p (r_p / R)⁴          a pyramid
//   at most   min over peaks p of  H_p − 0.02 min(r_p, 2 cells) − w min(0.06 r, 250 m)
//                                  + s_p max(0, r_p − (1 + 0.3 w) reach, (r_p − r) / 2)
//
// r_p, α: distance (m) and direction from p; r: distance to the nearest peak; R = 3.5 km. Flanks
// f(α) vary by noise between spurs (0.42) that wind and faces (0.78). A river that passes a pyramid
// cuts a gorge of slope 0.88 into it, and comes from ground that is no lower: its bed upstream
// stands on a back of slope 0.27, uneven by noise. w in [0, 1] is noise: ground held down is no
// plateau and ends in no circle. s_p is steep enough to leave room for the higher peaks around.
// Heights are those at cell centres, so a peak's own cell has both bounds at H_p. Where the two
// disagree, close to a lower peak, the greatest height counts.
// Limits: of two peaks in one cell the higher counts. A peak without a height asks nothing.
#pragma once

#include <cstdint>
#include <vector>

#include "foundation/context.h"
#include "foundation/raster.h"
#include "hydrology/river_beds.h"
#include "inputs/vector_map.h"

namespace orogen {

struct Summit {
  glm::dvec2 center;  // m, of the peak's cell
  std::int32_t cell;
  double height;     // m
  double steepness;  // s_p
};

/// The peaks on land that have a height, highest first.
std::vector<Summit> collect_summits(const VectorMap& map, const Raster<std::uint8_t>& land);

/// Heights (m) that the ground has at least, on the grid of the beds; 0 far from peaks.
Raster<float> summit_pyramids(const std::vector<Summit>& summits, const RiverBeds& beds,
                              const Context& context);

/// Heights (m) that the ground has at most: those of the highest peak far from all others, infinite
/// without peaks. `reach` in m.
Raster<float> summit_cap(const std::vector<Summit>& summits, const Grid& grid, double reach,
                         const Context& context);

}  // namespace orogen
