// The way of a river that was drawn to end inland: over land to the nearest sea, lake, frame side
// or river that reaches one, off the peaks.
#pragma once

#include <vector>

#include "foundation/raster.h"
#include "inputs/land_region.h"
#include "inputs/river_connections.h"

namespace orogen {

/// Least-cost paths on a grid of 200 cells along the longer side; near peaks (3 km) a step costs up
/// to seven times its length. One search outward from all goals serves all rivers.
class RiverRouting {
 public:
  RiverRouting(const VectorMap& map, const LandRegion& land, const RiverGraph& graph,
               const std::vector<Outlet>& outlets);

  /// Points after `from`, the last on the goal; straight to `otherwise` where no way is found.
  Polyline way_from(glm::dvec2 from, glm::dvec2 otherwise) const;

 private:
  void search(const Raster<float>& cost);

  const LandRegion& land_;
  Grid grid_;
  Raster<int> next_;  // the cell towards the goal; itself at a goal, -1 without a way
  SegmentTree rivers_;
};

}  // namespace orogen
