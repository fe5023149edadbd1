#include "strata/map_strata.h"

#include <algorithm>

#include "foundation/errors.h"
#include "foundation/gaussian_blur.h"

namespace orogen {

HorizonStack map_horizons(const StratigraphicColumn& column, const Raster<float>& ground,
                          std::span<const Raster<float>> folds,
                          const MapStrataParameters& parameters, const Context& context) {
  check_parameters(parameters);
  check_column(column);
  const Grid& grid = ground.grid();
  const std::size_t n = column.layers.size();
  if (folds.size() != n) throw InputError("folds: one raster for each layer is wanted");
  HorizonStack stack;
  stack.heights.resize(n + 1);
  Raster<float> height = gaussian_blur(ground, parameters.smoothing, context);
  for (float& z : height.values()) z *= float(1.0 + parameters.exhumation_share);
  std::vector<Raster<float>> bends;  // f - G f
  for (const Raster<float>& fold : folds) {
    if (fold.grid() != grid) throw InputError("folds: must lie on the grid of the ground");
    Raster<float>& bend = bends.emplace_back(gaussian_blur(fold, parameters.smoothing, context));
    for (std::size_t i = 0; i < bend.size(); ++i) {
      bend[i] = fold[i] - bend[i];
      height[i] += bend[i];
    }
  }
  stack.heights[n] = height;
  for (std::size_t k = n; k-- > 0;) {
    const Raster<float> thickness = thickness_raster(column.layers[k], grid, context);
    for (std::size_t i = 0; i < height.size(); ++i)  // a layer folds, but keeps a thickness
      height[i] -= std::max(thickness[i] + bends[k][i], 0.2f * thickness[i]);
    stack.heights[k] = height;
  }
  return stack;
}

const StageInfo& map_strata_stage() {
  static const StageInfo info{"map_strata",
                              "Lays folded strata under a ground that a map has shaped.",
                              "Cordonnier et al. 2018, section 6.2, for maps of Michel et al. 2015",
                              {"elevation", "compression", "fold_uplift_rate"},
                              {"exhumation"},
                              {"column"}};
  return info;
}

}  // namespace orogen
