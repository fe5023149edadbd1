#include "sculpting/sea_floor.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "foundation/noise.h"
#include "foundation/parallel.h"

namespace orogen {

namespace {

constexpr double kLeastDepth = 0.5;         // m
constexpr double kWanderWavelength = 12e3;  // m, of the shelf's edge
constexpr double kReliefWavelength = 6e3;   // m

double smoothstep(double t) {
  t = std::clamp(t, 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

double smooth_depth(double distance, const SeaFloorParameters& p) {
  const double t = std::clamp(distance / p.shelf_width, 0.0, 1.0);
  const double shelf = p.shelf_depth * t * (2.0 - t);
  const double drop = std::max(0.0, p.deep_depth - p.shelf_depth);
  return shelf + drop * smoothstep((distance - p.shelf_width) / p.slope_width);
}

}  // namespace

void lay_sea_floor(Raster<float>& elevation, const Raster<std::uint8_t>& land,
                   const Raster<float>& coast_distance, const SeaFloorParameters& parameters,
                   std::uint32_t seed, const Context& context) {
  check_parameters(parameters);
  const Grid& grid = elevation.grid();
  const FbmParameters wander{.seed = seed, .wavelength = kWanderWavelength, .octaves = 4};
  const FbmParameters relief{.seed = seed + 1, .wavelength = kReliefWavelength, .octaves = 6};
  parallel_rows(context, grid.ny, [&](int r) {
    if (std::all_of(land.row(r), land.row(r) + grid.nx, [](auto v) { return v != 0; })) return;
    std::vector<double> x(grid.nx), y(grid.nx, grid.center(r, 0).y);
    for (int c = 0; c < grid.nx; ++c) x[c] = grid.center(r, c).x;
    std::vector<float> moved(grid.nx), rough(grid.nx);
    fbm(wander, x.data(), y.data(), moved.data(), grid.nx);
    fbm(relief, x.data(), y.data(), rough.data(), grid.nx);
    for (int c = 0; c < grid.nx; ++c) {
      if (land(r, c)) continue;
      const double d = coast_distance(r, c);
      const double depth = smooth_depth(d * (1.0 + 0.25 * std::tanh(moved[c])), parameters);
      const double wavy = depth * (1.0 + parameters.sea_floor_relief * std::tanh(rough[c]));
      elevation(r, c) = float(-std::max(kLeastDepth, wavy));
    }
  });
}

}  // namespace orogen
