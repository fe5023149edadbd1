// Where ground stood before the motions of later phases (several phases: an addition to paper C).
//
//   s_p(x) = Φ_{p+1}⁻¹(Φ_{p+2}⁻¹(... Φ_P⁻¹(x))) − x          carried f(x) = f(x + s_p(x))
//
// What phase p lifts and folds stands where that phase left it. Later phases carry it on: their
// transport fields (transport_field.h) bend, shift and squeeze it, so that folds of an older phase
// are deformed by the younger ones that cross them. Everything is then given at its last place.
//
// Limits: sampled bilinearly; ground that comes from outside the grid mirrors that inside.
// Directions (of a dipping fault's motion) are carried, but not turned.
#pragma once

#include <glm/vec2.hpp>
#include <span>
#include <tuple>

#include "foundation/context.h"
#include "foundation/parameters.h"
#include "foundation/raster.h"
#include "tectonics/transport_field.h"

namespace orogen {

struct PhaseParameters {
  bool carry_older_phases = true;
};

constexpr auto parameter_table(const PhaseParameters*) {
  return std::tuple{boolean("carry_older_phases", &PhaseParameters::carry_older_phases,
                            "Whether later phases carry along what earlier ones lift and fold.")};
}

/// s, m. Empty rasters: nothing moved.
struct GroundShift {
  Raster<float> x, y;
  bool empty() const { return x.empty(); }
};

/// By the phases `later`, in their order; empty if there are none.
GroundShift ground_shift(std::span<const TransportField> later, const Grid& grid,
                         const Context& context);

/// A field of the time before, at its last place.
Raster<float> carried(Raster<float> before, const GroundShift& shift, const Context& context);

/// Where the ground at a place stood before (m).
glm::dvec2 place_before(glm::dvec2 place, const GroundShift& shift);

}  // namespace orogen
