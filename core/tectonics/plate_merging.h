// Merging of sub-plates into plates (paper A, section 4, "Sub-plate merging process").
//
//   A and B merge if û_A · û_B > T1        (û: velocity over its length)
//   A merges with its largest neighbour B if area_A / area_B < T2
//   u_C = (area_A u_A + area_B u_B) / (area_A + area_B)
//
// The paper leaves the order open. Here: of all neighbours that may merge by T1, the pair with the
// greatest û_A · û_B goes first (then the lowest numbers), until none is left; then the smallest
// plate that T2 concerns; then T1 again. A plate whose speed is below `slow` of the fastest
// sub-plate's has no direction and merges by T2 alone. The two sides of a chain of peaks never
// merge.
#pragma once

#include <glm/vec2.hpp>
#include <utility>
#include <vector>

namespace orogen {

struct SubPlate {
  double area = 0.0;  // m²
  glm::dvec2 velocity{0.0, 0.0};
  int opposite = -1;  // the sub-plate across the chain that this one is a side of
};

struct MergeThresholds {
  double direction = 0.5;  // T1
  double area = 0.15;      // T2
  double slow = 1e-6;
};

/// Number of the merged plate of each sub-plate, counted from 0 in the order of the plates' first
/// sub-plates. `neighbours`: pairs that share a side.
std::vector<int> merge_plates(const std::vector<SubPlate>& sub_plates,
                              const std::vector<std::pair<int, int>>& neighbours,
                              const MergeThresholds& thresholds);

}  // namespace orogen
