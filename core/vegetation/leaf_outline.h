// Outlines of leaves: polygons in the unit square of their UVs, from the foot (0.5, 0)
// anticlockwise, seen from above with the tip at the top.
#pragma once

#include <glm/vec2.hpp>
#include <span>

#include "vegetation/tree_parameters.h"

namespace orogen {

/// `simple`: four corners instead, for leaves seen from afar.
std::span<const glm::vec2> leaf_outline(LeafShape shape, bool simple);

}  // namespace orogen
