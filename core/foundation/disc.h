// The cells of a grid within a distance of a place.
#pragma once

#include <algorithm>

#include "foundation/grid.h"

namespace orogen {

/// body(cell, squared distance in m²) for each cell whose centre lies within `radius` (m) of `at`.
template <class Body>
void for_disc(const Grid& grid, glm::dvec2 at, double radius, Body&& body) {
  const int r0 = std::max(0, grid.row_of(at.y - radius));
  const int r1 = std::min(grid.ny - 1, grid.row_of(at.y + radius));
  const int c0 = std::max(0, grid.column_of(at.x - radius));
  const int c1 = std::min(grid.nx - 1, grid.column_of(at.x + radius));
  for (int r = r0; r <= r1; ++r)
    for (int c = c0; c <= c1; ++c) {
      const glm::dvec2 d = grid.center(r, c) - at;
      const double square = d.x * d.x + d.y * d.y;
      if (square <= radius * radius) body(grid.index(r, c), square);
    }
}

}  // namespace orogen
