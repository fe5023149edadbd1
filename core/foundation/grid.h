// A regular grid of square cells.
//
// Row-major [row, column]; row 0 is the southern row, x points east, y north. `origin` is the
// lower-left corner of the grid in the coordinates of its map, in metres. A field's value stands at
// the centre of its cell.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/vec2.hpp>

namespace orogen {

struct Grid {
  int nx = 0;                   // columns
  int ny = 0;                   // rows
  double cell_size = 1.0;       // m
  glm::dvec2 origin{0.0, 0.0};  // m, lower-left corner

  std::size_t size() const { return std::size_t(nx) * std::size_t(ny); }
  std::size_t index(int row, int column) const { return std::size_t(row) * nx + column; }
  bool contains(int row, int column) const {
    return row >= 0 && row < ny && column >= 0 && column < nx;
  }
  double width() const { return nx * cell_size; }             // m
  double height() const { return ny * cell_size; }            // m
  double cell_area() const { return cell_size * cell_size; }  // m²

  /// Centre of a cell, in metres.
  glm::dvec2 center(int row, int column) const {
    return {origin.x + (column + 0.5) * cell_size, origin.y + (row + 0.5) * cell_size};
  }
  /// Position in cells from the lower-left corner: cell (r, c) covers [c, c+1) x [r, r+1).
  glm::dvec2 to_cells(glm::dvec2 position) const { return (position - origin) / cell_size; }
  int row_of(double y) const { return int(std::floor((y - origin.y) / cell_size)); }
  int column_of(double x) const { return int(std::floor((x - origin.x) / cell_size)); }

  bool operator==(const Grid&) const = default;
};

/// The grid over a rectangle whose longer side has `resolution` cells. The last row or column may
/// reach past the rectangle by less than a cell.
inline Grid grid_over(glm::dvec2 origin, glm::dvec2 size, int resolution) {
  const double cell = std::fmax(size.x, size.y) / resolution;
  const auto cells = [&](double length) {
    return std::max(1, int(std::ceil(length / cell - 1e-6)));
  };
  return {cells(size.x), cells(size.y), cell, origin};
}

}  // namespace orogen
