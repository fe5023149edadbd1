// Crest and trough lines of folds (paper C, section 5.2, Fig. 8).
//
// Energy of a segment of direction d under the compression C at the middle m of an edge:
//
//   e(d) = |d · C(m)| / (|d| |C(m)|)      0: along the folds, 1: across them
//
// An edge of the mesh (fold_mesh.h) with faces on both sides belongs to the top skeleton S_t, the
// crests, if
//   e < e(d_k) for all four dual edges d_k (middle of another edge of the left face to middle of
//       another edge of the right one), and
//   e < 1/2, so that it lies within 30° of the folds: the one edge of an equilateral triangle that
//       does, whatever way the triangle is turned.
// Where C(m) = 0 there is none. Of three chosen edges of a face the one of highest energy is
// dropped (edges chosen by hand last). The paper asks for energy below "one of" the dual edges;
// that chooses triple joints nearly everywhere. Below all four, without the second rule, 12% of
// nodes are ends and 11% triple joints, with crests 0.895 λ apart; with it 22% and 7.2%, 0.955 λ,
// and folds 4.2 λ long (the paper's Table 3: 21.2% and 7.5%). C at the dual edges' own middles
// instead gives the same.
//
// The bottom skeleton S_b, the troughs, has in each face, by the number of its chosen edges:
//   2  middle of the other edge to the face's centre
//   1  middle of one unchosen edge to that of the other
//   0  middle of each edge to the centre
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "folding/fold_edits.h"
#include "folding/fold_mesh.h"
#include "folding/segment.h"
#include "foundation/context.h"
#include "tectonics/compression.h"

namespace orogen {

struct FoldSkeleton {
  FoldMesh mesh;
  std::vector<FoldChoice> choice;         // by edge: how it came into S_t
  std::vector<Segment> top;               // S_t
  std::vector<Segment> bottom;            // S_b
  std::vector<int> edits_without_effect;  // numbers of Add and Remove edits
};

/// C by place, bilinear; its cells are turned alike first, since C and -C mean the same.
glm::dvec2 compression_at(const CompressionField& field, glm::dvec2 p);

/// The skeletons of the layer with wavelength λ over the field's grid, with Add and Remove edits
/// applied. InputError for a bad edit or a wavelength far too short.
FoldSkeleton fold_skeleton(const CompressionField& field, const FoldWavelength& wavelength,
                           std::span<const FoldEdit> edits, std::uint32_t seed,
                           const Context& context);

}  // namespace orogen
