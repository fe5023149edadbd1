#include "sculpting/combination.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "foundation/gaussian_blur.h"
#include "foundation/parallel.h"
#include "hydrology/lower_envelope.h"

namespace orogen {

namespace {

constexpr float kRounding = 30.0f;  // m, of the edge between hillside and folds

// The lower of the two, rounded off where they differ by less than `width`.
inline float smooth_min(float a, float b, float width) {
  const float overlap = std::max(width - std::fabs(a - b), 0.0f);
  return std::min(a, b) - 0.25f * overlap * (overlap / width);
}

// b: the ground that rises by `slope` from rivers and coast.
Raster<float> valley_floor(const WatershedMap& watershed, const Raster<std::uint8_t>& land,
                           double slope, const Context& context) {
  const Grid& grid = land.grid();
  Raster<float> sources(grid, std::numeric_limits<float>::infinity());
  for (std::size_t i = 0; i < grid.size(); ++i)
    if (watershed.river_distance[i] == 0.0f) sources[i] = watershed.elevation[i];
  Raster<std::int32_t> source = watershed.river_cell;
  return lower_envelope(sources, land, source, {.slope = slope}, context);
}

Raster<float> reconcile(const Raster<float>& folds, const WatershedMap& watershed,
                        const Raster<std::uint8_t>& land, const CombinationParameters& parameters,
                        const Context& context) {
  const Grid& grid = land.grid();
  Raster<float> result(grid);
  parallel_rows(context, grid.ny, [&](int r) {
    for (std::size_t i = grid.index(r, 0), end = i + grid.nx; i < end; ++i) {
      const std::int32_t river = watershed.river_cell[i];
      result[i] = river < 0 ? 0.0f : watershed.elevation[river] - folds[river];
    }
  });
  result = gaussian_blur(result, 0.25 * parameters.reconcile_distance, context);
  const Raster<float> floor = valley_floor(watershed, land, parameters.valley_slope, context);
  const float rise_over = float(parameters.reconcile_distance);
  const float fall_over = float(std::min(parameters.blend_distance, parameters.reconcile_distance));
  const float wall = float(parameters.valley_wall_slope);
  parallel_rows(context, grid.ny, [&](int r) {
    for (std::size_t i = grid.index(r, 0), end = i + grid.nx; i < end; ++i) {
      const float d = watershed.river_distance[i];
      const float x = d / (result[i] > 0.0f ? rise_over : fall_over), s = 1.0f + x * x;
      const float shifted = folds[i] + result[i] / (s * s);
      const float low = std::min(floor[i], watershed.elevation[i]);
      const float held = std::min(shifted, watershed.elevation[i] + wall * d);
      result[i] = -smooth_min(-held, -low, 0.5f + kRounding * std::min(d / fall_over, 1.0f));
    }
  });
  return result;
}

}  // namespace

Raster<float> combine_relief(const Raster<float>& fold_relief, const WatershedMap& watershed,
                             const Raster<std::uint8_t>& land,
                             const CombinationParameters& parameters, const Context& context) {
  check_parameters(parameters, "combination");
  const Grid& grid = land.grid();
  Raster<float> result = parameters.reconcile
                             ? reconcile(fold_relief, watershed, land, parameters, context)
                             : fold_relief;
  const float blend = float(parameters.blend_distance);
  parallel_rows(context, grid.ny, [&](int r) {
    for (std::size_t i = grid.index(r, 0), end = i + grid.nx; i < end; ++i) {
      const float t = std::min(watershed.river_distance[i] / blend, 1.0f);
      const float m = t * t * (3.0f - 2.0f * t);
      const float f = result[i], g = watershed.elevation[i];
      // Hillsides stop at the folds' height: else rims would stand along rivers through low land.
      const float side = parameters.reconcile ? smooth_min(g, f, 0.5f + kRounding * t) : g;
      result[i] = land[i] ? side * (1.0f - m) + f * m : 0.0f;
    }
  });
  return result;
}

const StageInfo& combination_stage() {
  static const StageInfo info{"combination",
                              "Combines folds and watershed map by the distance to rivers.",
                              "Michel, Emilien and Cani 2015, section 6 and section 7's limits",
                              {"fold_relief", "watershed_elevation", "river_distance", "land"},
                              {"combined_relief"}};
  return info;
}

}  // namespace orogen
