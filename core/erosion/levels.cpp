#include "erosion/levels.h"

#include <algorithm>

#include "foundation/gaussian_blur.h"

namespace orogen {

std::vector<Grid> level_grids(const Grid& finest, int coarsest_cells) {
  std::vector<Grid> grids;
  const int longer = std::max(finest.nx, finest.ny);
  for (int n = coarsest_cells; n < 0.75 * longer; n *= 2)
    grids.push_back(grid_over(finest.origin, {finest.width(), finest.height()}, n));
  grids.push_back(finest);
  return grids;
}

Raster<float> blurred_land(const Raster<std::uint8_t>& land, double sigma, const Context& context) {
  Raster<float> share(land.grid());
  for (std::size_t i = 0; i < share.size(); ++i) share[i] = land[i] ? 1.0f : 0.0f;
  return gaussian_blur(share, sigma, context);
}

Raster<float> blur_over_land(const Raster<float>& field, const Raster<std::uint8_t>& land,
                             const Raster<float>& share, double sigma, const Context& context) {
  Raster<float> result(land.grid());
  for (std::size_t i = 0; i < result.size(); ++i) result[i] = land[i] ? field[i] : 0.0f;
  result = gaussian_blur(result, sigma, context);
  for (std::size_t i = 0; i < result.size(); ++i) result[i] /= std::max(share[i], 1e-6f);
  return result;
}

}  // namespace orogen
