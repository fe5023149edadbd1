// What a tree is like in numbers.
#pragma once

#include <array>

#include "vegetation/tree_skeleton.h"

namespace orogen {

struct StemStatistics {
  int stems = 0, forks = 0;
  double shortest = 0.0, mean = 0.0, longest = 0.0;  // length of stems, m
};

struct TreeStatistics {
  std::array<StemStatistics, kStemLevels> levels;
  std::size_t leaves = 0;
  double height = 0.0;        // m, of the highest node
  double crown_radius = 0.0;  // m, of the node furthest from the foot's vertical
  double trunk_radius = 0.0;  // m, without flare
};

TreeStatistics tree_statistics(const TreeSkeleton& tree);

}  // namespace orogen
