#include "hydrology/base_level.h"

namespace orogen {

void open_sides(Raster<std::uint8_t>& base_level) {
  const Grid& grid = base_level.grid();
  for (int r = 0; r < grid.ny; ++r)
    for (int c = 0; c < grid.nx; ++c)
      if (r == 0 || c == 0 || r == grid.ny - 1 || c == grid.nx - 1) base_level(r, c) = 1;
}

BaseLevel base_level(const VectorMap& map, const Raster<std::uint8_t>& land,
                     const RiverBeds& beds) {
  const Grid& grid = land.grid();
  BaseLevel base{Raster<std::uint8_t>(grid), Raster<float>(grid)};
  bool any = false;
  for (std::size_t i = 0; i < land.size(); ++i) any |= (base.cells[i] = !land[i]);
  for (std::size_t i = 0; i < beds.cells.size(); ++i) {
    const std::int32_t cell = beds.cells[i];
    const River& river = map.rivers[beds.river[cell] - 1];
    if (beds.receivers[i] >= 0 || river.end != RiverEnd::Frame) continue;
    base.cells[cell] = 1;
    base.height[cell] = float(river.end_height_m.value_or(0.0));
    any = true;
  }
  if (!any) open_sides(base.cells);
  return base;
}

}  // namespace orogen
