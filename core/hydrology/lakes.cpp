#include "hydrology/lakes.h"

#include <algorithm>
#include <vector>

#include "hydrology/base_level.h"
#include "hydrology/depressions.h"

namespace orogen {

namespace {

constexpr double kSquareMetres = 1e6;  // a km²

/// Takes the water that hangs together with a cell out of `fresh`, and lists it.
std::vector<std::size_t> take_lake(std::size_t from, const Raster<float>& level,
                                   Raster<std::uint8_t>& fresh) {
  const Grid& grid = level.grid();
  std::vector<std::size_t> lake{from};
  fresh[from] = 0;
  for (std::size_t k = 0; k < lake.size(); ++k) {
    const int r = int(lake[k] / grid.nx), c = int(lake[k] % grid.nx);
    for (int dr = -1; dr <= 1; ++dr)
      for (int dc = -1; dc <= 1; ++dc) {
        if (!grid.contains(r + dr, c + dc)) continue;
        const std::size_t next = grid.index(r + dr, c + dc);
        if (!fresh[next] || level[next] != level[from]) continue;
        fresh[next] = 0;
        lake.push_back(next);
      }
  }
  return lake;
}

}  // namespace

Raster<float> lake_depth(const Raster<float>& elevation, const Raster<std::uint8_t>& outside,
                         const Raster<float>* before, const LakeParameters& parameters,
                         const Context& context) {
  check_parameters(parameters);
  const Grid& grid = elevation.grid();
  Raster<std::uint8_t> open = outside;  // where water leaves
  open_sides(open);
  FlowGraph flow(open);
  Raster<float> level = elevation;  // of the sea: its surface, not its floor
  for (std::size_t i = 0; i < level.size(); ++i)
    if (outside[i]) level[i] = std::max(level[i], 0.0f);
  flow.route(level, context);
  const Raster<float> ground = level;
  filled_level(flow, ground, level, context);
  Raster<float> depth(grid);
  Raster<std::uint8_t> fresh(grid);
  for (std::size_t i = 0; i < fresh.size(); ++i) fresh[i] = level[i] > ground[i];
  for (std::size_t i = 0; i < fresh.size(); ++i) {
    if (!fresh[i]) continue;
    const std::vector<std::size_t> lake = take_lake(i, level, fresh);
    double deepest = 0.0;
    bool wet = parameters.new_lakes || !before;
    for (const std::size_t cell : lake) {
      deepest = std::max(deepest, double(level[cell]) - ground[cell]);
      wet = wet || (*before)[cell] > 0.0f;
    }
    const double area = double(lake.size()) * grid.cell_area();
    if (!wet || area < parameters.least_lake_area * kSquareMetres ||
        deepest < parameters.least_lake_depth)
      continue;
    for (const std::size_t cell : lake) depth[cell] = level[cell] - ground[cell];
  }
  return depth;
}

}  // namespace orogen
