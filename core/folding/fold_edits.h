// Changes that an artist makes to the folds (paper C, section 5.2, "Local fold refinement").
//
// An edit is a line [a, b] on the map and is kept by place, not by the number of an edge: it is
// applied anew to whatever mesh the wavelength, the seed and the plates give. In order:
//
//   Add     draws a fold: the edges of the mesh nearest along the line (the path from the point
//           nearest to a to that nearest to b of least sum of length (1 + (2 d / λ)²), with d from
//           an edge's middle to the line) become crests. Crests not drawn by hand whose middle lies
//           within 0.75 λ of them give way, except beyond their ends, where folds may join
//   Remove  crests along the line are crests no more
//   Scale   multiplies the height of the crests along the line by `value`
//   Set     gives the crests along the line the height `value`, in metres
//
// A crest is along the line if its middle lies within λ/2 of it and its direction within 45°. Scale
// and Set act by the weight w = (1 - (d / λ)²)², with d the distance to those crests: whole on the
// crests, fading along and across, 0 from the next crest on. Where λ is asked, it is that in the
// middle of the edge.
//
// Limits: a line too short for the mesh, or one with no crest along it, changes nothing; the
// layers' result names those edits.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <string>
#include <vector>

#include "folding/fold_mesh.h"
#include "foundation/context.h"
#include "foundation/raster.h"

namespace orogen {

enum class FoldEditKind { Add, Remove, Scale, Set };

struct FoldEdit {
  FoldEditKind kind = FoldEditKind::Add;
  glm::dvec2 a{0.0, 0.0}, b{0.0, 0.0};  // m
  double value = 1.0;                   // Scale: a factor, 0 to 100; Set: m, 0 to 20 km
};

/// InputError naming the edit if a place is not finite or a value out of range; `place` begins the
/// message.
void check_fold_edits(std::span<const FoldEdit> edits, const std::string& place = "");

/// How an edge came to be chosen, or not.
enum class FoldChoice : std::uint8_t { None, ByEnergy, ByHand };

/// Applies Add and Remove, in order. Returns the numbers of those without effect.
std::vector<int> edit_choice(const FoldMesh& mesh, const FoldWavelength& wavelength,
                             std::span<const FoldEdit> edits, std::vector<FoldChoice>& choice);

/// Applies Scale and Set, in order, to the crests' speed (m/yr; the height is that after
/// `folding_time`, yr). Returns the numbers of those without effect.
std::vector<int> edit_heights(const FoldMesh& mesh, const FoldWavelength& wavelength,
                              std::span<const FoldChoice> choice, std::span<const FoldEdit> edits,
                              double folding_time, Raster<float>& crest_speed,
                              const Context& context);

}  // namespace orogen
