#include "erosion/relief_growth.h"

#include <cmath>
#include <memory>
#include <vector>

#include "erosion/growth_level.h"
#include "erosion/hillslope.h"
#include "erosion/levels.h"
#include "foundation/gaussian_blur.h"
#include "foundation/parallel.h"
#include "foundation/resample.h"
#include "hydrology/regional_height.h"
#include "inputs/map_rasters.h"

namespace orogen {

namespace {

constexpr float kFormShare = 0.3f;  // how much the forms of the combined relief may change the aim
constexpr float kLeastRelief = 50.0f;  // m
constexpr double kWidestForm = 3.0;    // of the combined relief, over the fit radius
constexpr double kNarrowestFold = 300.0, kWidestFold = 3500.0, kFoldsAround = 6000.0;  // m
constexpr float kLeastFold = 5.0f;                                                     // m
constexpr double kLeastCreep = 0.35;  // in cells: less would leave the grid's directions
constexpr double kBeltCells = 2.0;    // half width of river belts, in cells of the coarsest level

/// The regional height, and on it the folds, rifts and cones of the combined relief: what of them
/// is wider than the fit can follow and narrower than ranges.
Raster<float> aim_of_growth(const VectorMap& map, const Raster<float>& combined_relief,
                            const Raster<std::uint8_t>& mask, const RiverBeds& beds, double radius,
                            Context& context) {
  const Grid& grid = mask.grid();
  Raster<float> aim = regional_height(map, mask, beds, context);
  const Raster<float> relief = resample_mean(combined_relief, grid, context);
  const Raster<float> narrow = gaussian_blur(relief, 0.5 * radius, context);
  const Raster<float> wide = gaussian_blur(relief, kWidestForm * radius, context);
  for (std::size_t i = 0; i < aim.size(); ++i)
    if (mask[i]) {
      const float form = (narrow[i] - wide[i]) / std::max(wide[i], kLeastRelief);
      aim[i] *= 1.0f + kFormShare * std::tanh(form);
    }
  return aim;
}

/// What of the combined relief is about as wide as a fold, over its standard deviation around.
Raster<float> folds_of(const Raster<float>& combined_relief, Context& context) {
  Raster<float> folds = gaussian_blur(combined_relief, kNarrowestFold, context);
  const Raster<float> wide = gaussian_blur(combined_relief, kWidestFold, context);
  Raster<float> square(folds.grid());
  for (std::size_t i = 0; i < folds.size(); ++i) {
    folds[i] -= wide[i];
    square[i] = folds[i] * folds[i];
  }
  square = gaussian_blur(square, kFoldsAround, context);
  for (std::size_t i = 0; i < folds.size(); ++i)
    folds[i] =
        2.0f * std::tanh(0.5f * folds[i] / (std::sqrt(std::max(square[i], 0.0f)) + kLeastFold));
  return folds;
}

struct DrawnGround {
  Raster<std::uint8_t> land;
  RiverBeds beds;
};

struct Schedule {
  std::vector<int> steps;   // of each level
  std::vector<double> end;  // share of the whole work done after each level
};

Schedule schedule_of(const std::vector<Grid>& grids, const ReliefGrowthParameters& p) {
  Schedule schedule;
  double sum = 0.0;
  for (std::size_t k = 0; k < grids.size(); ++k) {
    const bool finest = k + 1 == grids.size();
    schedule.steps.push_back(finest ? p.finest_steps : k == 0 ? p.coarse_steps : p.middle_steps);
    sum += double(grids[k].size()) * schedule.steps.back();
    schedule.end.push_back(sum);
  }
  for (double& end : schedule.end) end /= sum;
  return schedule;
}

}  // namespace

ReliefGrowth grow_relief(const VectorMap& map, const Raster<float>& combined_relief,
                         const Raster<std::uint8_t>& land, const RiverBeds& beds,
                         const ReliefGrowthParameters& parameters, std::uint32_t seed,
                         Context& context, const ReliefGrowthFactors& factors) {
  check_parameters(parameters);
  if (combined_relief.grid() != land.grid())
    throw InputError("land: must lie on the same grid as combined_relief");
  const auto grids = level_grids(land.grid(), parameters.coarsest_cells);
  const Schedule schedule = schedule_of(grids, parameters);
  std::vector<DrawnGround> drawn;  // on each grid
  for (const Grid& grid : grids)
    if (grid == land.grid()) {
      drawn.push_back({land, beds});
    } else {
      const Raster<std::uint8_t> mask = land_mask(map, grid, context);
      drawn.push_back(
          {mask, lay_river_beds(map, mask, beds.wander, beds.wander_wavelength, beds.seed)});
    }
  Raster<float> aim = aim_of_growth(map, combined_relief, drawn.front().land, drawn.front().beds,
                                    parameters.fit_radius, context);
  multiply(aim, factors.aim, context);
  const Raster<float> folds = folds_of(combined_relief, context);
  std::unique_ptr<GrowthLevel> level;
  for (std::size_t k = 0; k < grids.size(); ++k) {
    const bool finest = k + 1 == grids.size();
    auto next = std::make_unique<GrowthLevel>(
        map, std::move(drawn[k].land), std::move(drawn[k].beds),
        resample_bilinear(aim, grids[k], context),
        finest ? folds : resample_mean(folds, grids[k], context), parameters, seed, context);
    next->multiply_erodibility(factors.erodibility);
    if (level)
      next->start_from(*level);
    else
      next->start(seed);
    if (k == 0) next->add_river_belts(kBeltCells * grids[k].cell_size);
    level = std::move(next);
    const double begin = k ? schedule.end[k - 1] : 0.0;
    for (int s = 0; s < schedule.steps[k]; ++s) {
      context.report(begin + (schedule.end[k] - begin) * s / schedule.steps[k]);
      level->step(s + 1 < schedule.steps[k]);
    }
  }
  Raster<float> area(land.grid());
  for (std::size_t i = 0; i < area.size(); ++i) area[i] = float(level->drainage_area()[i]);
  Raster<float> elevation = level->elevation();
  const double rounded =
      std::max(parameters.creep_length, kLeastCreep * elevation.grid().cell_size);
  creep(elevation, level->base_cells(), {.diffusivity = 1.0}, 0.5 * rounded * rounded, context);
  return {std::move(elevation), level->uplift_rate(), level->erodibility(), std::move(area)};
}

}  // namespace orogen
