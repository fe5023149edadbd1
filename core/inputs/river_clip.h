// Drawn rivers without what lies in the sea, outside the frame, or at an end inside a lake.
#pragma once

#include <vector>

#include "inputs/land_region.h"
#include "inputs/map_report.h"
#include "inputs/river_graph.h"

namespace orogen {

/// One line a river; more where the sea parts it in pieces of at least a quarter of what is on
/// land (smaller ones are left out). Ends that were cut lie on the coast, shore or frame.
std::vector<RiverLine> clip_rivers(const std::vector<River>& rivers, const LandRegion& land,
                                   MapReport& report);

/// Where the way from a to b first meets a segment of the tree.
std::optional<glm::dvec2> first_crossing(const SegmentTree& tree, glm::dvec2 a, glm::dvec2 b);

double length_of(const Polyline& line);

}  // namespace orogen
