#include "tectonics/ground_shift.h"

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

}  // namespace

GroundShift ground_shift(std::span<const TransportField> later, const Grid& grid,
                         const Context& context) {
  if (later.empty()) return {};
  GroundShift shift{Raster<float>(grid), Raster<float>(grid)};
  parallel_rows(context, grid.ny, [&](int r) {
    for (int c = 0; c < grid.nx; ++c) {
      const glm::dvec2 place = grid.center(r, c);
      glm::dvec2 before = place;
      for (std::size_t p = later.size(); p-- > 0;) before = later[p].inverse(before);
      shift.x(r, c) = float(before.x - place.x);
      shift.y(r, c) = float(before.y - place.y);
    }
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
