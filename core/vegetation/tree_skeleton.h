// The axes of a tree's stems and the places of its leaves (Weber and Penn 1995, sections 3 and 4).
//
// scale_tree = Scale ± ScaleV,  length_trunk = (0Length ± 0LengthV) scale_tree
// length_1   = length_trunk (1Length ± V) ShapeRatio(Shape, (length_trunk - offset) /
//                                                    (length_trunk - BaseSize scale_tree))
// length_n   = (nLength ± V) (length_parent - 0.6 offset)
// radius     = length_trunk Ratio 0Scale;  radius_n = radius_parent (length / length_parent)^
//              RatioPower, at most the parent's where the stem leaves it
// children   at most nBranches: 1Branches on the trunk; on a branch 2Branches (0.2 + 0.8 (length /
// length_parent) /
//            1Length); deeper nBranches (1 - 0.5 offset / length_parent);
//            leaves: Leaves ShapeRatio(tapered_cylindrical, offset / length_parent)
//
// with offset the distance along the parent where a stem leaves it, all in metres. Children stand
// evenly along their parent, on the trunk above BaseSize.
//
// Where the paper is silent: a fork takes children over: they go by turns to the forks that reach
// their height, so that forks thin a stem out and never multiply what it bears. How often a stem
// forks is diffused along it, beginning with a random error. The variation of the curve is about
// both axes across the stem. Forks of hanging stems part as those of upright ones do. A stem is
// pruned by the largest factor, in steps of 1/32, with which its nodes lie within the envelope, and
// in any case above the ground; the trunk is not. Leaves are not kept within.
//
// Everything random is a function of the seed and of a stem's place in the tree alone.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "foundation/context.h"
#include "vegetation/frame.h"
#include "vegetation/tree_parameters.h"

namespace orogen {

/// A stem, or a fork of one. A fork has the length, the radius and the level of what it forked
/// from, and begins at `start` along it. Forks follow their stem in the list.
struct Stem {
  int level = 0;
  std::int32_t parent = -1;       // the stem or fork that it grows from; -1: the ground
  std::int32_t forked_from = -1;  // -1: a stem of its own
  double offset = 0.0;            // m along the parent
  double length = 0.0;            // m, from the foot of the whole stem
  double radius = 0.0;            // m at its foot, without flare
  double start = 0.0;             // m along the whole stem
  std::int32_t first_node = 0, nodes = 0;
};

struct StemNode {
  glm::dvec3 position;  // m, the tree's foot at 0, z up
  Frame frame;          // z along the segment that begins here, at the tip along the last
};

struct TreeLeaf {
  std::int32_t stem = 0;
  glm::vec3 position, direction, side;  // from its foot to its tip; across, in its plane
};

struct TreeSkeleton {
  TreeParameters parameters;
  double scale = 0.0;       // m, as drawn
  std::vector<Stem> stems;  // by level, each with its forks after it
  std::vector<StemNode> nodes;
  std::vector<TreeLeaf> leaves;
};

/// InputError as `check_tree`.
TreeSkeleton grow_tree(const TreeParameters& parameters, std::uint64_t seed,
                       const Context& context);

/// The axis at `along` metres of a stem (from `start` to `length`), smooth through its nodes.
StemNode stem_place(const TreeSkeleton& tree, const Stem& stem, double along);

/// Radius there in metres, with taper and, on the trunk, flare; without lobes.
double stem_radius(const TreeSkeleton& tree, const Stem& stem, double along);

/// Whether a place in metres lies within the envelope that prunes.
bool within_envelope(const TreeParameters& parameters, double scale, glm::dvec3 place);

}  // namespace orogen
