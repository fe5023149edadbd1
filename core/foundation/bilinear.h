// Bilinear interpolation between the values of a raster, held at its border.
#pragma once

#include <algorithm>
#include <glm/vec2.hpp>

#include "foundation/raster.h"

namespace orogen {

/// Weights of the four values around a place; `cells` counts from the first value, in steps between
/// values.
struct Bilinear {
  int c0, c1, r0, r1;
  double u, v;

  Bilinear(glm::dvec2 cells, int columns, int rows) {
    const double x = std::clamp(cells.x, 0.0, columns - 1.0);
    const double y = std::clamp(cells.y, 0.0, rows - 1.0);
    c0 = int(x);
    r0 = int(y);
    c1 = std::min(c0 + 1, columns - 1);
    r1 = std::min(r0 + 1, rows - 1);
    u = x - c0;
    v = y - r0;
  }

  /// `value(row, column)` gives the values, in double.
  template <class Value>
  auto operator()(Value&& value) const {
    return (1 - v) * ((1 - u) * value(r0, c0) + u * value(r0, c1)) +
           v * ((1 - u) * value(r1, c0) + u * value(r1, c1));
  }
  double operator()(const Raster<float>& raster) const {
    return (*this)([&](int r, int c) { return double(raster(r, c)); });
  }
};

/// For rasters on `grid`, at a place in metres.
inline Bilinear bilinear_at(const Grid& grid, glm::dvec2 position) {
  return {grid.to_cells(position) - 0.5, grid.nx, grid.ny};
}

}  // namespace orogen
