// The cheapest arborescence of a directed graph (Chu and Liu 1965, Edmonds 1967).
#pragma once

#include <vector>

namespace orogen {

/// A way by which `child` may hang on `parent`.
struct Hanging {
  int parent, child;
  double cost;
};

/// For every vertex but the root the position of its chosen hanging, so that all hang on the root
/// and the sum of costs is least; -1 for the root. Every vertex must have some way to the root.
/// Equal costs are decided by position. O(vertices x hangings) at worst.
std::vector<int> cheapest_arborescence(int vertices, int root,
                                       const std::vector<Hanging>& hangings);

}  // namespace orogen
