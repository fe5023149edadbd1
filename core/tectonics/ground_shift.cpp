#include "tectonics/ground_shift.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "foundation/bilinear.h"
#include "foundation/parallel.h"

namespace orogen {

namespace {

/// Mirrored at 0 and at `last` until it lies between.
double mirrored(double x, double last) {
  if (!(last > 0.0)) return 0.0;
  return std::fabs(std::remainder(x, 2.0 * last));
}

constexpr int kTogether = 32;  // cells of a row

/// The last phase's motion is undone for many cells together, those before it place by place.
void shift_cells(std::span<const TransportField> later, int row, int column, int count,
                 GroundShift& shift) {
  const Grid& grid = shift.x.grid();
  const double half = 0.5 * (count - 1) * grid.cell_size;
  const glm::dvec2 first = grid.center(row, column);
  const TransportField::Patch patch(later.back(), first + glm::dvec2(half, 0.0), half);
  std::array<double, kTogether> x, from_x, from_y;
  for (int j = 0; j < count; ++j) x[j] = grid.center(row, column + j).x;
  patch.inverse(x.data(), first.y, from_x.data(), from_y.data(), count);
  for (int j = 0; j < count; ++j) {
    glm::dvec2 before(from_x[j], from_y[j]);
    for (std::size_t p = later.size() - 1; p-- > 0;) before = later[p].inverse(before);
    shift.x(row, column + j) = float(before.x - x[j]);
    shift.y(row, column + j) = float(before.y - first.y);
  }
}

}  // namespace

GroundShift ground_shift(std::span<const TransportField> later, const Grid& grid,
                         const Context& context) {
  if (later.empty()) return {};
  GroundShift shift{Raster<float>(grid), Raster<float>(grid)};
  parallel_rows(context, grid.ny, [&](int r) {
    for (int c = 0; c < grid.nx; c += kTogether)
      shift_cells(later, r, c, std::min(kTogether, grid.nx - c), shift);
  });
  return shift;
}

Raster<float> carried(Raster<float> before, const GroundShift& shift, const Context& context) {
  if (shift.empty()) return before;
  const Grid& grid = before.grid();
  Raster<float> after(grid);
  parallel_rows(context, grid.ny, [&](int r) {
    for (int c = 0; c < grid.nx; ++c) {
      const double column = mirrored(c + shift.x(r, c) / grid.cell_size, grid.nx - 1);
      const double row = mirrored(r + shift.y(r, c) / grid.cell_size, grid.ny - 1);
      after(r, c) = float(Bilinear({column, row}, grid.nx, grid.ny)(before));
    }
  });
  return after;
}

glm::dvec2 place_before(glm::dvec2 place, const GroundShift& shift) {
  if (shift.empty()) return place;
  const Bilinear at = bilinear_at(shift.x.grid(), place);
  return place + glm::dvec2(at(shift.x), at(shift.y));
}

}  // namespace orogen
