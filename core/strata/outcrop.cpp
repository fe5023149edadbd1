#include "strata/outcrop.h"

#include <vector>

#include "foundation/errors.h"
#include "foundation/parallel.h"

namespace orogen {

OutcropMap outcrop_map(const HorizonStack& horizons, const RockTable& rocks,
                       const Raster<float>& elevation, double elapsed_years,
                       const OutcropParameters& parameters, const Context& context) {
  check_parameters(parameters);
  if (horizons.layers() != rocks.layers())
    throw InputError("horizons: there must be one more than the column has layers");
  const Grid& grid = elevation.grid();
  const bool same_grid = horizons.grid() == grid;
  OutcropMap map{Raster<std::int32_t>(grid), Raster<std::int32_t>(grid), Raster<std::int32_t>(grid),
                 Raster<float>(grid), Raster<float>(grid)};
  parallel_rows(context, grid.ny, [&](int r) {
    std::vector<float> h(horizons.heights.size());
    for (int c = 0; c < grid.nx; ++c) {
      const std::size_t i = grid.index(r, c);
      if (same_grid)
        for (std::size_t k = 0; k < h.size(); ++k) h[k] = horizons.heights[k][i];
      else
        horizons.at(grid.center(r, c), h.data());
      const Rock rock = rocks.rock_at(h.data(), elevation[i]);
      map.rock_layer[i] = rock.layer;
      map.rock_sublayer[i] = rock.sub_layer;
      map.strata_color[i] = std::int32_t(rocks.color(rock));
      map.erodibility[i] = rocks.erodibility(rock);
      const bool rock_is_old = rock.layer <= rocks.layers();
      map.age[i] =
          rock_is_old ? float(elapsed_years + rocks.age(rock, parameters.deposition_rate)) : 0.0f;
    }
  });
  return map;
}

const StageInfo& outcrop_stage() {
  static const StageInfo info{
      "outcrop",
      "Finds the rock at the surface: its layer, age, erodibility and colour.",
      "Cordonnier et al. 2018, section 6.2",
      {"elevation", "exhumation"},
      {"rock_layer", "rock_sublayer", "strata_color", "erodibility", "age"},
      {"column"}};
  return info;
}

}  // namespace orogen
