// Which peaks stand in a single line, and which stand alone.
//
// Paper A, section 7, names both as limits of its Voronoi cells: a line of peaks is cut between the
// peaks instead of along them, and a lone peak lies off every plate boundary.
// Peaks are linked along their minimum spanning tree where they stand closer than a linking length
// (a multiple of the tree's median edge). A linked group is a chain if the longest path through its
// tree passes near all its peaks, is much longer than the group is wide and turns nowhere sharply.
// A peak is isolated if its nearest neighbour is many times farther than is usual on the map.
#pragma once

#include <glm/vec2.hpp>
#include <span>
#include <vector>

namespace orogen {

struct ChainParameters {
  int minimum_peaks = 3;          // of a chain
  double linking_factor = 2.5;    // linking length over the median edge of the spanning tree
  double width_factor = 0.6;      // largest distance from the line over the mean spacing along it
  double isolation_factor = 3.5;  // nearest neighbour's distance over the map's median of it
};

struct PeakPattern {
  std::vector<std::vector<int>> chains;  // peaks in order along each line
  std::vector<char> isolated;            // one flag a peak
};

/// Peaks at the same place count once. A map with a single peak has it isolated.
PeakPattern find_peak_pattern(std::span<const glm::dvec2> peaks, const ChainParameters& parameters);

}  // namespace orogen
