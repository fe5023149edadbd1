// A regular grid as a mesh.
#include <cmath>
#include <string>

#include "foundation/errors.h"
#include "foundation/parallel.h"
#include "foundation/tin.h"

namespace orogen {

namespace {

constexpr double kMostCells = 100e6;

void join_eight(Tin& tin, int columns, int rows, glm::dvec2 cell) {
  const float lengths[] = {float(std::hypot(cell.x, cell.y)), float(cell.x), float(cell.y)};
  tin.first_edge.reserve(tin.size() + 1);
  tin.neighbors.reserve(8 * tin.size());
  tin.edge_lengths.reserve(8 * tin.size());
  tin.first_edge.push_back(0);
  for (int r = 0; r < rows; ++r)
    for (int c = 0; c < columns; ++c) {
      for (int south = -1; south <= 1; ++south)
        for (int west = -1; west <= 1; ++west) {
          const int y = r + south, x = c + west;
          if ((south == 0 && west == 0) || x < 0 || y < 0 || x >= columns || y >= rows) continue;
          tin.neighbors.push_back(std::int32_t(y) * columns + x);
          tin.edge_lengths.push_back(lengths[south == 0 ? 1 : west == 0 ? 2 : 0]);
        }
      tin.first_edge.push_back(std::int32_t(tin.neighbors.size()));
    }
}

}  // namespace

Tin grid_tin(const TinDomain& area, int columns, int rows) {
  area.check();
  if (columns < 2 || rows < 2 || double(columns) * rows > kMostCells)
    throw InputError("columns, rows: " + std::to_string(columns) + " x " + std::to_string(rows) +
                     " cells are not allowed; 2 x 2 to " + std::to_string(int(kMostCells)));
  const glm::dvec2 cell = area.size / glm::dvec2(columns, rows);
  Tin tin{.domain = {area.origin + 0.5 * cell, area.size - cell}};
  tin.columns = columns;
  const std::size_t count = std::size_t(columns) * rows;
  tin.points.reserve(count);
  tin.sides.reserve(count);
  for (int r = 0; r < rows; ++r)
    for (int c = 0; c < columns; ++c) {
      tin.points.push_back(
          {c + 1 < columns ? area.origin.x + (c + 0.5) * cell.x : tin.domain.far_corner().x,
           r + 1 < rows ? area.origin.y + (r + 0.5) * cell.y : tin.domain.far_corner().y});
      tin.sides.push_back(
          std::uint8_t((c == 0 ? kWestSide : 0) | (c + 1 == columns ? kEastSide : 0) |
                       (r == 0 ? kSouthSide : 0) | (r + 1 == rows ? kNorthSide : 0)));
    }
  tin.triangles.reserve(2 * count);
  for (int r = 0; r + 1 < rows; ++r)
    for (int c = 0; c + 1 < columns; ++c) {
      const std::int32_t a = std::int32_t(r) * columns + c, d = a + columns;
      tin.triangles.push_back({a, a + 1, d + 1});
      tin.triangles.push_back({a, d + 1, d});
    }
  join_eight(tin, columns, rows, cell);
  tin.cell_areas.assign(count, cell.x * cell.y);
  return tin;
}

}  // namespace orogen
