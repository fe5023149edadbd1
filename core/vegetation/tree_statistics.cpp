#include "vegetation/tree_statistics.h"

#include <algorithm>
#include <cmath>

namespace orogen {

TreeStatistics tree_statistics(const TreeSkeleton& tree) {
  TreeStatistics result;
  for (const Stem& stem : tree.stems) {
    StemStatistics& level = result.levels[stem.level];
    if (stem.forked_from >= 0) {
      ++level.forks;
      continue;
    }
    level.shortest = level.stems ? std::min(level.shortest, stem.length) : stem.length;
    level.longest = std::max(level.longest, stem.length);
    level.mean += stem.length;
    ++level.stems;
  }
  for (StemStatistics& level : result.levels)
    if (level.stems) level.mean /= level.stems;
  for (const StemNode& node : tree.nodes) {
    result.height = std::max(result.height, node.position.z);
    result.crown_radius =
        std::max(result.crown_radius, std::hypot(node.position.x, node.position.y));
  }
  result.leaves = tree.leaves.size();
  result.trunk_radius = tree.stems.front().radius;
  return result;
}

}  // namespace orogen
