// How the crust is squeezed between moving plates (paper C, sections 4.2 and 5.2).
//
//   q = a / a_cell          a: signed area (m²) of the quadrangle whose corners Φ⁻¹ of the cell's
//                           corners are; a_cell: area of the cell
//   F = (∇Φ⁻¹)⁻¹,  U = sqrt(FᵀF) = ν₁ e₁e₁ᵀ + ν₂ e₂e₂ᵀ,  ν₁ <= ν₂
//   C = (1 − ν₁) e₁ where ν₁ < 1, else 0
//
// q: amount of crust in a cell after the plates have moved, over that before; C: direction (e₁) and
// strength of compression; Φ⁻¹: transport_field.h; ∇Φ⁻¹ by central differences of the corners, so
// that its determinant is q. (The paper prints F = (I − ∇(Φ⁻¹ − I))⁻¹, whose sign would make
// compression of extension.) Crust is kept: the areas sum up to that of the preimage of the grid's
// border, because corners are shared.
//
// Limits: U gives directions as they were before the move; ground that turned by some angle on the
// way has its C turned back by it. Eq. 2 squeezes the ground behind plates that part as well
// (uplift leaves it out, collision_uplift.h). q < 0 where arrows fold the field (plates that pass
// through each other). Compression under 1e-9 counts as none.
#pragma once

#include <cmath>
#include <cstdint>

#include "foundation/context.h"
#include "foundation/raster.h"
#include "tectonics/transport_field.h"

namespace orogen {

struct CompressionField {
  Raster<float> crust;          // q
  Raster<float> compression_x;  // C, east; C and -C mean the same
  Raster<float> compression_y;  // C, north
  Raster<std::int32_t> plate;   // influence region: number of the nearest plate; -1: no plates
  double source_area_m2 = 0.0;  // Σ a: where the grid's crust came from
};

CompressionField compression_field(const TransportField& transport, const Grid& grid,
                                   const Context& context);

/// Eigenvalues and an eigenvector of U.
struct Stretch {
  double smaller, larger;                       // ν₁, ν₂
  double direction_x = 1.0, direction_y = 0.0;  // e₁; (1, 0) where all directions are alike
};

/// Of ∇Φ⁻¹ = (xx xy; yx yy). Its singular values are 1/ν; e₁ belongs to the larger.
[[gnu::always_inline]] inline Stretch stretch_of(double xx, double xy, double yx, double yy) {
  const double a = xx * xx + xy * xy, d = yx * yx + yy * yy, b = xx * yx + xy * yy;
  const double half = 0.5 * (a - d), radius = std::sqrt(half * half + b * b);
  const double greater = 0.5 * (a + d) + radius, area = std::fabs(xx * yy - xy * yx);
  constexpr double none = 1e-300;                         // makes (1, 0) of no direction
  const double cosine = (half + none) / (radius + none);  // of twice the direction's angle
  const double x = std::sqrt(std::fabs(0.5 * (1.0 + cosine)));
  const double y = std::copysign(std::sqrt(std::fabs(0.5 * (1.0 - cosine))), b);
  const double longest = std::sqrt(greater);
  return {1.0 / longest, longest / area, x, y};
}

}  // namespace orogen
