#include "tectonics/ground_shift.h"

#include "foundation/bilinear.h"
#include "foundation/parallel.h"

namespace orogen {

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
      const glm::dvec2 origin = grid.center(r, c) + glm::dvec2(shift.x(r, c), shift.y(r, c));
      after(r, c) = float(bilinear_at(grid, origin)(before));
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
