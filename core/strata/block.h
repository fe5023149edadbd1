// Meshes of folded rock: a section as a standing sheet, a block diagram (the terrain with strata on
// its four walls, and a base), and horizons as surfaces.
//
// Faces are quadrangles (a corner may be named twice: a triangle), counter-clockwise seen from
// outside. Every face carries its layer, sub-layer and colour. The block's walls stand on the
// centres of the grid's outermost cells, where the terrain's mesh ends too: the block is closed.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "foundation/context.h"
#include "strata/section.h"

namespace orogen {

struct RockMesh {
  std::vector<glm::vec3> vertices;                 // m, less the grid's origin
  std::vector<std::array<std::int32_t, 4>> faces;  // vertices of each
  std::vector<std::int32_t> layer, sub_layer;      // of each face
  std::vector<std::uint32_t> color;                // of each face, sRGB 0xRRGGBB
};

/// The section's bands as a sheet; its faces look to the right of the line.
RockMesh section_mesh(const Section& section, glm::dvec2 origin);

/// InputError unless the base lies below all ground and the grid has at least 2 × 2 cells.
RockMesh block_diagram(const RockBody& body, double base, const Context& context);

/// InputError for a horizon that is none, or a grid of less than 2 × 2 cells.
void check_horizon(const RockBody& body, int horizon);

/// Horizon k; where `only_below_ground`, faces whose corners all lie above ground are left out.
RockMesh horizon_mesh(const RockBody& body, int horizon, bool only_below_ground,
                      const Context& context);

}  // namespace orogen
