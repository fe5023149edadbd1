// A tree's mesh: stems as tubes, leaves as flat polygons (Weber and Penn 1995, sections 4.4 to 4.7
// and 5; paper B, VII-C).
//
// A tube is open at its foot, which lies within its parent (the trunk's below the ground), and
// closed at its tip. Cross-sections are circles, on the trunk with lobes: r (1 + LobeDepth
// sin(Lobes angle)).
//
// Quality q is the paper's: a share q of the leaves is kept, each 1/√q times as wide and as long,
// so that the crown stays as dense. A share q of the twigs (the last level, from level 2 on) is
// kept too, and tubes have fewer sides and rings. What is kept at a lower quality is a part of what
// is kept at a higher one. Below a half, leaves have four corners.
#pragma once

#include <tuple>

#include "foundation/context.h"
#include "foundation/parameters.h"
#include "vegetation/plant_mesh.h"
#include "vegetation/tree_skeleton.h"

namespace orogen {

struct TreeMeshParameters {
  double quality = 1.0;
  int trunk_sides = 16;
  bool leaf_cards = false;
};

constexpr auto parameter_table(const TreeMeshParameters*) {
  using P = TreeMeshParameters;
  return std::tuple{
      real("quality", &P::quality, 0.001, 1.0, "1",
           "Share of leaves and twigs that is kept; the fewer leaves the larger they are."),
      integer("trunk_sides", &P::trunk_sides, 3, 128, "",
              "Sides of the trunk's cross-section at full quality; thinner stems have fewer."),
      boolean("leaf_cards", &P::leaf_cards,
              "Leaves are rectangles, for pictures with transparency, instead of outlines."),
  };
}

/// InputError if a parameter is out of range.
PlantMesh mesh_tree(const TreeSkeleton& tree, const TreeMeshParameters& parameters,
                    const Context& context);

}  // namespace orogen
