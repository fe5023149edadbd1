// How one stem grows, with its forks: curvature, splits, attraction up, pruning (Weber and Penn
// 1995, sections 4.1, 4.2, 4.8 and 4.9).
#pragma once

#include <cstdint>

#include "foundation/random.h"
#include "vegetation/tree_skeleton.h"

namespace orogen {

/// Random numbers of one stem.
class StemDraws {
 public:
  StemDraws(std::uint64_t seed, std::uint64_t stem) : seed_(seed), stem_(stem) {}

  double uniform() { return random_uniform(seed_, stem_, counter_++); }
  /// Evenly within `middle` plus and minus `variation`.
  double around(double middle, double variation) {
    return middle + variation * (2.0 * uniform() - 1.0);
  }

 private:
  std::uint64_t seed_, stem_, counter_ = 0;
};

/// Appends `stem`, grown from `foot`, and its forks to the tree. Its length and its radius, if the
/// envelope prunes it, shrink; nothing is appended if nothing is left of it.
void grow_stem(TreeSkeleton& tree, Stem stem, const StemNode& foot, StemDraws& draws);

}  // namespace orogen
