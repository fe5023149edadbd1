#include "hydrology/sea.h"

#include <vector>

namespace orogen {

Raster<std::uint8_t> land_beside_sea(const Raster<float>& elevation,
                                     const Raster<std::uint8_t>& seed) {
  const Grid& grid = elevation.grid();
  Raster<std::uint8_t> land(grid, 1);
  std::vector<std::size_t> waiting;
  const auto wet = [&](std::size_t i) {
    if (!land[i] || elevation[i] > 0.0f) return;
    land[i] = 0;
    waiting.push_back(i);
  };
  for (std::size_t i = 0; i < elevation.size(); ++i)
    if (seed[i]) wet(i);
  while (!waiting.empty()) {
    const std::size_t i = waiting.back();
    waiting.pop_back();
    const int r = int(i / grid.nx), c = int(i % grid.nx);
    if (c > 0) wet(i - 1);
    if (c + 1 < grid.nx) wet(i + 1);
    if (r > 0) wet(i - grid.nx);
    if (r + 1 < grid.ny) wet(i + grid.nx);
  }
  return land;
}

}  // namespace orogen
