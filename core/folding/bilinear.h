// Where a place lies between the four nearest cell centres of a grid; beyond the outermost centres
// it is moved onto them.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "foundation/grid.h"

namespace orogen {

struct Bilinear {
  std::array<std::size_t, 4> cells{};  // south-west, south-east, north-west, north-east
  std::array<double, 4> weights{};

  Bilinear(const Grid& grid, glm::dvec2 p) {
    const glm::dvec2 place = grid.to_cells(p) - glm::dvec2(0.5);
    const double x = std::clamp(place.x, 0.0, grid.nx - 1.0);
    const double y = std::clamp(place.y, 0.0, grid.ny - 1.0);
    const int c = int(x), r = int(y);
    const int c1 = std::min(c + 1, grid.nx - 1), r1 = std::min(r + 1, grid.ny - 1);
    const double u = x - c, v = y - r;
    cells = {grid.index(r, c), grid.index(r, c1), grid.index(r1, c), grid.index(r1, c1)};
    weights = {(1.0 - u) * (1.0 - v), u * (1.0 - v), (1.0 - u) * v, u * v};
  }
};

}  // namespace orogen
