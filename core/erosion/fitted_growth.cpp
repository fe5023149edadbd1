#include "erosion/fitted_growth.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "erosion/hillslope.h"
#include "erosion/levels.h"
#include "erosion/slope_limit.h"
#include "erosion/stream_power.h"
#include "foundation/parallel.h"
#include "foundation/resample.h"
#include "foundation/units.h"
#include "hydrology/base_level.h"
#include "hydrology/drainage.h"

namespace orogen {

namespace {

constexpr std::size_t kGrain = 16384;
constexpr double kFirstSlope = 0.5, kFirstArea = 1e6;  // m², of the first guess of uplift
constexpr double kSteepestUplift = 1.3;                // over that of hillslopes at talus
constexpr float kLeastShare = 0.05f, kMostShare = 4.0f;
constexpr double kLeastCreep = 0.35;  // in cells: less would leave the grid's directions

/// One resolution of the growth.
class FitLevel {
 public:
  FitLevel(Raster<std::uint8_t> land, Raster<float> given, Raster<float> erodibility,
           const FittedGrowthParameters& parameters, Context& context)
      : parameters_(parameters),
        context_(context),
        grid_(land.grid()),
        land_(std::move(land)),
        base_(grid_),
        given_(std::move(given)),
        erodibility_(std::move(erodibility)),
        most_uplift_(grid_),
        power_({.area_exponent = parameters.area_exponent}) {
    for (std::size_t i = 0; i < base_.size(); ++i) base_[i] = !land_[i];
    open_sides(base_);
    for (std::size_t i = 0; i < given_.size(); ++i)
      given_[i] = land_[i] ? std::max(given_[i], 0.0f) : 0.0f;
    flow_.emplace(base_);
    aim_ = smooth(given_, parameters.fit_radius);
    slack_ = std::max(1.0f, 0.01f * *std::ranges::max_element(aim_.values()));
    const double steepest = kSteepestUplift * talus_slope() *
                            std::pow(parameters.hillslope_area, parameters.area_exponent);
    for (std::size_t i = 0; i < most_uplift_.size(); ++i)
      most_uplift_[i] = float(steepest * erodibility_[i]);
  }

  void start() {
    elevation_ = smooth(given_, parameters_.drainage_radius);
    hold_base_level();
    uplift_ = Raster<float>(grid_);
    double sum = 0.0, count = 0.0;
    for (std::size_t i = 0; i < aim_.size(); ++i)
      if (land_[i]) sum += aim_[i], ++count;
    const float mean = float(std::max(sum / std::max(count, 1.0), 1.0));
    const double rate = kFirstSlope * std::pow(kFirstArea, parameters_.area_exponent);
    for (std::size_t i = 0; i < uplift_.size(); ++i)
      uplift_[i] =
          float(rate) * erodibility_[i] * std::clamp(aim_[i] / mean, kLeastShare, kMostShare);
  }

  void start_from(const FitLevel& coarser) {
    elevation_ = resample_bilinear(coarser.elevation_, grid_, context_);
    uplift_ = resample_bilinear(coarser.uplift_, grid_, context_);
    hold_base_level();
  }

  /// One step to the steady state of the present drainage; `fit` then corrects the uplift.
  void step(bool fit) {
    flow_->route(elevation_, context_);
    accumulate_drainage_area(*flow_, area_, context_);
    std::vector<double> channel_area = area_;
    for (double& area : channel_area) area += parameters_.hillslope_area;
    StreamPowerForcing forcing;
    forcing.uplift_rate = uplift_;
    forcing.erodibility = erodibility_;
    forcing.talus_slope = talus_slope();
    power_.solve(*flow_, channel_area, elevation_, forcing, std::numeric_limits<double>::infinity(),
                 context_);
    limit_slope(elevation_, base_, Raster<float>(grid_, std::numeric_limits<float>::lowest()),
                talus_slope(), context_);
    if (fit) fit_to_aim();
  }

  /// The ground with crests rounded, and what it stands for.
  FittedGrowth finish() {
    const double rounded = std::max(parameters_.creep_length, kLeastCreep * grid_.cell_size);
    creep(elevation_, base_, {.diffusivity = 1.0}, 0.5 * rounded * rounded, context_);
    flow_->route(elevation_, context_);
    return {elevation_, uplift_, drainage_area(*flow_, context_)};
  }

 private:
  double talus_slope() const { return std::tan(radians(parameters_.talus_angle_deg)); }

  void hold_base_level() {
    for (std::size_t i = 0; i < elevation_.size(); ++i)
      if (base_[i]) elevation_[i] = given_[i];
  }

  Raster<float> smooth(const Raster<float>& field, double sigma) const {
    return blur_over_land(field, land_, blurred_land(land_, sigma, context_), sigma, context_);
  }

  void fit_to_aim() {
    const Raster<float> smoothed = smooth(elevation_, parameters_.fit_radius);
    const float rate = float(parameters_.fit_rate);
    parallel_chunks(context_, uplift_.size(), kGrain, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        if (!land_[i]) continue;
        const float ratio = std::clamp((aim_[i] + slack_) / (smoothed[i] + slack_), 0.5f, 2.0f);
        uplift_[i] = std::min(uplift_[i] * std::pow(ratio, rate), most_uplift_[i]);
      }
    });
  }

  const FittedGrowthParameters& parameters_;
  Context& context_;
  Grid grid_;
  Raster<std::uint8_t> land_, base_;
  Raster<float> given_, erodibility_, most_uplift_, aim_, elevation_, uplift_;
  std::vector<double> area_;
  std::optional<FlowGraph> flow_;
  StreamPower power_;
  float slack_ = 1.0f;  // ε, m
};

int steps_of(std::size_t level, std::size_t count, const FittedGrowthParameters& p) {
  if (level + 1 == count) return p.finest_steps;
  return level == 0 ? p.coarse_steps : p.middle_steps;
}

}  // namespace

FittedGrowth grow_towards(const Raster<float>& given, const Raster<std::int32_t>& land,
                          const Raster<float>& erodibility,
                          const FittedGrowthParameters& parameters, Context& context) {
  check_parameters(parameters);
  const Grid& finest = land.grid();
  if (given.grid() != finest || erodibility.grid() != finest)
    throw InputError("land: must lie on the same grid as the heights and the erodibility");
  Raster<std::uint8_t> mask(finest);
  for (std::size_t i = 0; i < mask.size(); ++i) mask[i] = land[i] != 0;
  const std::vector<Grid> grids = level_grids(finest, parameters.coarsest_cells);
  double all = 0.0, done = 0.0;
  for (std::size_t k = 0; k < grids.size(); ++k)
    all += double(grids[k].size()) * steps_of(k, grids.size(), parameters);
  std::optional<FitLevel> level;
  for (std::size_t k = 0; k < grids.size(); ++k) {
    const Grid& grid = grids[k];
    FitLevel next(grid == finest ? mask : resample_nearest(mask, grid, context),
                  grid == finest ? given : resample_mean(given, grid, context),
                  grid == finest ? erodibility : resample_mean(erodibility, grid, context),
                  parameters, context);
    if (level)
      next.start_from(*level);
    else
      next.start();
    level.emplace(std::move(next));
    const int steps = steps_of(k, grids.size(), parameters);
    for (int s = 0; s < steps; ++s) {
      context.report(done / all);
      level->step(s + 1 < steps);
      done += double(grid.size());
    }
  }
  FittedGrowth made = level->finish();
  for (std::size_t i = 0; i < made.elevation.size(); ++i)
    if (!mask[i]) made.elevation[i] = given[i];
  return made;
}

}  // namespace orogen
