// Rivers as drawn, made into trees that run from source to mouth.
//
// Real maps are rough: rivers are drawn either way, cross, overshoot, stop short of what they flow
// into, run out to sea. The network is found in four steps:
//   1. what lies in the sea, outside the frame or (at an end) inside a lake is cut off;
//   2. lines that cross or touch are given a common vertex, and make a graph;
//   3. each connected part that reaches neither sea, lake nor frame is carried on from one of its
//      ends: parts and ends are chosen together as the cheapest arborescence rooted in the sea
//      (Chu and Liu 1965, Edmonds 1967) over distance plus what speaks against a mouth (nearness to
//      peaks against nearness to the sea, what the file says of direction and end). Up to
//      `snap_distance` it goes straight; further, along the cheapest way over land, off the peaks;
//   4. every reach runs towards the end with the shorter way to an outlet along the graph. Where a
//      cycle leaves a reach over, it begins afresh below the fork, or goes if it is short.
// All that changes a drawn line is a warning. Not guaranteed: the true course where the drawing is
// ambiguous (two rivers that share their source, a river between two seas); a river from sea to sea
// keeps its drawn direction. Rivers that cross inside a lake may begin or end inside it.
#pragma once

#include <vector>

#include "inputs/land_region.h"
#include "inputs/map_draft.h"

namespace orogen {

/// Replaces map.rivers; map.coasts, lakes, peaks and frame are checked.
void connect_rivers(VectorMap& map, const std::vector<RiverHint>& hints, const LandRegion& land,
                    const ReadOptions& options, MapReport& report);

}  // namespace orogen
