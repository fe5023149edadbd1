// Checking and mending a vector map, whether read from a file or made in code.
//
// Refused (InputError with feature, vertex and place): coordinates that are not finite or beyond
// 20,000 km, rings that cross or touch themselves or each other, coasts that overlap, coasts that
// stay open, peaks out at sea, two heights at one peak, heights outside (0, 12000] m, an empty map.
// Mended with a warning: repeated points, small gaps in coasts, peaks just off the shore, and
// rivers as described in river_network.h. Checking a checked map changes nothing.
#pragma once

#include <vector>

#include "inputs/vector_map.h"

namespace orogen {

struct ReadOptions {
  bool strict = false;            // what would be mended with a warning is refused
  double snap_distance = 5000.0;  // m, how far off a river's end may lie from what it flows into;
                                  // at most 5% of the frame's longer side
};

/// A checked and mended copy. A river whose `end` is not Sea is taken to run from source to mouth,
/// the others are oriented by where their ends lie. `frame.size` of 0 is worked out from the map's
/// extent and a margin of sea (4%, at least 2 km).
VectorMap check_map(VectorMap map, const ReadOptions& options = {});

/// What is truly coast: the coasts' rings without the stretches on or beyond the frame's sides of
/// clipped ones. A whole ring has its first point repeated at the end.
std::vector<Polyline> shorelines(const VectorMap& map);

}  // namespace orogen
